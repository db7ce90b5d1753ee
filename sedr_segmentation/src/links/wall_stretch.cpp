// SPDX-License-Identifier: BSD-3-Clause
#include "wall_stretch.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl::sedr {

namespace {

/** @brief Finds the interval of `width` with the most offsets, with its mean within
 * `reach` of `expected` and a preference for near ones. */
WallStretch
densestStretch(std::vector<double>& offsets,
               double width,
               double expected,
               double reach)
{
  std::sort(offsets.begin(), offsets.end());
  WallStretch best;
  double best_score = 0;
  double sum = 0;
  double squares = 0;
  for (std::size_t first = 0, last = 0; last < offsets.size(); ++last) {
    sum += offsets[last];
    squares += offsets[last] * offsets[last];
    for (; offsets[last] - offsets[first] > width; ++first) {
      sum -= offsets[first];
      squares -= offsets[first] * offsets[first];
    }
    const std::size_t count = last - first + 1;
    const double mean = sum / static_cast<double>(count);
    if (std::abs(mean - expected) > reach)
      continue;
    const double score =
        static_cast<double>(count) * (1.2 - std::abs(mean - expected) / reach);
    if (score > best_score) {
      best_score = score;
      best = {
          mean, count,
          std::sqrt(std::max(0.0, squares / static_cast<double>(count) - mean * mean))};
    }
  }
  return best;
}

} // namespace

WallStretch
wallAcross(const PlanPoints& evidence,
           const Eigen::Vector2d& place,
           const Eigen::Vector2d& along,
           const LoopParameters& parameters)
{
  const Eigen::Vector2d across = leftOf(along);
  std::vector<double> offsets;
  evidence.forEachWithin(
      place,
      std::hypot(std::abs(parameters.expected_offset) + parameters.reach,
                 parameters.evidence_span),
      [&](const Eigen::Vector2d& p) {
        const Eigen::Vector2d d = p - place;
        if (std::abs(d.dot(along)) <= parameters.evidence_span)
          offsets.push_back(d.dot(across));
      });
  return densestStretch(offsets, parameters.tolerance, parameters.expected_offset,
                        parameters.reach);
}

} // namespace pcl::sedr
