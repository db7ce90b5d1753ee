// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief A line of a ceiling or floor in plan. */
struct SurfaceLine {
  PlanElement element;
  bool is_crease = false; ///< two surfaces meet in it; otherwise it is a step
  std::string text{};     ///< "ridge 4.35" or "valley 2.90"; usually empty
};

/** @brief Calls `use(part, value)` for the parts of an element along which `value(s)`
 * of the distance from its start is the same; in order.
 *
 * The value is asked for at the middle of steps of at most 2 cm, as the ends may lie on
 * a wall; where it changes, the place is found to a thousandth of a step. */
template <typename Value, typename Use>
void
forEachPart(const PlanElement& element, Value value, Use use)
{
  constexpr double max_step = 0.02;
  constexpr double max_steps = 10000;
  const double length = element.length();
  const double steps = std::clamp(std::ceil(length / max_step), 1.0, max_steps);
  const auto middle = [&](double k) { return (k + 0.5) * length / steps; };
  double start = 0;
  auto current = value(middle(0));
  for (double k = 1; k <= steps; ++k) {
    double to = length;
    auto next = current;
    if (k < steps) {
      next = value(middle(k));
      if (next == current)
        continue;
      double from = middle(k - 1);
      to = middle(k);
      for (int halving = 0; halving < 10; ++halving) {
        const double between = (from + to) / 2;
        (value(between) == current ? from : to) = between;
      }
    }
    use(start == 0 && to == length ? element : element.part(start, to), current);
    start = to;
    current = next;
  }
}

/** @brief Returns the parts of an element along which `is_so(s)`, as above. */
template <typename IsSo>
std::vector<PlanElement>
partsWhere(const PlanElement& element, IsSo is_so)
{
  std::vector<PlanElement> parts;
  forEachPart(element, is_so, [&](const PlanElement& part, bool holds) {
    if (holds)
      parts.push_back(part);
  });
  return parts;
}

/** @brief Joins segments that share ends, to 0.1 mm, to polylines; a closed one ends
 * where it starts. Where more than two meet, lines end. */
std::vector<std::vector<Eigen::Vector2d>>
chained(const std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>& segments);

} // namespace pcl::sedr
