// SPDX-License-Identifier: BSD-3-Clause
#include "opening_search.h"

#include "opening_gains.h"
#include "sedr_filters/src/base/parallel_for.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr {
namespace {

/** @brief The sides behind one side, at steps along it. */
class Backs {
public:
  Backs(const std::vector<WallSide>& sides,
        std::size_t side,
        BehindKind kind,
        double max_depth)
      : sides_(sides)
      , side_(sides[side])
  {
    const auto n =
        static_cast<std::size_t>(side_.line.length() / opening_numbers.back_step) + 1;
    for (std::size_t k = 0; k < n; ++k)
      behind_.push_back(sideBehind(
          sides, side_,
          std::min(opening_numbers.back_step * (static_cast<double>(k) + 0.5),
                   side_.line.length()),
          kind, max_depth));
  }

  std::size_t at(double along) const
  {
    const auto k =
        static_cast<std::size_t>(std::max(along, 0.0) / opening_numbers.back_step);
    return behind_[std::min(k, behind_.size() - 1)];
  }

  /** @brief Returns the least distance of a side behind; infinite if there is none. */
  double nearest() const
  {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < behind_.size(); ++k)
      if (behind_[k] < sides_.size())
        least = std::min(least,
                         -sides_[behind_[k]].offset(side_.line.pointAt(std::min(
                             opening_numbers.back_step * (static_cast<double>(k) + 0.5),
                             side_.line.length()))));
    return least;
  }

private:
  const std::vector<WallSide>& sides_;
  const WallSide& side_;
  std::vector<std::size_t> behind_;
};

/** @brief Moves a side and its points to a face before it. */
void
moveSide(double off, WallSide& side, std::vector<SidePoint>& points)
{
  PlanElement& line = side.line;
  const double length = line.length();
  if (line.isArc()) {
    const double radius = line.radius + (line.counter_clockwise ? -off : off);
    if (radius <= 0)
      return;
    for (Eigen::Vector2d* end : {&line.start, &line.end})
      *end = line.centre + radius / line.radius * (*end - line.centre);
    line.radius = radius;
  }
  else {
    const Eigen::Vector2d shift = off * line.normalAt(0);
    line.start += shift;
    line.end += shift;
  }
  const auto scale = static_cast<float>(line.length() / length);
  for (SidePoint& p : points) {
    p.offset -= static_cast<float>(off);
    p.along *= scale;
  }
}

/** @brief Whether two openings are the same one, seen from two sides or by two walls in
 * a line. */
bool
areSame(const PlanOpening& a, const PlanOpening& b)
{
  const Eigen::Vector2d way = (a.end - a.start).normalized();
  const Eigen::Vector2d left(-way.y(), way.x());
  if (std::abs(left.dot((b.end - b.start).normalized())) >
          opening_numbers.same_direction ||
      std::abs(left.dot((b.start + b.end - a.start - a.end) / 2)) >
          opening_numbers.same_wall)
    return false;
  const double s0 = way.dot(b.start - a.start);
  const double s1 = way.dot(b.end - a.start);
  const double along =
      std::min(a.width(), std::max(s0, s1)) - std::max(0.0, std::min(s0, s1));
  const double up = std::min(a.top, b.top) - std::max(a.bottom, b.bottom);
  return along > opening_numbers.same_share * std::min(a.width(), b.width()) &&
         up > opening_numbers.same_share * std::min(a.height(), b.height());
}

/** @brief Returns the id of the room at a place behind a wall; 0: none. */
std::uint32_t
roomBehind(const Floorplan& plan, const PlanOpening& opening, double depth)
{
  const Eigen::Vector2d way = (opening.end - opening.start).normalized();
  const Eigen::Vector2d place =
      (opening.start + opening.end) / 2 + depth * Eigen::Vector2d(way.y(), -way.x());
  const double height = (opening.bottom + opening.top) / 2;
  for (const PlanRoom& room : plan.rooms)
    if (room.contains(place) && room.floorAt(place) < height &&
        room.ceilingAt(place) > height)
      return room.id;
  return 0;
}

