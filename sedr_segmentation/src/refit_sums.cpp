// SPDX-License-Identifier: BSD-3-Clause
#include "refit_sums.h"

#include <pcl/sedr_filters/parallel.h>

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

/** @brief Width of a bin of distances, metres. */
constexpr double bin = 0.0005;

/** @brief A number that counts. */
struct Weighted {
  double value;
  double weight;

  bool operator<(const Weighted& other) const { return value < other.value; }
};

struct Interval {
  double middle = 0;
  double width = 0;
};

/** @brief The shortest interval that holds half of the weight. */
Interval
shortestHalf(std::vector<Weighted> values)
{
  std::sort(values.begin(), values.end());
  double all = 0;
  for (const auto& v : values)
    all += v.weight;
  Interval best;
  bool is_found = false;
  double sum = 0;
  for (std::size_t first = 0, last = 0; last < values.size(); ++last) {
    sum += values[last].weight;
    while (sum - values[first].weight >= all / 2)
      sum -= values[first++].weight;
    const double width = values[last].value - values[first].value;
    if (sum < all / 2 || (is_found && width >= best.width))
      continue;
    best = {(values[last].value + values[first].value) / 2, width};
    is_found = true;
  }
  return best;
}

/** @brief Adds up what `see(sums, number, patch, distance, row)` makes of all points,
 * in blocks whose number does not depend on that of the threads, so that neither does
 * the result. */
template <typename Sum, typename See>
std::vector<Sum>
overAll(const RawPoints& raw, const RefitTargets& targets, std::size_t size, See see)
{
  constexpr std::size_t most_blocks = 8;
  constexpr std::size_t least_block = std::size_t{1} << 16;
  const std::size_t n = raw.size();
  const std::size_t block = std::max(least_block, n / most_blocks + 1);
  std::vector<std::vector<Sum>> blocks((n + block - 1) / block);
  parallelBlocks(n, block, raw.threads, [&](std::size_t begin, std::size_t end) {
    std::vector<Sum> own(size);
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t i = raw.at(k);
      if (raw.points.isFinite(i))
        targets.visit(raw.points[i].cast<double>(),
                      [&](std::size_t t, std::size_t patch, double d,
                          const Eigen::Vector3d& row) { see(own, t, patch, d, row); });
    }
    blocks[begin / block] = std::move(own);
  });
  std::vector<Sum> sums(size);
  for (const auto& own : blocks)
    for (std::size_t i = 0; i < own.size(); ++i)
      sums[i] += own[i];
  return sums;
}

double
medianOf(std::vector<Weighted> values)
{
  std::sort(values.begin(), values.end());
  double all = 0;
  for (const auto& v : values)
    all += v.weight;
  double sum = 0;
  for (const auto& v : values) {
    sum += v.weight;
    if (2 * sum >= all)
      return v.value;
  }
  return 0;
}

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
              double noise)
      : patches_(std::move(patches))
      , is_top_(std::move(is_top))
      , weight_(patches_.size(), 1)
      , noise_(noise)
      , usual_variance_(usualVariance())
  {}

  PatchFit run(Eigen::Index parameters)
  {
    constexpr int rounds = 12;
    PatchFit fit;
    fit.step = start(parameters);
    for (int round = 0; round < rounds; ++round) {
      weigh(fit.step);
      if (!solve(parameters, fit.step))
        return {};
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
      means.push_back({patches_[i]->mean(), voteOf(i)});
    Eigen::Vector3d best(shortestHalf(std::move(means)).middle, 0, 0);
    double most = agreement(best);
    std::mt19937_64 random(1);
    for (std::size_t k = 0; parameters > 1 && k < tries; ++k) {
      std::fill(weight_.begin(), weight_.end(), k == 0 ? 1.0 : 0.0);
      for (Eigen::Index n = 0; k > 0 && n < parameters; ++n)
        weight_[random() % weight_.size()] = 1;
      Eigen::Vector3d step;
      if (!solve(parameters, step))
        continue;
      const double agreed = agreement(step);
      if (agreed <= most)
        continue;
      most = agreed;
      best = step;
    }
    std::fill(weight_.begin(), weight_.end(), 1);
    return best;
  }

  /** @brief How many patches a step explains. */
  double agreement(const Eigen::Vector3d& step) const
  {
    constexpr double sigmas = 4;
    constexpr double unevenness = 0.001; // of walls, metres
    double sum = 0;
    for (std::size_t i = 0; i < patches_.size(); ++i)
      sum += voteOf(i) * biweight(residual(i, step) /
                                  (sigmas * std::hypot(deviationOf(i), unevenness)));
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
    return p.mean() - p.rows.dot(step) / p.count;
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

  /** @brief Variance of the points within a patch: few say little of it, so that the
   * usual one counts with them. */
  double variance(std::size_t i) const
  {
    constexpr double points_of_usual = 20;
    const double own = patches_[i]->count - 1;
    return (points_of_usual * usual_variance_ + own * ownVariance(i)) /
           (points_of_usual + own);
  }

  /** @brief Weighs the patches by how far they are from where a step leads. A patch
   * that holds two surfaces scatters more than others. */
  void weigh(const Eigen::Vector3d& step)
  {
    constexpr double sigmas = 4;
    constexpr double most_scatter = 1.4;
    constexpr double least_points = 8; // that tell a scatter
    std::vector<Weighted> scaled;
    for (std::size_t i = 0; i < patches_.size(); ++i)
      if (weight_[i] > 0)
        scaled.push_back({std::abs(residual(i, step)) / deviationOf(i), voteOf(i)});
    // Walls are less even than noise alone would make them.
    const double scale = std::max(1.0, 1.4826 * medianOf(std::move(scaled)));
    const double scatter =
        std::max(least_scatter, most_scatter * std::sqrt(usual_variance_));
    for (std::size_t i = 0; i < patches_.size(); ++i)
      weight_[i] =
          patches_[i]->count >= least_points && ownVariance(i) > scatter * scatter
              ? 0
              : biweight(residual(i, step) / (sigmas * scale * deviationOf(i)));
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
      const PatchSums& p = *patches_[i];
      const Eigen::Vector3d row = p.rows / p.count;
      const double weight = weight_[i] * std::min(p.count, most_points);
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
    double all = 0;
    double squares = 0;
    double freedom = 0;
    for (std::size_t i = 0; i < patches_.size(); ++i) {
      all += patches_[i]->count;
      if (weight_[i] < 0.25)
        continue;
      fit.count += patches_[i]->count;
      squares += ownVariance(i) * (patches_[i]->count - 1);
      freedom += patches_[i]->count - 1;
    }
    fit.share = all > 0 ? fit.count / all : 0;
    fit.deviation = freedom > 0 ? std::sqrt(squares / freedom) : 0;
  }

  /** @brief A patch counts for no more points than this, however near the scanner. */
  static constexpr double most_points = 300;

  std::vector<const PatchSums*> patches_;
  std::vector<bool> is_top_;
  std::vector<double> weight_;
  double noise_;
  double usual_variance_;
};

} // namespace

