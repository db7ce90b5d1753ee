// SPDX-License-Identifier: BSD-3-Clause
#include "element_changes.h"

#include "sedr_filters/src/plan/plan_bounds.h"
#include "sedr_filters/src/plan/plan_segment.h"
#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr::tools {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/** @brief A column or an opening of a plan. */
struct Thing {
  std::string what;
  std::string name;       ///< as in a solid
  Eigen::Vector3d middle; ///< metres
  double area = 0;        ///< square metres
  RoomHeights heights;    ///< of the room of a column
  PlanLoop outline;
  const PlanOpening* opening = nullptr;
};

std::vector<Thing>
columnsOf(const Floorplan& plan)
{
  std::vector<Thing> columns;
  for (const auto& room : plan.rooms)
    for (std::size_t k = 0; k < room.columns.size(); ++k) {
      const Eigen::Vector2d centre = boundsOf(room.columns[k]).center();
      columns.push_back(
          {"column",
           "room_" + std::to_string(room.id) + "_column_" + std::to_string(k + 1),
           {centre.x(), centre.y(), 0},
           std::abs(room.columns[k].area()),
           heightsOf(room),
           room.columns[k]});
    }
  return columns;
}

/** @brief Returns the distance of two columns; infinite if they are not alike. */
double
columnsApart(const Thing& a, const Thing& b)
{
  constexpr double max_ratio = 2; // of areas; hidden sides are inferred
  const bool is_alike = a.area < max_ratio * b.area && b.area < max_ratio * a.area &&
                        shareHeights(a.heights, b.heights);
  return is_alike ? (a.middle - b.middle).norm() : never;
}

std::vector<Thing>
openingsOf(const Floorplan& plan)
{
  std::vector<Thing> openings;
  for (std::size_t k = 0; k < plan.openings.size(); ++k) {
    const PlanOpening& o = plan.openings[k];
    const Eigen::Vector2d place = (o.start + o.end) / 2;
    openings.push_back({nameOf(o.kind),
                        "opening_" + std::to_string(k + 1),
                        {place.x(), place.y(), (o.bottom + o.top) / 2},
                        o.width() * o.height(),
                        {},
                        {{segment(o.start, o.end)}},
                        &o});
  }
  return openings;
}

/** @brief Returns the distance of the middles of two openings; infinite if they do not
 * share a part of a wall. */
double
openingsApart(const Thing& a, const Thing& b)
{
  constexpr double max_sine = 0.26;  // between their walls: 15 degrees
  constexpr double max_across = 0.5; // metres, between walls that face each other
  constexpr double max_moved = 0.8;  // of a wall; the other side of a corridor is more
  const PlanOpening& o = *a.opening;
  const Eigen::Vector2d way = (o.end - o.start).normalized();
  const Eigen::Vector2d other = (b.opening->end - b.opening->start).normalized();
  const Eigen::Vector3d off = b.middle - a.middle;
  const bool share =
      std::abs(way.x() * other.y() - way.y() * other.x()) < max_sine &&
      std::abs(way.x() * off.y() - way.y() * off.x()) <
          (way.dot(other) > 0 ? max_moved : max_across) &&
      2 * std::abs(off.head<2>().dot(way)) < o.width() + b.opening->width() &&
      2 * std::abs(off.z()) < o.height() + b.opening->height();
  return share ? off.norm() : never;
}

/** @brief Returns whether a plan has a wall where an opening is. */
bool
hasWallAt(const Floorplan& plan, const Eigen::Vector3d& middle)
{
  constexpr double near = 0.5; // of the middle of the wall, metres
  return std::any_of(plan.rooms.begin(), plan.rooms.end(), [&](const PlanRoom& room) {
    const RoomHeights heights = heightsOf(room);
    return heights.low < middle.z() && middle.z() < heights.high &&
           room.boundary.distance(middle.head<2>()) < near;
  });
}

/** @brief Returns whether a plan has the place where a thing could be. */
bool
hasPlaceOf(const Thing& thing, const Floorplan& plan)
{
  if (thing.opening)
    return thing.opening->kind != OpeningKind::Unknown && hasWallAt(plan, thing.middle);
  const auto rooms = roomsAt(plan, thing.heights);
  return std::any_of(rooms.begin(), rooms.end(), [&](const PlanRoom* room) {
    return room->contains(thing.middle.head<2>());
  });
}

void
addSingles(const std::vector<Thing>& things,
           const Floorplan& other,
           ChangeKind kind,
           std::vector<Change>& changes)
{
  for (const Thing& thing : things)
    if (hasPlaceOf(thing, other)) {
      changes.push_back({kind, thing.what, {}, {}, thing.area});
      changes.back().names() = {thing.name};
      changes.back().outlines = {thing.outline};
    }
}

} // namespace

std::vector<Change>
columnChanges(const Floorplan& before,
              const Floorplan& after,
              const CompareSettings& settings)
{
  std::vector<Change> changes;
  auto gone = columnsOf(before);
  auto come = columnsOf(after);
  for (const auto& [a, b] : takePairs(gone, come, settings.farthest, columnsApart))
    if (columnsApart(a, b) > settings.tolerance) {
      changes.push_back({ChangeKind::Moved, a.what, {a.name}, {b.name}, a.area});
      changes.back().shift = b.middle - a.middle;
      changes.back().outlines = {b.outline};
    }
  addSingles(gone, after, ChangeKind::Vanished, changes);
  addSingles(come, before, ChangeKind::Appeared, changes);
  return changes;
}

std::vector<Change>
openingChanges(const Floorplan& before,
               const Floorplan& after,
               const CompareSettings& settings)
{
  std::vector<Change> changes;
  if (before.openings.empty() || after.openings.empty())
    return changes; // nobody looked for them in one of the plans
  auto gone = openingsOf(before);
  auto come = openingsOf(after);
  takePairs(gone, come, settings.farthest, openingsApart);
  addSingles(gone, after, ChangeKind::Vanished, changes);
  addSingles(come, before, ChangeKind::Appeared, changes);
  return changes;
}

} // namespace pcl::sedr::tools
