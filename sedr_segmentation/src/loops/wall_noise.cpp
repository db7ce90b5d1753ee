// SPDX-License-Identifier: BSD-3-Clause
#include "wall_noise.h"

#include "../curves/fitted_curve.h"
#include "sedr_filters/src/base/middle_value.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief Returns the deviations of anchors from the straight stretches on which they
 * lie, stretch by stretch; stretches that are not straight are left out. */
std::vector<std::vector<double>>
stretchDeviations(const std::vector<LoopContour>& contours, std::size_t length)
{
  constexpr double straight = 0.05; // metres: what is farther off is no noise
  constexpr double clearly_seen = 0.5;
  std::vector<std::vector<double>> all;
  for (const LoopContour& contour : contours)
    for (std::size_t s = 0; s + length < contour.samples.size(); s += length / 2) {
      std::vector<Eigen::Vector2d> anchors;
      for (std::size_t k = s; k < s + length; ++k)
        if (contour.samples[k].seen > clearly_seen)
          anchors.push_back(contour.samples[k].anchor);
      if (anchors.size() < length)
        continue;
      const PlanCurve line = fitCurve(false, anchors, straight / 4);
      std::vector<double> off;
      for (const Eigen::Vector2d& p : anchors)
        off.push_back(line.signedDistance(p));
      const auto isFar = [&](double d) { return std::abs(d) > straight; };
      if (std::none_of(off.begin(), off.end(), isFar))
        all.push_back(std::move(off));
    }
  return all;
}

/** @brief Returns the variance of deviations, and that over their correlation: the sum
 * of the autocovariance up to its first zero. */
std::pair<double, double>
variances(const std::vector<double>& off)
{
  const auto covariance = [&](std::size_t lag) {
    double sum = 0;
    for (std::size_t k = 0; k + lag < off.size(); ++k)
      sum += off[k] * off[k + lag];
    return sum / static_cast<double>(off.size() - lag);
  };
  const double variance = covariance(0);
  double sum = variance;
  for (std::size_t lag = 1; lag < off.size() / 2; ++lag) {
    const double c = covariance(lag);
    if (!(c > 0))
      break;
    sum += 2 * c;
  }
  return {variance, sum};
}

} // namespace

WallNoise
wallNoise(const std::vector<LoopContour>& contours,
          const LoopEnergy& energy,
          double spacing)
{
  constexpr std::size_t shortest = 24; // samples
  constexpr std::size_t enough = 4;    // stretches
  WallNoise noise;
  for (std::size_t length = shortest;; length *= 2) {
    const auto stretches = stretchDeviations(contours, length);
    if (stretches.size() < enough)
      return noise;
    std::vector<double> off;
    std::vector<double> sums;
    double variance = 0;
    double sum = 0;
    const double least = energy.min_sigma * energy.min_sigma / 4; // not correlated
    for (const auto& stretch : stretches) {
      for (const double d : stretch)
        off.push_back(std::abs(d));
      const auto [of_place, of_wave] = variances(stretch);
      sums.push_back(of_wave);
      variance += of_place + least;
      sum += of_wave + least;
    }
    if (length == shortest) {
      // The quartile of a normal distribution is 1.15 sigma.
      const auto rank = off.begin() + static_cast<std::ptrdiff_t>(off.size() * 3 / 4);
      std::nth_element(off.begin(), rank, off.end());
      noise.measured = *rank / 1.15;
      noise.sigma = std::clamp(noise.measured, energy.min_sigma, energy.max_sigma);
      noise.correlation = std::clamp(spacing * sum / variance, energy.min_correlation,
                                     energy.max_correlation);
      noise.spread = noise.sigma;
      noise.stretches = stretches.size();
    }
    else
      noise.spread = std::clamp(
          std::sqrt(spacing * middleValue(std::move(sums)) / noise.correlation),
          noise.spread, energy.max_spread);
  }
}

} // namespace pcl::sedr
