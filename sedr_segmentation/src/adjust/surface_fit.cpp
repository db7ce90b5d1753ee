// SPDX-License-Identifier: BSD-3-Clause
#include "surface_fit.h"

#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/quantiles.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

constexpr double quartile = 0.6745; ///< of the normal distribution

double
biweight(double share)
{
  const double rest = 1 - share * share;
  return rest > 0 ? rest * rest : 0;
}

/** @brief Returns the standard deviation of residuals, from the smallest quarter of
 * their magnitudes, as the others may be those of outliers. */
double
robustDeviation(std::vector<Weighted> magnitudes)
{
  constexpr double eighth = 0.3186; // of the normal distribution, from its middle
  return weightedQuantile(std::move(magnitudes), 0.25) / eighth;
}

/** @brief Finds the shortest interval with half of some sorted values (Rousseeuw 1984).
 */
void
shortestHalfOf(const std::vector<double>& sorted, double& middle, double& half_width)
{
  const std::size_t span = sorted.size() / 2;
  half_width = HUGE_VAL;
  for (std::size_t i = 0; i + span < sorted.size(); ++i)
    if (sorted[i + span] - sorted[i] < 2 * half_width) {
      half_width = (sorted[i + span] - sorted[i]) / 2;
      middle = (sorted[i + span] + sorted[i]) / 2;
    }
}

} // namespace

SurfaceFit::SurfaceFit(PlanUnknowns& unknowns,
                       const PatchPoints& points,
                       const AdjustmentParameters& parameters)
    : unknowns_(unknowns)
    , given_(unknowns.all)
    , points_(points)
    , parameters_(parameters)
    , patches_(unknowns.all.size())
{}

ScanErrors
SurfaceFit::run()
{
  const auto forAll = [&](void (SurfaceFit::*step)(std::size_t)) {
    parallelBlocks(unknowns_.all.size(), 1, parameters_.threads,
                   [&](std::size_t u, std::size_t) { (this->*step)(u); });
  };
  forAll(&SurfaceFit::start);
  estimateErrors();
  for (Unknown& u : unknowns_.all) // what is beside a surface is no noise of it
    u.noise = std::min(u.noise, errors_.noise);
  for (int round = 0; round < rounds; ++round) {
    forAll(&SurfaceFit::refine);
    estimateErrors();
  }
  chooseTilts();
  return errors_;
}

/** @brief Moves a surface to the mode of its patches' modes. The range within which
 * patches count shrinks (graduated non-convexity, Blake and Zisserman 1987), so a wall
 * is found among the boards and cupboards before it. */
void
SurfaceFit::start(std::size_t number)
{
  constexpr double top_vote = 3;
  constexpr double shrink = 0.7;
  Unknown& u = unknowns_.all[number];
  std::vector<PatchMean> patches;
  std::vector<Weighted> deviations;
  std::vector<double> distances;
  const auto [first, last] = points_.patchesOf(number);
  for (std::size_t p = first; p < last; ++p) {
    PatchMean patch;
    distances.clear();
    for (const Eigen::Vector3f* at = points_.begin(p); at != points_.end(p); ++at) {
      distances.push_back(u.distance(at->cast<double>()));
      patch.at += at->cast<double>();
    }
    patch.count = static_cast<double>(distances.size());
    if (distances.size() < 3)
      continue;
    std::sort(distances.begin(), distances.end());
    double half = 0;
    shortestHalfOf(distances, patch.distance, half);
    patch.at /= patch.count;
    patch.row = u.row(patch.at);
    patch.vote = std::sqrt(patch.count) * (points_.isTop(p) ? top_vote : 1) *
                 std::exp(-std::pow(patch.distance / parameters_.coarse, 2) / 2);
    deviations.emplace_back(half / quartile, patch.vote);
    u.count += patch.count;
    patches.push_back(patch);
  }
  if (u.count < parameters_.min_points) {
    u.count = 0;
    return;
  }
  u.noise =
      std::max(parameters_.accuracy, weightedQuantile(std::move(deviations), 0.5));
  Eigen::Vector3d step = Eigen::Vector3d::Zero();
  std::vector<double> weights;
  const double least = u.noise + parameters_.outlier_sigmas * parameters_.accuracy;
  for (double range = 2 * parameters_.reach; range > least; range *= shrink) {
    weights.clear();
    for (const PatchMean& patch : patches)
      weights.push_back(patch.vote *
                        biweight((patch.distance - patch.row.dot(step)) / range) /
                        (least * least));
    if (!solve(patches, weights, unknowns_.prior(u), step))
      return;
  }
  std::vector<Weighted> residuals;
  for (const PatchMean& patch : patches)
    residuals.emplace_back(std::abs(patch.distance - patch.row.dot(step)), patch.vote);
  u.spread = robustDeviation(std::move(residuals));
  u.move(step);
}

