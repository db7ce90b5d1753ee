// SPDX-License-Identifier: BSD-3-Clause
#include "wall_sides.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr {

double
WallSide::offset(const Eigen::Vector2d& p) const
{
  if (!line.isArc())
    return (p - line.start).dot(line.normalAt(0));
  const double inside = line.radius - (p - line.centre).norm();
  return line.counter_clockwise ? inside : -inside;
}

namespace {

void
addHeights(const PlanRoom& room, WallSide& side)
{
  side.floor = std::numeric_limits<double>::infinity();
  side.ceiling = -side.floor;
  side.foot = room.floor.heightAt(side.line.pointAt(side.line.length() / 2));
  const auto steps =
      static_cast<std::size_t>(side.line.length() / opening_numbers.height_step) + 2;
  for (std::size_t k = 0; k <= steps; ++k) {
    const double s =
        side.line.length() * static_cast<double>(k) / static_cast<double>(steps);
    const Eigen::Vector2d p =
        side.line.pointAt(s) + opening_numbers.inside * side.line.normalAt(s);
    side.floor = std::min(side.floor, room.floorAt(p));
    side.ceiling = std::max(side.ceiling, room.ceilingAt(p));
  }
  side.ceiling = std::max(side.ceiling, side.floor); // below it in a wrong plan
}

/** @brief Leads straight sides on over the bays at their ends: where the boundary of
 * their room lies behind their line, no deeper than a wall. */
void
extendOverBays(std::vector<WallSide>& sides, const OpeningSizes& sizes)
{
  const std::vector<WallSide> from = sides;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const PlanElement& line = from[k].line;
    if (line.isArc() || !from[k].may_have_openings)
      continue;
    const double length = line.length();
    const auto reach = [&](double end, double step) {
      double far = end;
      while (std::abs(far - end) < sizes.max_gap &&
             !sidesBehind(from, from[k], far + step, BehindKind::Own, sizes.max_depth)
                  .empty())
        far += step;
      return line.pointAt(far);
    };
    sides[k].line.start = reach(0, -opening_numbers.back_step);
    sides[k].line.end = reach(length, opening_numbers.back_step);
  }
}

} // namespace

std::vector<WallSide>
wallSides(const Floorplan& plan, const OpeningSizes& sizes)
{
  std::vector<WallSide> sides;
  for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
    const PlanRoom& room = plan.rooms[r];
    const auto add = [&](const PlanLoop& loop, int column) {
      const bool is_surrounded =
          column < 0 || loop.length() > opening_numbers.min_island;
      for (std::size_t e = 0; e < loop.elements.size(); ++e)
        if (const double length = loop.elements[e].length(); length > 0) {
          sides.push_back({r, loop.elements[e], e, column,
                           is_surrounded && length >= sizes.min_side});
          addHeights(room, sides.back());
        }
    };
    add(room.boundary, -1);
    for (std::size_t c = 0; c < room.columns.size(); ++c)
      add(room.columns[c], static_cast<int>(c));
  }
  extendOverBays(sides, sizes);
  return sides;
}

std::vector<SideBehind>
sidesBehind(const std::vector<WallSide>& sides,
            const WallSide& side,
            double along,
            BehindKind kind,
            double max_depth)
{
  const bool is_opposite = kind == BehindKind::Opposite;
  const Eigen::Vector2d place = side.line.pointAt(along);
  const Eigen::Vector2d normal = side.line.normalAt(along);
  std::vector<SideBehind> found;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const WallSide& other = sides[k];
    if (&other == &side || !other.may_have_openings || !other.line.isBeside(place) ||
        std::min(other.ceiling, side.ceiling) - std::max(other.floor, side.floor) < 1)
      continue;
    // The place is behind an opposite side, and before one of its own room.
    const double behind = is_opposite ? -other.offset(place) : other.offset(place);
    const double cosine = other.line.normalAt(other.line.project(place)).dot(normal);
    if (behind > 0.01 && behind < max_depth &&
        (is_opposite ? -cosine : cosine) >= opening_numbers.min_cosine &&
        (is_opposite || other.room == side.room))
      found.push_back({k, behind});
  }
  std::stable_sort(
      found.begin(), found.end(),
      [](const SideBehind& a, const SideBehind& b) { return a.depth < b.depth; });
  return found;
}

} // namespace pcl::sedr
