// SPDX-License-Identifier: BSD-3-Clause
#include "unlikely_places.h"

#include "../sheet/text_places.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

constexpr double min_room_area = 2;    // square metres
constexpr double min_room_width = 0.8; // metres, of the largest circle in it
constexpr double min_height = 2;       // metres
constexpr double max_height = 6;       // metres
constexpr double max_walls = 8;        // in 10 m, and of a room
constexpr double min_door_width = 0.7; // metres
constexpr double min_storey_area = 5;  // square metres
constexpr double min_noise = 0.005;    // metres
constexpr double in_line = 0.05;       // metres, of what lies on one line
constexpr double worth_word = 0.5;     // metres, of walls and edges
constexpr double most_walled = 0.55;   // of the outline of what stands in a corner

/** @brief Checks whether a door, passage or stair leads into a room. */
bool
hasWayIn(const Floorplan& plan, std::uint32_t room)
{
  const auto leadsIn = [room](const auto& way) {
    return way.rooms[0] == room || way.rooms[1] == room;
  };
  return std::any_of(plan.openings.begin(), plan.openings.end(),
                     [&](const PlanOpening& opening) {
                       return opening.kind != OpeningKind::Window && leadsIn(opening);
                     }) ||
         std::any_of(plan.stairs.begin(), plan.stairs.end(), leadsIn);
}

/** @brief Returns how far the middle of an arc is off its chord, metres. */
double
riseOf(const PlanElement& arc)
{
  return (arc.pointAt(arc.length() / 2) - (arc.start + arc.end) / 2).norm();
}

/** @brief Returns how much of an edge lies on the line of a wall, metres. */
double
lengthAlong(const PlanElement& edge, const PlanElement& wall, bool on_wall)
{
  const double length = wall.length();
  const Eigen::Vector2d along = (wall.end - wall.start) / length;
  const auto placeOf = [&](const Eigen::Vector2d& p) {
    const Eigen::Vector2d d = p - wall.start;
    const double off = along.x() * d.y() - along.y() * d.x();
    return Eigen::Vector2d(along.dot(d), std::abs(off));
  };
  const Eigen::Vector2d a = placeOf(edge.start), b = placeOf(edge.end);
  if (edge.isArc() || wall.isArc() || !(length > 0) || a.y() > in_line ||
      b.y() > in_line)
    return 0;
  const auto [low, high] = std::minmax(a.x(), b.x());
  if (low > length + in_line || high < -in_line)
    return 0; // they do not meet
  const double both = std::max(0.0, std::min(high, length) - std::max(low, 0.0));
  return on_wall ? both : high - low - both;
}

/** @brief Returns how much of an edge lies on the outline of a room, metres. */
double
lengthOnWalls(const PlanElement& edge, const PlanRoom& room)
{
  double length = 0;
  for (const PlanElement& wall : room.boundary.elements)
    length += lengthAlong(edge, wall, true);
  return length;
}

/** @brief Returns for how long edges of soffits go on along the line of a wall where it
 * ends, and no other wall is, metres. */
double
soffitInLine(const PlanRoom& room, const PlanElement& wall)
{
  double length = 0;
  for (const PlanDetail& detail : room.details)
    for (const PlanElement& edge : detail.boundary.elements)
      if (const double beyond = lengthAlong(edge, wall, false); beyond > 0)
        length += beyond - lengthOnWalls(edge, room) + lengthAlong(edge, wall, true);
  return length;
}

/** @brief Returns the share of the outline of a detail that lies at walls. */
double
walledShare(const PlanDetail& detail, const PlanRoom& room)
{
  double walled = 0;
  for (const PlanElement& edge : detail.boundary.elements)
    walled += lengthOnWalls(edge, room);
  return walled / detail.boundary.length();
}

void
addRoom(const Floorplan& plan, const PlanRoom& room, std::vector<PlanWarning>& found)
{
  const TextSpot spot = textSpotIn(room.boundary, room.columns);
  const auto addAt = [&](const Eigen::Vector2d& place, std::size_t wall,
                         WarningKind kind, std::vector<double> values) {
    found.push_back({kind, std::move(values), room.id, wall, {}, place});
  };
  const auto add = [&](WarningKind kind, double value) {
    addAt(spot.place, 0, kind, {value});
  };
  const std::vector<PlanElement>& walls = room.boundary.elements;
  if (!hasWayIn(plan, room.id))
    add(WarningKind::NoDoor, room.area());
  if (room.area() < min_room_area)
    add(WarningKind::SmallRoom, room.area());
  if (2 * spot.radius < min_room_width)
    add(WarningKind::NarrowRoom, 2 * spot.radius);
  const ClearHeight height = clearHeight(room);
  if (height.least < 0)
    addAt(height.lowest, 0, WarningKind::Height, {height.least});
  else if (height.usual < min_height || height.usual > max_height)
    add(WarningKind::Height, height.usual);
  const double density = 10 * static_cast<double>(walls.size()) / room.perimeter();
  if (static_cast<double>(walls.size()) > max_walls && density > max_walls)
    add(WarningKind::Ragged, density);
  for (std::size_t e = 0; e < walls.size(); ++e)
    if (walls[e].isArc() &&
        riseOf(walls[e]) < 2 * std::max(walls[e].residual, min_noise))
      addAt(walls[e].pointAt(walls[e].length() / 2), e + 1, WarningKind::FlatArc,
            {100 * riseOf(walls[e]), walls[e].radius});
    else if (const double edge = soffitInLine(room, walls[e]);
             walls[e].length() >= worth_word && edge >= worth_word)
      addAt(walls[e].pointAt(walls[e].length() / 2), e + 1, WarningKind::InLine,
            {edge});
  for (const PlanDetail& detail : room.floor_details) {
    const Eigen::Vector2d middle = textSpotIn(detail.boundary, {}).place;
    const double rise = detail.slab.heightAt(middle) - room.floor.heightAt(middle);
    if (rise > 0 && walledShare(detail, room) < most_walled)
      addAt(middle, 0, WarningKind::RaisedFloor, {detail.boundary.area(), rise});
  }
}

} // namespace

std::vector<PlanWarning>
unlikelyPlaces(const Floorplan& plan)
{
  std::vector<PlanWarning> found;
  for (const PlanRoom& room : plan.rooms)
    addRoom(plan, room, found);
  for (const PlanOpening& opening : plan.openings)
    if (opening.kind == OpeningKind::Door && opening.width() < min_door_width)
      found.push_back({WarningKind::NarrowDoor,
                       {opening.width()},
                       std::max(opening.rooms[0], opening.rooms[1]),
                       0,
                       {},
                       (opening.start + opening.end) / 2});
  for (const PlanStorey& storey : storeysOf(plan)) {
    const Floorplan part = partOf(plan, storey);
    double area = 0;
    for (const PlanRoom& room : part.rooms)
      area += room.area();
    if (area < min_storey_area)
      found.push_back({WarningKind::SmallStorey,
                       {area},
                       0,
                       0,
                       storey.name,
                       textSpotIn(part.rooms[0].boundary, {}).place});
  }
  std::stable_sort(
      found.begin(), found.end(),
      [](const PlanWarning& a, const PlanWarning& b) { return a.kind < b.kind; });
  return found;
}

} // namespace pcl::sedr
