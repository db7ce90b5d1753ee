// SPDX-License-Identifier: BSD-3-Clause
#include "refit_sums.h"
#include "weighted_values.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace pcl {
namespace sedr {

namespace {

/** @brief How much more a patch at the top of a wall counts for where the wall is. */
constexpr double top_weight = 3;

/** @brief What the mean of a patch is not known better than: no wall is quite plane,
 * metres. */
constexpr double least_patch_deviation = 0.0003;

/** @brief Scatter of the points of any patch that shows one surface, metres. */
constexpr double least_scatter = 0.002;

double
biweight(double share)
{
  return std::abs(share) < 1 ? std::pow(1 - share * share, 2) : 0;
}

/** @brief The patches of one surface that hold enough points. */
class PatchSolver {
public:
  PatchSolver(std::vector<const PatchSums*> patches,
              std::vector<bool> is_top,
              double noise,
              double beyond)
      : patches_(std::move(patches))
      , is_top_(std::move(is_top))
      , weight_(patches_.size(), 1)
      , noise_(noise)
      , usual_variance_(usualVariance())
      , most_beyond_(std::max(beyond, usualBeyond()) + strays)
  {
    constexpr double unevenness = 0.001; // of walls, metres
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      mean_.push_back(patches_[i]->mean());
      own_variance_.push_back(ownVariance(i));
      vote_.push_back(voteOf(i));
      all_votes_ += vote_[i];
      deviation_.push_back(deviationOf(i));
      spread_.push_back(std::hypot(deviation_[i], unevenness));
    }
  }

