// SPDX-License-Identifier: BSD-3-Clause
#include "wall_sides.h"

#include "sedr_filters/src/plan/plan_geometry.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

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
 * their room lies behind their line, no deeper than a wall; and on to the wall beyond
 * them, so that both jambs are on one map. */
void
extendOverBays(std::vector<WallSide>& sides, const OpeningSizes& sizes)
{
  const std::vector<WallSide> from = sides;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const PlanElement& line = from[k].line;
    if (line.isArc() || !from[k].may_have_openings)
      continue;
    const double length = line.length();
    const auto isInLine = [&](double along) { // another wall of the room
      const Eigen::Vector2d place = line.pointAt(along);
      return std::any_of(from.begin(), from.end(), [&](const WallSide& other) {
        return other.room == from[k].room && !other.line.isArc() &&
               other.line.isBeside(place) &&
               std::abs(other.offset(place)) < opening_numbers.off_edge &&
               other.line.normalAt(0).dot(line.normalAt(0)) >=
                   opening_numbers.min_cosine;
      });
    };
    const auto reach = [&](double end, double step) {
      double far = end;
      while (std::abs(far - end) < sizes.max_gap &&
             !sidesBehind(from, from[k], far + step, BehindKind::Own, sizes.max_depth)
                  .empty())
        far += step;
      for (const double bay = far; far != end &&
                                   std::abs(far - bay) < 2 * sizes.beside &&
                                   isInLine(far + step);)
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
                           is_surrounded && length >= sizes.beside});
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

Backs::Backs(const std::vector<WallSide>& sides,
             std::size_t side,
             BehindKind kind,
             double max_depth)
    : sides_(sides)
{
  const double length = sides[side].line.length();
  const double step = opening_numbers.back_step;
  for (double s = step / 2; s < length + step / 2; s += step)
    behind_.push_back(
        sidesBehind(sides, sides[side], std::min(s, length), kind, max_depth));
}

const std::vector<SideBehind>&
Backs::at(double along) const
{
  const auto k =
      static_cast<std::size_t>(std::max(along, 0.0) / opening_numbers.back_step);
  return behind_[std::min(k, behind_.size() - 1)];
}

const SideBehind*
Backs::at(double along, double height) const
{
  const SideBehind* best = nullptr;
  double off = std::numeric_limits<double>::infinity();
  for (const SideBehind& behind : at(along)) {
    const WallSide& side = sides_[behind.side];
    const double beyond = std::max({side.floor - height, height - side.ceiling, 0.0});
    if (beyond < off)
      best = &behind;
    off = std::min(off, beyond);
  }
  return best;
}

std::vector<WallRectangle>
openingsOn(const Floorplan& plan, const WallSide& side)
{
  std::vector<WallRectangle> on_side;
  for (const PlanOpening& opening : plan.openings)
    for (const OpeningWall& of : opening.walls)
      if (side.isWall() && of.element == side.element &&
          of.room == plan.rooms[side.room].id) {
        const auto [from, to] = std::minmax(
            {side.line.project(opening.start), side.line.project(opening.end)});
        on_side.push_back({from, to, opening.bottom, opening.top});
      }
  return on_side;
}

namespace {

namespace bg = boost::geometry;

using Corner = bg::model::point<double, 3, bg::cs::cartesian>;
using Box = bg::model::box<Corner>;

} // namespace

std::vector<std::vector<SidePoint>>
pointsBeside(const std::vector<WallSide>& sides,
             const PointView& points,
             const pcl::Indices* indices,
             double before,
             double behind)
{
  std::vector<std::vector<SidePoint>> beside(sides.size());
  const double reach = std::max(before, behind);
  std::vector<std::pair<Box, std::size_t>> boxes;
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const WallSide& side = sides[s];
    const Eigen::AlignedBox2d box = boxAround(side.line);
    const double far =
        reach + (side.ceiling - side.floor) * std::abs(std::tan(side.line.tilt));
    boxes.push_back({{{box.min().x() - far, box.min().y() - far, side.floor - 0.1},
                      {box.max().x() + far, box.max().y() + far, side.ceiling + 0.1}},
                     s});
  }
  const bg::index::rtree<std::pair<Box, std::size_t>, bg::index::quadratic<16>> tree(
      boxes);
  const std::size_t n = indices ? indices->size() : points.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Eigen::Vector3f p =
        points[indices ? static_cast<std::size_t>((*indices)[k]) : k];
    if (!p.allFinite())
      continue;
    const Eigen::Vector2d place = p.head<2>().cast<double>();
    const auto add = [&](const std::pair<Box, std::size_t>& near) {
      const PlanElement& line = sides[near.second].line;
      const double offset =
          sides[near.second].offset(Eigen::Vector3d(p.cast<double>()));
      if (offset <= before && offset >= -behind && line.isBeside(place))
        beside[near.second].push_back({static_cast<float>(line.project(place)), p.z(),
                                       static_cast<float>(offset)});
    };
    tree.query(bg::index::intersects(Corner(place.x(), place.y(), p.z())),
               boost::make_function_output_iterator(add));
  }
  return beside;
}

} // namespace pcl::sedr