bool
SurfaceFit::solve(const std::vector<PatchMean>& patches,
                  const std::vector<double>& weights,
                  const Eigen::Matrix3d& prior,
                  Eigen::Vector3d& step) const
{
  Eigen::Matrix3d normal = prior;
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const Eigen::Vector3d weighted = weights[i] * patches[i].row;
    normal.noalias() += weighted * patches[i].row.transpose();
    right += patches[i].distance * weighted;
  }
  const Eigen::Vector3d solved = normal.ldlt().solve(right);
  if (!solved.allFinite())
    return false;
  step = solved;
  return true;
}

/** @brief Checks whether the points of a patch are those of one surface: few of them
 * beside it, and no more scattered than usual. */
bool
SurfaceFit::isOfOneSurface(const PatchMean& patch,
                           double usual_mixed,
                           double variance) const
{
  constexpr double max_variance = 2; // of a patch, in usual ones
  constexpr double min_count = 8;    // for a variance
  return patch.mixed <= std::max(parameters_.max_mixed, usual_mixed) &&
         (patch.count < min_count ||
          patch.variance <=
              max_variance * variance + std::pow(parameters_.accuracy, 2));
}

/** @brief Returns the standard deviation of the mean of a patch. */
double
SurfaceFit::deviationOf(const PatchMean& patch, double variance) const
{
  const double shared = 2 * M_PI * std::pow(errors_.correlation / parameters_.patch, 2);
  return std::sqrt(variance / patch.count + std::pow(parameters_.accuracy, 2) +
                   std::max(1.0, shared) * std::pow(errors_.waviness, 2));
}

