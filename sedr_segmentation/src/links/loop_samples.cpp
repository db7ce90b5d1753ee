// SPDX-License-Identifier: BSD-3-Clause
#include "wall_stretch.h"

#include "../loop/loop_fit.h"
#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/middle_value.h"
#include "sedr_filters/src/base/parallel_for.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief Sets the support of samples relative to the median; too few points give none.
 */
void
judgeSupport(const Priors& priors, std::vector<ContourSample>& samples)
{
  const auto min_points = static_cast<std::size_t>(priors.min_evidence);
  std::vector<double> found;
  for (const ContourSample& sample : samples)
    if (sample.points >= min_points)
      found.push_back(static_cast<double>(sample.points));
  if (found.empty())
    return;
  const double median = middleValue(found);
  for (ContourSample& sample : samples) {
    const double share = static_cast<double>(sample.points) / median;
    if (sample.points >= min_points && share >= priors.share_little)
      sample.support = std::min(1.0, share);
  }
}

/** @brief Removes the support of sequences of samples too short for a wall. */
void
dropShortSupport(std::size_t min_samples, std::vector<ContourSample>& samples)
{
  const std::size_t n = samples.size();
  std::size_t start = 0;
  while (start < n && samples[start].isSupported())
    ++start;
  for (std::size_t k = 0, length = 0; start < n && k <= n; ++k) {
    const std::size_t i = (start + k) % n;
    if (k < n && samples[i].isSupported()) {
      ++length;
      continue;
    }
    for (; length > 0 && length < min_samples; --length)
      samples[(i + n - length) % n].support = 0;
    length = 0;
  }
}

} // namespace

std::vector<ContourSample>
sampleContour(const Contour& contour,
              const PlanPoints& evidence,
              const LoopParameters& parameters)
{
  const std::size_t n = contour.size();
  const auto corner = [&](std::size_t i) { return contour[i % n]; };
  const auto tangent_reach = static_cast<std::size_t>(parameters.priors.blur);
  const std::size_t reach = std::max<std::size_t>(1, std::min(tangent_reach, n / 8));
  const double edge = n > 1 ? (contour[1] - contour[0]).norm() : 0;

  std::vector<ContourSample> samples(n);
  std::vector<Eigen::Vector2d> walls(n);
  const auto takeSample = [&](std::size_t i) {
    ContourSample& sample = samples[i];
    // The staircase of cells is smoothed first.
    sample.place.setZero();
    for (std::size_t k = 0; k < 4; ++k)
      sample.place += corner(i + n - 1 + k) / 4;
    sample.position = sample.place;
    const Eigen::Vector2d way = corner(i + 1 + reach) - corner(i + n - reach);
    sample.tangent = way.norm() > 0
                         ? Eigen::Vector2d(way.normalized())
                         : Eigen::Vector2d((corner(i + 1) - corner(i)).normalized());
    const WallStretch wall =
        wallAcross(evidence, sample.place, sample.tangent, parameters);
    sample.points = wall.count;
    sample.deviation = wall.deviation;
    walls[i] = sample.place + wall.offset * leftOf(sample.tangent);
  };
  parallelFor(n, samples_a_block, parameters.threads,
              [&](std::size_t i) { takeSample(i); });
  judgeSupport(parameters.priors, samples);
  if (edge > 0)
    dropShortSupport(static_cast<std::size_t>(parameters.minimum_length / edge + 0.5),
                     samples);
  for (std::size_t i = 0; i < n; ++i)
    if (samples[i].isSupported())
      samples[i].position = walls[i];
  return samples;
}

double
sampleTolerance(const std::vector<ContourSample>& samples,
                const LoopParameters& parameters)
{
  const std::size_t n = samples.size();
  std::vector<double> deviations;
  for (std::size_t i = 0; n >= 5 && i < n; ++i) {
    const Eigen::Vector2d a = samples[(i + n - 2) % n].position;
    const Eigen::Vector2d b = samples[(i + 2) % n].position;
    const Eigen::Vector2d way = b - a;
    const Eigen::Vector2d d = samples[i].position - a;
    if (way.norm() > 0)
      deviations.push_back(std::abs(way.x() * d.y() - way.y() * d.x()) / way.norm());
  }
  std::vector<double> of_points;
  for (const ContourSample& sample : samples)
    if (sample.isSupported())
      of_points.push_back(sample.deviation);
  if (deviations.empty())
    return parameters.tolerance;
  // The deviation from the midpoint of two neighbours has 1.5 times the variance of a
  // sample.
  const double noise = 1.4826 * middleValue(deviations) / std::sqrt(1.5);
  const Priors& priors = parameters.priors;
  // For a contour without points, it is the staircase of its cells.
  const double of_wall =
      of_points.empty() ? parameters.tolerance : priors.sigmas * middleValue(of_points);
  const double least =
      std::max(priors.unevenness, std::min(of_wall, parameters.tolerance / 2));
  return std::clamp(priors.correlated_sigmas * noise, least, parameters.tolerance);
}

} // namespace pcl::sedr
