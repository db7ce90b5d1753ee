// SPDX-License-Identifier: BSD-3-Clause
#include "refit_sums.h"
#include "weighted_values.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief Weight of a patch at the top of a wall, relative to others. */
constexpr double top_weight = 3;

/** @brief Minimum standard deviation of a patch mean, as walls are not plane, metres.
 */
constexpr double min_patch_deviation = 0.0003;

/** @brief Minimum limit of the scatter within a patch of one surface, metres. */
constexpr double min_scatter = 0.002;

double
biweight(double share)
{
  return std::abs(share) < 1 ? std::pow(1 - share * share, 2) : 0;
}

/** @brief The patches of a surface with enough points. */
class PatchSolver {
public:
  PatchSolver(std::vector<const PatchSums*> patches,
              const std::vector<bool>& is_top,
              double noise)
      : patches_(std::move(patches))
      , weight_(patches_.size(), 1)
  {
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      // A patch near the scanner has a hundred times as many points as a distant one.
      vote_.push_back(std::sqrt(patches_[i]->count) * (is_top[i] ? top_weight : 1));
      variance_.push_back(varianceWithin(*patches_[i]));
    }
    usual_variance_ = usualVariance(noise);
    for (const PatchSums* patch : patches_)
      deviation_.push_back(
          std::hypot(std::sqrt(usual_variance_ / patch->count), min_patch_deviation));
  }

  PatchFit run(Eigen::Index parameters)
  {
    constexpr int max_rounds = 12;
    constexpr double settled = 1e-7; // metres, radians
    std::vector<Weighted> means;
    for (std::size_t i = 0; i < patches_.size(); ++i)
      means.push_back({patches_[i]->mean(), vote_[i]});
    PatchFit fit;
    fit.step[0] = shortestHalf(std::move(means)).middle;
    for (int round = 0; round < max_rounds; ++round) {
      weigh(fit.step, round == 0);
      const Eigen::Vector3d before = fit.step;
      if (!solve(parameters, fit.step))
        return {};
      if ((fit.step - before).cwiseAbs().maxCoeff() < settled)
        break;
    }
    judge(fit);
    return fit;
  }

private:
  static double varianceWithin(const PatchSums& p)
  {
    return std::max(0.0, p.squares - p.count * p.mean() * p.mean()) /
           std::max(1.0, p.count - 1);
  }

  /** @brief Returns the median variance within the patches with enough points. */
  double usualVariance(double noise) const
  {
    constexpr double min_points = 4;
    std::vector<Weighted> variances{{noise * noise, 1}};
    for (std::size_t i = 0; i < patches_.size(); ++i)
      if (patches_[i]->count >= min_points)
        variances.push_back({variance_[i], vote_[i]});
    return medianOf(std::move(variances));
  }

  /** @brief Returns whether a patch contains another surface as well, such as a door
   * reveal, by its larger scatter. */
  bool isMixed(std::size_t i) const
  {
    constexpr double min_points = 8;
    constexpr double max_scatter = 1.4;
    const double scatter =
        std::max(min_scatter, max_scatter * std::sqrt(usual_variance_));
    return patches_[i]->count >= min_points && variance_[i] > scatter * scatter;
  }

  /** @brief Weighs the patches by their residuals after a step, relative to their
   * noise, or to the median residual at the start. */
  void weigh(const Eigen::Vector3d& step, bool is_start)
  {
    constexpr double sigmas = 4;
    std::vector<double> residuals;
    std::vector<Weighted> sizes;
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      const PatchSums& p = *patches_[i];
      residuals.push_back((p.mean() - p.rows.dot(step) / p.count) / deviation_[i]);
      sizes.push_back({std::abs(residuals[i]), vote_[i]});
    }
    const double scale =
        is_start ? std::max(1.0, 1.4826 * medianOf(std::move(sizes))) : 1;
    for (std::size_t i = 0; i < patches_.size(); ++i)
      weight_[i] = isMixed(i) ? 0 : biweight(residuals[i] / (sigmas * scale));
  }

  bool solve(Eigen::Index parameters, Eigen::Vector3d& step) const
  {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      const PatchSums& p = *patches_[i];
      const Eigen::Vector3d row = p.rows / p.count;
      const double weight = weight_[i] * p.count;
      normal.noalias() += weight * row * row.transpose();
      right += weight * p.mean() * row;
    }
    if (!(normal(0, 0) > 0))
      return false;
    Eigen::Vector3d solved = Eigen::Vector3d::Zero();
    solved.head(parameters) = normal.topLeftCorner(parameters, parameters)
                                  .ldlt()
                                  .solve(right.head(parameters));
    if (!solved.allFinite())
      return false;
    step = solved;
    return true;
  }

  void judge(PatchFit& fit) const
  {
    double squares = 0;
    double freedom = 0;
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      if (weight_[i] < 0.25)
        continue;
      fit.count += patches_[i]->count;
      squares += variance_[i] * (patches_[i]->count - 1);
      freedom += patches_[i]->count - 1;
    }
    fit.deviation = freedom > 0 ? std::sqrt(squares / freedom) : 0;
  }

  std::vector<const PatchSums*> patches_;
  std::vector<double> weight_;
  std::vector<double> vote_;
  std::vector<double> variance_;  ///< within each patch
  std::vector<double> deviation_; ///< of the mean of each patch, metres
  double usual_variance_ = 0;
};

} // namespace

PatchFit
fitPatches(const std::vector<PatchSums>& patches,
           const std::vector<bool>& is_top,
           Eigen::Index parameters,
           double noise)
{
  // At an opening of a wall, a few points of other objects are seen.
  constexpr double min_share = 0.05;
  std::vector<Weighted> counts;
  for (const PatchSums& patch : patches)
    if (patch.count > 0)
      counts.push_back({patch.count, std::sqrt(patch.count)});
  const double min_points = std::max(1.0, min_share * medianOf(std::move(counts)));
  std::vector<const PatchSums*> own;
  std::vector<bool> tops;
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (patches[p].count >= min_points) {
      own.push_back(&patches[p]);
      tops.push_back(is_top[p]);
    }
  if (own.empty())
    return {};
  return PatchSolver(std::move(own), tops, noise).run(parameters);
}

} // namespace pcl::sedr