  PatchFit run(Eigen::Index parameters)
  {
    constexpr int most_rounds = 12;
    constexpr double settled = 1e-7; // metres, radians
    PatchFit fit;
    fit.step = start(parameters);
    for (int round = 0; round < most_rounds; ++round) {
      weigh(fit.step);
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
  /** @brief Where most patches are: the best of some steps through as many of them as
   * are needed, as what is turned or bent against the wall crosses it in few (Fischler
   * and Bolles 1981). */
  Eigen::Vector3d start(Eigen::Index parameters)
  {
    constexpr std::size_t tries = 60;
    std::vector<Weighted> means;
    for (std::size_t i = 0; i < patches_.size(); ++i)
      means.push_back({patches_[i]->mean(), vote_[i]});
    Eigen::Vector3d best(shortestHalf(std::move(means)).middle, 0, 0);
    double most = agreement(best, 0);
    std::mt19937_64 random(1);
    for (std::size_t k = 0; parameters > 1 && k < tries; ++k) {
      std::fill(weight_.begin(), weight_.end(), k == 0 ? 1.0 : 0.0);
      for (Eigen::Index n = 0; k > 0 && n < parameters; ++n)
        weight_[random() % weight_.size()] = 1;
      Eigen::Vector3d step;
      if (!solve(parameters, step))
        continue;
      const double agreed = agreement(step, most);
      if (agreed <= most)
        continue;
      most = agreed;
      best = step;
    }
    std::fill(weight_.begin(), weight_.end(), 1);
    return best;
  }

  /** @brief How many patches a step explains, counted no farther than until they cannot
   * be more than `enough`. */
  double agreement(const Eigen::Vector3d& step, double enough) const
  {
    constexpr double sigmas = 4;
    double sum = 0;
    double left = all_votes_;
    for (std::size_t i = 0; i < patches_.size() && sum + left > enough; ++i) {
      sum += vote_[i] * biweight(residual(i, step) / (sigmas * spread_[i]));
      left -= vote_[i];
    }
    return sum;
  }

  double voteOf(std::size_t i) const
  {
    // A patch near the scanner holds a hundred times as many points as a far one.
    return std::sqrt(patches_[i]->count) * (is_top_[i] ? top_weight : 1);
  }

  /** @brief Mean distance that a step leaves of a patch. */
  double residual(std::size_t i, const Eigen::Vector3d& step) const
  {
    const PatchSums& p = *patches_[i];
    return mean_[i] - p.rows.dot(step) / p.count;
  }

  /** @brief Variance of the points within a patch, as these say. */
  double ownVariance(std::size_t i) const
  {
    const PatchSums& p = *patches_[i];
    return std::max(0.0, p.squares - p.count * p.mean() * p.mean()) /
           std::max(1.0, p.count - 1);
  }

  /** @brief Variance within most of the patches that tell any. */
  double usualVariance() const
  {
    constexpr double least_points = 4;
    std::vector<Weighted> variances{{noise_ * noise_, 1}};
    for (std::size_t i = 0; i < patches_.size(); ++i)
      if (patches_[i]->count >= least_points)
        variances.push_back({ownVariance(i), voteOf(i)});
    return medianOf(std::move(variances));
  }

  /** @brief How many points most of the patches have beyond the band, as a share of
   * those within: the noise of another surface reaches there along all of this one. */
  double usualBeyond() const
  {
    std::vector<Weighted> shares;
    for (std::size_t i = 0; i < patches_.size(); ++i)
      if (patches_[i]->count >= points_that_tell)
        shares.push_back({patches_[i]->beyond / patches_[i]->count, voteOf(i)});
    return medianOf(std::move(shares));
  }

  /** @brief Variance of the points within a patch: few say little of it, so that the
   * usual one counts with them. */
  double variance(std::size_t i) const
  {
    constexpr double points_of_usual = 20;
    const double own = patches_[i]->count - 1;
    return (points_of_usual * usual_variance_ + own * ownVariance(i)) /
           (points_of_usual + own);
  }

  /** @brief Whether a patch shows another surface too, such as the reveal of a door: it
   * scatters more than most, `scatter` squared, or goes on beyond the band. */
  bool isMixed(std::size_t i, double scatter) const
  {
    constexpr double sigmas = 1; // of what chance puts there (Poisson)
    const PatchSums& p = *patches_[i];
    const double beyond = most_beyond_ * p.count;
    return p.count >= points_that_tell &&
           (own_variance_[i] > scatter * scatter ||
            p.beyond > beyond + sigmas * std::sqrt(beyond));
  }

  /** @brief Weighs the patches by how far they are from where a step leads. */
  void weigh(const Eigen::Vector3d& step)
  {
    constexpr double sigmas = 4;
    constexpr double most_scatter = 1.4;
    std::vector<Weighted> scaled;
    for (std::size_t i = 0; i < patches_.size(); ++i)
      if (weight_[i] > 0)
        scaled.push_back({std::abs(residual(i, step)) / deviation_[i], vote_[i]});
    // Walls are less even than noise alone would make them.
    const double scale = std::max(1.0, 1.4826 * medianOf(std::move(scaled)));
    const double scatter =
        std::max(least_scatter, most_scatter * std::sqrt(usual_variance_));
    for (std::size_t i = 0; i < patches_.size(); ++i)
      weight_[i] = isMixed(i, scatter)
                       ? 0
                       : biweight(residual(i, step) / (sigmas * scale * deviation_[i]));
  }

  double deviationOf(std::size_t i) const
  {
    return std::hypot(std::sqrt(variance(i) / patches_[i]->count),
                      least_patch_deviation);
  }

  bool solve(Eigen::Index parameters, Eigen::Vector3d& step) const
  {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      if (weight_[i] == 0) // all but a few, of a try
        continue;
      const PatchSums& p = *patches_[i];
      const Eigen::Vector3d row = p.rows / p.count;
      const double weight = weight_[i] * std::min(p.count, most_points);
      normal.noalias() += weight * row * row.transpose();
      right += weight * mean_[i] * row;
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
    double all = 0;
    double squares = 0;
    double freedom = 0;
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      all += patches_[i]->count;
      if (weight_[i] < 0.25)
        continue;
      fit.count += patches_[i]->count;
      squares += own_variance_[i] * (patches_[i]->count - 1);
      freedom += patches_[i]->count - 1;
    }
    fit.share = all > 0 ? fit.count / all : 0;
    fit.deviation = freedom > 0 ? std::sqrt(squares / freedom) : 0;
  }

  /** @brief So many points tell whether a patch shows another surface too. */
  static constexpr double points_that_tell = 8;

  /** @brief More points beyond the band than usual are another surface's, as a share of
   * those within. */
  static constexpr double strays = 0.1;

  /** @brief A patch counts for no more points than this, however near the scanner. */
  static constexpr double most_points = 300;

  std::vector<const PatchSums*> patches_;
  std::vector<bool> is_top_;
  std::vector<double> weight_;
  double noise_;
  double usual_variance_;
  double most_beyond_;       ///< points of one surface beyond the band, see isMixed()
  std::vector<double> mean_; ///< distance of each patch, metres
  std::vector<double> own_variance_; ///< see ownVariance()
  std::vector<double> vote_;
  double all_votes_ = 0;
  std::vector<double> deviation_; ///< of the mean of each patch, metres
  std::vector<double> spread_;    ///< the same, of a wall that is not quite even
};

} // namespace

PatchFit
fitPatches(const std::vector<PatchSums>& patches,
           const std::vector<bool>& is_top,
           Eigen::Index parameters,
           double noise,
           double beyond)
{
  // Where a wall is open, a few points of something else are seen.
  constexpr double least_share = 0.05;
  std::vector<Weighted> counts;
  for (const PatchSums& patch : patches)
    if (patch.count > 0)
      counts.push_back({patch.count, std::sqrt(patch.count)});
  const double least_points = std::max(1.0, least_share * medianOf(std::move(counts)));
  std::vector<const PatchSums*> own;
  std::vector<bool> tops;
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (patches[p].count >= least_points) {
      own.push_back(&patches[p]);
      tops.push_back(is_top[p]);
    }
  if (own.empty())
    return {};
  return PatchSolver(std::move(own), std::move(tops), noise, beyond).run(parameters);
}

} // namespace sedr
} // namespace pcl