/** @brief Adds the wall of a side that is nearest to a place; none of an island. */
void
addWall(const Floorplan& plan,
        const WallSide& side,
        const Eigen::Vector2d& place,
        PlanOpening& opening)
{
  const PlanRoom& room = plan.rooms[side.room];
  const auto distance = [&](std::size_t e) {
    return room.boundary.elements[e].distance(place);
  };
  const auto nearest = std::min_element(
      side.elements.begin(), side.elements.end(),
      [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
  if (nearest != side.elements.end())
    opening.walls.push_back({room.id, *nearest});
}

/** @brief Whether no face was seen below most of a rectangle. */
bool
isOpenBelow(const WallMap& map, const WallRectangle& at)
{
  std::size_t seen = 0;
  std::size_t all = 0;
  for (double s = at.from + map.cell() / 2; s < at.to; s += map.cell()) {
    ++all;
    seen += map.at(s, at.bottom - map.cell() / 2) == WallCell::Seen ? 1 : 0;
  }
  return 2 * seen < all;
}

} // namespace

double
highestFloor(const Floorplan& plan, const PlanOpening& opening)
{
  const Eigen::Vector2d way = (opening.end - opening.start).normalized();
  const Eigen::Vector2d left(-way.y(), way.x());
  double floor = -std::numeric_limits<double>::infinity();
  for (const PlanRoom& room : plan.rooms)
    for (const int k : {0, 1})
      if (room.id == opening.rooms[static_cast<std::size_t>(k)]) {
        const double at = room.floorAt(
            (opening.start + opening.end) / 2 +
            (k == 0 ? 1 : -1) * (opening.depth / 2 + opening_numbers.inside) * left);
        if (at < (opening.bottom + opening.top) / 2) // not of a storey above
          floor = std::max(floor, at);
      }
  return floor;
}

OpeningSearch::OpeningSearch(const Floorplan& plan,
                             const PointView& points,
                             const pcl::Indices* indices,
                             const OpeningParameters& parameters)
    : sides(wallSides(plan, parameters.sizes))
{
  const OpeningSizes& sizes = parameters.sizes;
  auto beside = pointsBeside(sides, points, indices, sizes, parameters.threads);
  for (std::size_t k = 0; k < sides.size(); ++k)
    if (const double off = faceOffset(sides[k], beside[k], sizes); off > 0)
      moveSide(off, sides[k], beside[k]);
  std::vector<Backs> backs;
  std::vector<Backs> bays;
  backs.reserve(sides.size());
  bays.reserve(sides.size());
  for (std::size_t k = 0; k < sides.size(); ++k) {
    backs.emplace_back(sides, k, BehindKind::Opposite, sizes.max_depth);
    bays.emplace_back(sides, k, BehindKind::Own, sizes.max_depth);
    const double thickness = backs.back().nearest();
    maps.emplace_back(plan.rooms[sides[k].room], sides[k], std::move(beside[k]),
                      std::min(thickness, sizes.shallow), sizes);
  }
  std::vector<std::vector<FoundOpening>> on_side(sides.size());
  parallelFor(sides.size(), 1, parameters.threads, [&](std::size_t k) {
    const WallMap& map = maps[k];
    const WallSide& side = sides[k];
    std::vector<MapBehind> behind(map.columns());
    std::vector<bool> is_wall(map.columns(), true);
    for (std::size_t c = 0; c < map.columns(); ++c) {
      const double s = map.cell() * (static_cast<double>(c) + 0.5);
      const std::size_t b = backs[k].at(s);
      if (b < sides.size())
        behind[c] = {&maps[b], sides[b].line.project(side.line.pointAt(s))};
      const std::size_t bay = bays[k].at(s);
      is_wall[c] = bay == sides.size() || map.seenHeight(s) > sizes.on_floor ||
                   maps[bay].seenHeight(sides[bay].line.project(side.line.pointAt(s))) <
                       sizes.min_height;
    }
    for (const CellRectangle& cells : bestRectangles(
             openingGains(map, behind, is_wall, parameters.weights, sizes))) {
      FoundOpening candidate;
      candidate.side = k;
      candidate.gain = cells.gain;
      const double length = side.line.length();
      const auto along = [&](std::size_t c) {
        return std::min(map.cell() * static_cast<double>(c), length);
      };
      candidate.rectangle =
          fittedEdges(map,
                      {along(cells.first_column), along(cells.last_column),
                       map.heightOf(cells.first_row), map.heightOf(cells.last_row)},
                      sizes);
      on_side[k].push_back(candidate);
    }
  });
  for (std::size_t k = 0; k < sides.size(); ++k)
    for (FoundOpening& candidate : on_side[k]) {
      const WallSide& side = sides[k];
      const PlanRoom& room = plan.rooms[side.room];
      WallRectangle& at = candidate.rectangle;
      const double middle = (at.from + at.to) / 2;
      candidate.behind = backs[k].at(middle);
      const bool is_paired = candidate.behind < sides.size();
      PlanOpening& o = candidate.opening;
      const Eigen::Vector2d place = side.line.pointAt(middle);
      addWall(plan, side, place, o);
      if (is_paired)
        addWall(plan, sides[candidate.behind], place, o);
      o.depth = is_paired ? -sides[candidate.behind].offset(place) : maps[k].depth();
      const auto onMiddleLine = [&](double s) {
        s = std::clamp(s, 0.0, side.line.length());
        return Eigen::Vector2d(side.line.pointAt(s) -
                               o.depth / 2 * side.line.normalAt(s));
      };
      o.start = onMiddleLine(at.from);
      o.end = onMiddleLine(at.to);
      o.bottom = at.bottom;
      o.top = at.top;
      o.rooms[0] = room.id;
      o.rooms[1] = is_paired ? plan.rooms[sides[candidate.behind].room].id
                             : roomBehind(plan, o, o.depth / 2 + 0.3);
      const double floor = highestFloor(plan, o);
      const double step = std::max(
          sizes.on_floor, 1.2 * maps[k].cell()); // rows hold the floor's points
      if (at.bottom - floor < step && isOpenBelow(maps[k], at))
        o.bottom = floor;
      o.residual = at.residual;
    }
  for (auto& list : on_side)
    found.insert(found.end(), list.begin(), list.end());
  std::stable_sort(
      found.begin(), found.end(),
      [](const FoundOpening& a, const FoundOpening& b) { return a.gain > b.gain; });
  std::vector<FoundOpening> kept;
  for (const FoundOpening& candidate : found)
    if (std::none_of(kept.begin(), kept.end(), [&](const FoundOpening& other) {
          return areSame(other.opening, candidate.opening);
        }))
      kept.push_back(candidate);
  found = std::move(kept);
}

} // namespace pcl::sedr
