// SPDX-License-Identifier: BSD-3-Clause
#include "room_references.h"

#include "../base/number_text.h"
#include "../plan/opening_wall.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace pcl::sedr {

bool
isSame(const PlanLoop& a, const PlanLoop& b)
{
  return std::equal(a.elements.begin(), a.elements.end(), b.elements.begin(),
                    b.elements.end(), [](const PlanElement& e, const PlanElement& f) {
                      return e.start == f.start && e.end == f.end &&
                             e.centre == f.centre && e.radius == f.radius;
                    });
}

std::optional<std::size_t>
elementLike(const PlanRoom& room, const PlanElement& wall)
{
  const std::vector<PlanElement>& walls = room.boundary.elements;
  for (std::size_t k = 0; k < walls.size(); ++k)
    if (isSame({{walls[k]}}, {{wall}}))
      return k;
  return {};
}

namespace {

/** @brief Returns an opening as it was before an edit. */
const PlanOpening&
openingBefore(const Floorplan& before, const PlanOpening& opening)
{
  const auto was = std::find_if(
      before.openings.begin(), before.openings.end(), [&](const PlanOpening& o) {
        return o.number == opening.number && o.kind == opening.kind;
      });
  return was == before.openings.end() ? opening : *was;
}

/** @brief Returns the walls that an opening was in. */
std::vector<PlanElement>
wallsOf(const Floorplan& plan, const PlanOpening& opening)
{
  std::vector<PlanElement> walls;
  for (const OpeningWall& wall : opening.walls)
    if (const PlanRoom* const room = findRoom(plan, wall.room);
        room && wall.element < room->boundary.elements.size())
      walls.push_back(room->boundary.elements[wall.element]);
  return walls;
}

constexpr double negligible = 0.01; // metres

std::string
placeText(const char* what, const Eigen::Vector2d& at)
{
  return formatText("the %s at (%.2f, %.2f)", what, at.x(), at.y());
}

/** @brief Returns how far an opening reaches beyond the ends of a wall. */
double
beyondWall(const PlanOpening& opening, const PlanElement& wall)
{
  double most = 0;
  for (const Eigen::Vector2d& end : {opening.start, opening.end}) {
    const double s = wall.project(end);
    const Eigen::Vector2d off = end - wall.pointAt(s);
    const Eigen::Vector2d normal = wall.normalAt(s);
    most = std::max(most, std::abs(off.x() * normal.y() - off.y() * normal.x()));
  }
  return most;
}

/** @brief The room that a flight is in, and how far the flight reaches out of it. */
struct FlightRoom {
  std::uint32_t room = 0;
  double outside = std::numeric_limits<double>::infinity();
};

FlightRoom
roomAround(const Floorplan& plan, const PlanFlight& flight)
{
  const auto heightIn = [](const PlanRoom& room, const Eigen::Vector2d& p, double z) {
    return room.floor.heightAt(p) < z && room.ceiling.heightAt(p) > z;
  };
  const Eigen::Vector2d middle = flight.middle(flight.steps() / 2);
  FlightRoom best;
  for (const PlanRoom& room : plan.rooms) {
    if (!heightIn(room, middle, (flight.bottom + flight.top()) / 2))
      continue;
    double outside = 0;
    bool is_in = false;
    for (const Eigen::Vector2d& corner : flight.outline())
      if (room.boundary.contains(corner))
        is_in = true;
      else
        outside = std::max(outside, room.boundary.distance(corner));
    if (is_in && outside < best.outside)
      best = {room.id, outside};
  }
  return best;
}

} // namespace

void
forEachReference(Floorplan& plan,
                 const std::function<void(std::uint32_t&, const Eigen::Vector2d&)>& see)
{
  for (PlanOpening& opening : plan.openings) {
    const Eigen::Vector2d middle = (opening.start + opening.end) / 2;
    for (std::uint32_t* of : {&opening.rooms[0], &opening.rooms[1], &opening.swing})
      see(*of, middle);
    for (OpeningWall& wall : opening.walls)
      see(wall.room, middle);
  }
  for (PlanStair& stair : plan.stairs) {
    const auto& flights = stair.flights;
    see(stair.rooms[0], flights.empty() ? stair.at : flights.front().middle(0));
    see(stair.rooms[1],
        flights.empty() ? stair.at : flights.back().middle(flights.back().steps() - 1));
  }
}

