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

/** @brief Whether a segment lies on the line of another and runs the same way. */
bool
isInLine(const PlanElement& line, const PlanElement& e, double tolerance)
{
  const Eigen::Vector2d normal = line.normalAt(0);
  return (e.end - e.start).dot(line.end - line.start) > 0 &&
         std::abs((e.start - line.start).dot(normal)) < tolerance &&
         std::abs((e.end - line.start).dot(normal)) < tolerance;
}

void
addHeights(const PlanRoom& room, WallSide& side)
{
  side.floor = std::numeric_limits<double>::infinity();
  side.ceiling = -side.floor;
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
}

/** @brief A segment of a loop, by its extent along a line. */
struct Span {
  double from;
  double to;
  std::size_t element;
};

/** @brief Adds the sides along a line, parted where its segments lie too far apart. */
void
addAlong(const PlanElement& line,
         std::vector<Span> spans,
         const WallSide& model,
         bool is_boundary,
         const OpeningSizes& sizes,
         std::vector<WallSide>& sides)
{
  std::sort(spans.begin(), spans.end(),
            [](const Span& a, const Span& b) { return a.from < b.from; });
  const Eigen::Vector2d way = (line.end - line.start).normalized();
  for (std::size_t k = 0; k < spans.size();) {
    WallSide side = model;
    const double from = spans[k].from;
    double to = spans[k].to;
    for (; k < spans.size() && spans[k].from < to + sizes.max_gap; ++k) {
      to = std::max(to, spans[k].to);
      if (is_boundary)
        side.elements.push_back(spans[k].element);
    }
    side.line = PlanElement();
    side.line.start = line.start + from * way;
    side.line.end = line.start + to * way;
    if (to - from >= sizes.min_side)
      sides.push_back(side);
  }
}

void
addLoop(std::size_t room,
        const PlanLoop& loop,
        bool is_boundary,
        const OpeningSizes& sizes,
        std::vector<WallSide>& sides)
{
  const std::vector<PlanElement>& elements = loop.elements;
  std::vector<std::size_t> order;
  for (std::size_t e = 0; e < elements.size(); ++e)
    if (elements[e].length() > 1e-3)
      order.push_back(e);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return elements[a].length() > elements[b].length();
  });
  std::vector<bool> is_used(elements.size());
  WallSide model;
  model.room = room;
  for (const std::size_t e : order) {
    if (is_used[e])
      continue;
    const PlanElement& line = elements[e];
    if (line.isArc()) {
      model.line = line;
      model.elements = is_boundary ? std::vector{e} : std::vector<std::size_t>();
      if (line.length() >= sizes.min_side)
        sides.push_back(model);
      model.elements.clear();
      continue;
    }
    const Eigen::Vector2d way = (line.end - line.start).normalized();
    std::vector<Span> spans;
    for (const std::size_t o : order)
      if (!is_used[o] && !elements[o].isArc() &&
          isInLine(line, elements[o], sizes.same_line)) {
        is_used[o] = true;
        spans.push_back({(elements[o].start - line.start).dot(way),
                         (elements[o].end - line.start).dot(way), o});
      }
    addAlong(line, std::move(spans), model, is_boundary, sizes, sides);
  }
}

/** @brief Leads straight sides on over the bays at their ends: where the boundary of
 * their room lies behind their line, no deeper than a wall. */
void
extendOverBays(std::vector<WallSide>& sides, const OpeningSizes& sizes)
{
  const std::vector<WallSide> from = sides;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const PlanElement& line = from[k].line;
    if (line.isArc())
      continue;
    const double length = line.length();
    const auto reach = [&](double end, double step) {
      double far = end;
      while (std::abs(far - end) < sizes.max_gap &&
             sideBehind(from, from[k], far + step, BehindKind::Own, sizes.max_depth) <
                 from.size())
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
    const std::size_t first = sides.size();
    addLoop(r, room.boundary, true, sizes, sides);
    for (const PlanLoop& column : room.columns)
      if (column.length() > opening_numbers.min_island)
        addLoop(r, column, false, sizes, sides);
    for (std::size_t k = first; k < sides.size(); ++k)
      addHeights(room, sides[k]);
  }
  extendOverBays(sides, sizes);
  return sides;
}

std::size_t
sideBehind(const std::vector<WallSide>& sides,
           const WallSide& side,
           double along,
           BehindKind kind,
           double max_depth)
{
  const bool is_opposite = kind == BehindKind::Opposite;
  const Eigen::Vector2d place = side.line.pointAt(along);
  const Eigen::Vector2d normal = side.line.normalAt(along);
  std::size_t best = sides.size();
  double nearest = max_depth;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const WallSide& other = sides[k];
    if (&other == &side || !other.line.isBeside(place) ||
        std::min(other.ceiling, side.ceiling) - std::max(other.floor, side.floor) < 1)
      continue;
    // The place is behind an opposite side, and before one of its own room.
    const double behind = is_opposite ? -other.offset(place) : other.offset(place);
    const double cosine = other.line.normalAt(other.line.project(place)).dot(normal);
    if (behind <= 0.01 || behind >= nearest ||
        (is_opposite ? -cosine : cosine) < opening_numbers.min_cosine ||
        (!is_opposite && other.room != side.room))
      continue;
    nearest = behind;
    best = k;
  }
  return best;
}

} // namespace pcl::sedr
