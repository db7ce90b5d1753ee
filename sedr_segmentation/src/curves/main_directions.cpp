// SPDX-License-Identifier: BSD-3-Clause
#include "main_directions.h"

#include "plan_curve.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

std::vector<Eigen::Vector2d>
mainDirections(std::vector<DirectedLine> lines, const Priors& priors)
{
  constexpr std::size_t most = 5;
  constexpr double shortest = 0.6;           // metres
  const double same = priors.same_direction; // radians
  std::stable_sort(
      lines.begin(), lines.end(),
      [](const DirectedLine& a, const DirectedLine& b) { return a.length > b.length; });
  std::vector<Eigen::Vector2d> directions;
  for (const auto& line : lines) {
    const bool is_new = std::none_of(
        directions.begin(), directions.end(), [&](const Eigen::Vector2d& d) {
          return std::abs(leftOf(d).dot(line.direction)) < same;
        });
    const bool is_long = line.length >= shortest || directions.empty();
    if (!is_new || !is_long || directions.size() == 2 * most)
      continue;
    directions.push_back(line.direction);
    directions.push_back(leftOf(line.direction));
  }
  return directions;
}

} // namespace pcl::sedr