void
PatchSums::add(double distance, const Eigen::Vector3d& row)
{
  count += 1;
  sum += distance;
  squares += distance * distance;
  rows += row;
}

PatchSums&
PatchSums::operator+=(const PatchSums& other)
{
  count += other.count;
  sum += other.sum;
  squares += other.squares;
  rows += other.rows;
  return *this;
}

std::vector<Scatter>
scatterOf(const RawPoints& raw, const RefitTargets& targets, double reach)
{
  const auto bins = static_cast<std::size_t>(std::ceil(2 * reach / bin)) + 1;
  const auto counts =
      overAll<std::uint32_t>(raw, targets, targets.size() * bins,
                             [&](std::vector<std::uint32_t>& own, std::size_t t,
                                 std::size_t, double d, const Eigen::Vector3d&) {
                               if (2 * std::abs(d) > targets.gap(t))
                                 return;
                               const auto at =
                                   static_cast<std::size_t>((d + reach) / bin);
                               ++own[t * bins + std::min(bins - 1, at)];
                             });
  std::vector<Scatter> scatters;
  for (std::size_t t = 0; t < targets.size(); ++t) {
    std::vector<Weighted> values;
    Scatter scatter;
    for (std::size_t i = 0; i < bins; ++i) {
      const auto count = static_cast<double>(counts[t * bins + i]);
      scatter.count += count;
      if (count > 0)
        values.push_back({(static_cast<double>(i) + 0.5) * bin - reach, count});
    }
    if (!values.empty()) {
      constexpr double quartile = 0.6745; // of the normal distribution
      const Interval half = shortestHalf(std::move(values));
      scatter.centre = half.middle;
      scatter.deviation = std::max(bin, half.width) / 2 / quartile;
    }
    scatters.push_back(scatter);
  }
  return scatters;
}

std::vector<PatchSums>
patchSums(const RawPoints& raw,
          const RefitTargets& targets,
          const std::vector<double>& centre,
          const std::vector<double>& band)
{
  return overAll<PatchSums>(raw, targets, targets.patchCount(),
                            [&](std::vector<PatchSums>& own, std::size_t t,
                                std::size_t patch, double d,
                                const Eigen::Vector3d& row) {
                              if (std::abs(d - centre[t]) <= band[t])
                                own[patch].add(d, row);
                            });
}

PatchFit
fitPatches(const std::vector<PatchSums>& patches,
           std::size_t first,
           std::size_t last,
           const std::vector<bool>& is_top,
           Eigen::Index parameters,
           double noise)
{
  // Where a wall is open, a few points of something else are seen.
  constexpr double least_share = 0.05;
  std::vector<Weighted> counts;
  for (std::size_t p = first; p < last; ++p)
    if (patches[p].count > 0)
      counts.push_back({patches[p].count, std::sqrt(patches[p].count)});
  const double least_points = std::max(1.0, least_share * medianOf(std::move(counts)));
  std::vector<const PatchSums*> own;
  std::vector<bool> tops;
  for (std::size_t p = first; p < last; ++p)
    if (patches[p].count >= least_points) {
      own.push_back(&patches[p]);
      tops.push_back(is_top[p - first]);
    }
  if (own.empty())
    return {};
  return PatchSolver(std::move(own), std::move(tops), noise).run(parameters);
}

} // namespace sedr
} // namespace pcl