/** @brief Averages the points near a surface by patches and fits it to them. */
void
SurfaceFit::refine(std::size_t number)
{
  constexpr int turns = 6;
  constexpr double min_band = 0.0015;
  constexpr double band_sigmas = 3;
  Unknown& u = unknowns_.all[number];
  if (!u.isSeen())
    return;
  const double band =
      std::min(parameters_.reach,
               std::max(min_band, band_sigmas * std::hypot(u.noise, u.spread)));
  std::vector<PatchMean>& patches = patches_[number];
  patches.clear();
  std::vector<Weighted> variances;
  std::vector<Weighted> shares;
  const auto [first, last] = points_.patchesOf(number);
  for (std::size_t p = first; p < last; ++p) {
    PatchMean patch;
    double squares = 0;
    double beside = 0;
    for (const Eigen::Vector3f* at = points_.begin(p); at != points_.end(p); ++at) {
      const Eigen::Vector3d point = at->cast<double>();
      const double d = u.distance(point);
      if (std::abs(d) > band) {
        beside += std::abs(d) < parameters_.reach ? 1 : 0;
        continue;
      }
      patch.count += 1;
      patch.distance += d;
      squares += d * d;
      patch.row += u.row(point);
      patch.at += point;
    }
    if (patch.count < 3)
      continue;
    patch.distance /= patch.count;
    patch.row /= patch.count;
    patch.at /= patch.count;
    patch.mixed = beside / (beside + patch.count);
    patch.variance =
        std::max(0.0, squares / patch.count - patch.distance * patch.distance) *
        patch.count / (patch.count - 1);
    const double vote = std::sqrt(patch.count);
    variances.emplace_back(patch.variance, vote);
    shares.emplace_back(patch.mixed, vote);
    patches.push_back(patch);
  }
  const double variance = weightedQuantile(std::move(variances), 0.5);
  const double usual_mixed = weightedQuantile(std::move(shares), 0.5);
  std::vector<double> weights(patches.size(), 0);
  Eigen::Vector3d step = Eigen::Vector3d::Zero();
  for (int turn = 0; turn < turns; ++turn) {
    std::vector<Weighted> sizes;
    for (const PatchMean& patch : patches)
      sizes.emplace_back(std::abs(patch.distance - patch.row.dot(step)) /
                             deviationOf(patch, variance),
                         std::sqrt(patch.count));
    const double scale = std::max(1.0, robustDeviation(std::move(sizes)));
    for (std::size_t i = 0; i < patches.size(); ++i) {
      PatchMean& patch = patches[i];
      const double deviation = scale * deviationOf(patch, variance);
      const double residual = patch.distance - patch.row.dot(step);
      patch.weight = isOfOneSurface(patch, usual_mixed, variance)
                         ? biweight(residual / (parameters_.outlier_sigmas * deviation))
                         : 0;
      weights[i] = patch.weight / (deviation * deviation);
    }
    if (!solve(patches, weights, unknowns_.prior(u), step))
      return;
  }
  u.information = unknowns_.prior(u);
  u.count = 0;
  std::vector<Weighted> residuals;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    PatchMean& patch = patches[i];
    patch.precision = weights[i];
    u.information += weights[i] * patch.row * patch.row.transpose();
    u.count += patch.weight > 0 ? patch.count : 0;
    patch.distance -= patch.row.dot(step);
    residuals.emplace_back(std::abs(patch.distance), std::sqrt(patch.count));
  }
  u.spread = robustDeviation(std::move(residuals));
  u.noise = std::sqrt(variance);
  u.move(step);
  if (u.count < parameters_.min_points)
    u.count = 0;
}

/** @brief Estimates the errors that all points of a patch share, from the residuals of
 * the patches, and their correlation from those of neighbours. */
void
SurfaceFit::estimateErrors()
{
  constexpr std::size_t min_patches = 12; // of a surface that shows its waves
  std::vector<Weighted> noises;
  std::vector<Weighted> waves;
  double shared = 0;
  double own = 0;
  for (std::size_t number = 0; number < patches_.size(); ++number) {
    const Unknown& u = unknowns_.all[number];
    if (!u.isSeen())
      continue;
    noises.emplace_back(u.noise, std::sqrt(u.count));
    std::vector<const PatchMean*> inliers;
    for (const PatchMean& patch : patches_[number])
      if (patch.weight > 0)
        inliers.push_back(&patch);
    if (inliers.size() < min_patches)
      continue;
    double squares = 0;
    const double variance = u.noise * u.noise;
    for (std::size_t i = 0; i < inliers.size(); ++i) {
      const PatchMean& a = *inliers[i];
      squares += a.distance * a.distance - variance / a.count;
      if (i + 1 == inliers.size())
        break;
      const PatchMean& b = *inliers[i + 1];
      if (std::abs((a.at - b.at).norm() / parameters_.patch - 1) > 0.5)
        continue;
      shared += a.distance * b.distance;
      own += (a.distance * a.distance + b.distance * b.distance - variance / a.count -
              variance / b.count) /
             2;
    }
    const auto count = static_cast<double>(inliers.size());
    waves.emplace_back(squares / (count - 3), count);
  }
  errors_.noise = weightedQuantile(std::move(noises), 0.5);
  errors_.waviness = std::sqrt(std::max(0.0, weightedQuantile(std::move(waves), 0.5)));
  errors_.correlation = 0;
  if (shared > 0 && own > 0 && errors_.waviness > 0)
    errors_.correlation =
        parameters_.patch / std::max(0.2, std::log(std::max(1.0, own / shared)));
}

} // namespace pcl::sedr
