// SPDX-License-Identifier: BSD-3-Clause
#include "roof_lines.h"

#include "../formats/decimal_text.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {
namespace {

constexpr double level = 0.05; ///< maximum height difference along a level line, metres

} // namespace

std::string
RoofLine::text() const
{
  if (!is_crease || !is_level)
    return "";
  return (is_ridge ? "ridge " : "valley ") + decimalText(height, 2);
}

RoofLine
roofLineAt(const PlanRoom& room, const PlanElement& line)
{
  constexpr double beside = beside_border;
  constexpr double at_ends =
      0.1; // of the line, where a step may be that its middle lacks
  constexpr double step = 0.03;  // metres; a higher step is no crease
  constexpr double falls = 0.02; // slope beside the line: 2 %
  constexpr double bends = 0.1;  // change of slope: 6 degrees
  const auto slabAt = [&](double share, double distance) -> const PlanSlab& {
    const double s = share * line.length();
    return room.ceilingSlab(
        room.detailAt(line.pointAt(s) + distance * line.normalAt(s)));
  };
  const double s = line.length() / 2;
  const Eigen::Vector2d middle = line.pointAt(s);
  const Eigen::Vector2d off = line.normalAt(s);
  const PlanSlab& left = slabAt(0.5, beside);
  const PlanSlab& right = slabAt(0.5, -beside);
  const auto slope = [&](const PlanSlab& slab, double sign) {
    return (slab.heightAt(middle + sign * beside * off) - slab.heightAt(middle)) /
           beside;
  };
  const auto stepAt = [&](double share) {
    const Eigen::Vector2d p = line.pointAt(share * line.length());
    return std::abs(slabAt(share, beside).heightAt(p) -
                    slabAt(share, -beside).heightAt(p));
  };
  RoofLine roof;
  const double left_slope = slope(left, 1);
  const double right_slope = slope(right, -1);
  const bool do_meet = stepAt(0.5) < step;
  const bool is_valley = left_slope > falls && right_slope > falls;
  roof.is_ridge = do_meet && left_slope < -falls && right_slope < -falls;
  roof.is_crease = roof.is_ridge || (do_meet && is_valley);
  roof.is_seen = roof.is_crease || std::abs(left_slope + right_slope) > bends ||
                 std::max({stepAt(at_ends), stepAt(0.5), stepAt(1 - at_ends)}) >= step;
  roof.height = left.heightAt(middle) - room.floorAt(middle);
  roof.is_level = std::abs(left.heightAt(line.start) - left.heightAt(line.end)) < level;
  return roof;
}

std::string
eavesText(const PlanRoom& room, const PlanElement& wall)
{
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
    return room.ceilingSlab(room.detailAt(inside))
        .heightAt(wall.pointAt(s) + distance * wall.normalAt(s));
  };
  const double first = heightAt(at_ends, 0);
  const double middle = heightAt(0.5, 0);
  const double last = heightAt(1 - at_ends, 0);
  const auto [low, high] = std::minmax({first, middle, last});
  if (high - low > level || heightAt(0.5, inward) < middle + rises)
    return "";
  const Eigen::Vector2d place =
      wall.pointAt(wall.length() / 2) + beside * wall.normalAt(wall.length() / 2);
  return "eaves " + decimalText(middle - room.floorAt(place), 2);
}

} // namespace pcl::sedr
