// SPDX-License-Identifier: BSD-3-Clause
#include "eaves.h"

#include "../formats/decimal_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr {

std::string
eavesText(const PlanRoom& room, const CeilingLines& ceiling, const PlanElement& wall)
{
  constexpr double level = 0.05; // maximum height difference along eaves
  constexpr double beside = 0.03;
  constexpr double at_ends = 0.05; // of the wall
  constexpr double inward = 0.4;
  constexpr double rises = 0.03; // metres, over that distance
  if (!room.hasFacets() || wall.isArc() || wall.length() < 4 * beside)
    return "";
  // Height at the wall of the ceiling slab beside it.
  const auto heightAt = [&](double share, double distance) {
    const double s = share * wall.length();
    const Eigen::Vector2d inside = wall.pointAt(s) + beside * wall.normalAt(s);
    const int detail = room.detailAt(inside);
    return ceiling.shownFor(detail) != detail
               ? std::numeric_limits<double>::quiet_NaN()
               : room.ceilingSlab(detail).heightAt(wall.pointAt(s) +
                                                   distance * wall.normalAt(s));
  };
  const double first = heightAt(at_ends, 0);
  const double middle = heightAt(0.5, 0);
  const double last = heightAt(1 - at_ends, 0);
  const auto [low, high] = std::minmax({first, middle, last});
  const bool is_known = std::isfinite(first + middle + last);
  if (!is_known || high - low > level || heightAt(0.5, inward) < middle + rises)
    return "";
  const Eigen::Vector2d place =
      wall.pointAt(wall.length() / 2) + beside * wall.normalAt(wall.length() / 2);
  return "eaves " + decimalText(middle - room.floorAt(place), 2);
}

} // namespace pcl::sedr
