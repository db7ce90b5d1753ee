// SPDX-License-Identifier: BSD-3-Clause
#include "main_angles.h"

#include <pcl/sedr_filters/priors.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::sedr {

std::vector<double>
mainAngles(const std::vector<double>& angles,
           const std::vector<double>& weights,
           std::size_t most,
           double least)
{
  constexpr std::size_t steps = 360; // of a quarter turn
  const double spread = radians(0.7);
  const double near = radians(1.5);
  const double apart = radians(5);
  std::vector<double> axes;
  std::vector<double> height(steps, 0);
  const auto angleAt = [](std::size_t g) {
    return static_cast<double>(g) * (M_PI / 2) / static_cast<double>(steps);
  };
  for (std::size_t g = 0; g < steps; ++g)
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const double d = std::remainder(angles[i] - angleAt(g), M_PI / 2) / spread;
      if (std::abs(d) < 5)
        height[g] += weights[i] * std::exp(-0.5 * d * d);
    }
  double first = 0;
  while (axes.size() < most) {
    const auto top = std::max_element(height.begin(), height.end());
    if (axes.empty())
      first = *top;
    if (!(*top > 0) || *top < least * first)
      break;
    const double angle = angleAt(static_cast<std::size_t>(top - height.begin()));
    std::vector<std::pair<double, double>> turns; // from the angle, weight
    double left = 0; // half of the weight: a median, since some lines lean
    for (std::size_t i = 0; i < angles.size(); ++i)
      if (const double d = std::remainder(angles[i] - angle, M_PI / 2);
          std::abs(d) < near) {
        turns.push_back({d, weights[i]});
        left += weights[i] / 2;
      }
    std::sort(turns.begin(), turns.end());
    std::size_t middle = 0;
    while (middle + 1 < turns.size() && (left -= turns[middle].second) > 0)
      ++middle;
    axes.push_back(angle + (turns.empty() ? 0 : turns[middle].first));
    for (std::size_t g = 0; g < steps; ++g)
      if (std::abs(std::remainder(angleAt(g) - axes.back(), M_PI / 2)) <= apart)
        height[g] = 0;
  }
  return axes;
}

} // namespace pcl::sedr