void
renumber(Floorplan& plan, std::uint32_t from, std::uint32_t to)
{
  for (PlanOpening& opening : plan.openings)
    if (std::minmax(opening.rooms[0], opening.rooms[1]) == std::minmax(from, to))
      opening.walls.clear(); // it was between them
  forEachReference(plan, [&](std::uint32_t& room, const Eigen::Vector2d&) {
    room = room == from ? to : room;
  });
  const auto removeIf = [](auto& list, const auto& goes) {
    list.erase(std::remove_if(list.begin(), list.end(), goes), list.end());
  };
  for (PlanOpening& opening : plan.openings)
    removeIf(opening.walls, [](const OpeningWall& wall) { return wall.room == 0; });
  removeIf(plan.stairs, [](const PlanStair& stair) { return !stair.leadsSomewhere(); });
  for (PlanStorey& storey : plan.storeys)
    removeIf(storey.rooms, [from](std::uint32_t room) { return room == from; });
  removeIf(plan.storeys, [](const PlanStorey& storey) { return storey.rooms.empty(); });
}

std::vector<std::string>
attachOpenings(const Floorplan& before, Floorplan& plan, double max_wall)
{
  std::vector<std::string> told;
  const auto attach = [&](PlanOpening& opening) {
    const Eigen::Vector2d middle = (opening.start + opening.end) / 2;
    const std::string what =
        markOf(opening) + ": " +
        placeText(opening.kind == OpeningKind::Unknown ? "opening"
                                                       : nameOf(opening.kind),
                  middle);
    const PlanOpening& was = openingBefore(before, opening);
    const std::vector<PlanElement> before_walls = wallsOf(before, was);
    std::vector<OpeningWall> walls;
    for (const OpeningWall& wall : opening.walls) {
      const PlanRoom* const room = findRoom(plan, wall.room);
      if (!room)
        continue;
      std::optional<std::size_t> element;
      double known = 0; // how far it reached beyond a wall
      for (const PlanElement& old : before_walls) {
        element = element ? element : elementLike(*room, old);
        known = std::max(known, beyondWall(opening, old));
      }
      const bool is_same = element.has_value();
      if (!is_same)
        element = wallBeside(*room, opening);
      if (!element)
        continue;
      walls.push_back({wall.room, *element});
      const double beyond = beyondWall(opening, room->boundary.elements[*element]);
      if (!is_same && beyond > negligible + known)
        told.push_back(what +
                       formatText(", %.2f m wide, reaches %.2f m beyond wall ",
                                  opening.width(), beyond) +
                       std::to_string(wall.room) + "." + std::to_string(*element + 1));
    }
    opening.walls = walls;
    const bool is_between_none =
        opening.rooms != was.rooms && opening.rooms[0] == opening.rooms[1];
    const bool goes = walls.empty() && (!was.walls.empty() || is_between_none);
    if (goes)
      told.push_back(what + " is in no wall any more: it is left out");
    else if (walls.size() < was.walls.size() ||
             (opening.depth > max_wall && was.depth <= max_wall))
      told.push_back(
          what +
          " is in no wall between its rooms any more: the IFC may be without it");
    return goes;
  };
  plan.openings.erase(
      std::remove_if(plan.openings.begin(), plan.openings.end(), attach),
      plan.openings.end());
  return told;
}

std::vector<std::string>
flightsThroughWalls(const Floorplan& before, const Floorplan& plan)
{
  std::vector<std::string> told;
  for (const PlanStair& stair : plan.stairs)
    for (const PlanFlight& flight : stair.flights) {
      const FlightRoom old = roomAround(before, flight);
      const FlightRoom now = roomAround(plan, flight);
      if (now.outside <= old.outside + negligible)
        continue;
      const std::string what =
          placeText("flight of stairs", flight.middle(flight.steps() / 2));
      told.push_back(now.room == 0
                         ? what + " is in no room any more"
                         : what + formatText(", from z %.2f to %.2f m, reaches %.2f m "
                                             "through a wall of room %.0f",
                                             flight.bottom, flight.top(), now.outside,
                                             static_cast<double>(now.room)));
    }
  return told;
}

} // namespace pcl::sedr
