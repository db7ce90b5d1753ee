// SPDX-License-Identifier: BSD-3-Clause
#include "room_references.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace pcl::sedr {

namespace {

/** @brief Returns whether two outlines have the same corners and arcs. */
bool
isSame(const PlanLoop& a, const PlanLoop& b)
{
  return std::equal(a.elements.begin(), a.elements.end(), b.elements.begin(),
                    b.elements.end(), [](const PlanElement& e, const PlanElement& f) {
                      return e.start == f.start && e.end == f.end &&
                             e.centre == f.centre && e.radius == f.radius;
                    });
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
  for (PlanDoorway& doorway : plan.doorways)
    for (std::uint32_t& of : doorway.rooms)
      see(of, (doorway.start + doorway.end) / 2);
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
  forEachReference(plan, [&](std::uint32_t& room, const Eigen::Vector2d&) {
    room = room == from ? to : room;
  });
  const auto removeIf = [](auto& list, const auto& goes) {
    list.erase(std::remove_if(list.begin(), list.end(), goes), list.end());
  };
  const auto leadsNowhere = [](const auto& link) { return !link.leadsSomewhere(); };
  removeIf(plan.openings, [&](PlanOpening& opening) {
    removeIf(opening.walls, [](const OpeningWall& wall) { return wall.room == 0; });
    return opening.rooms[0] == opening.rooms[1] || opening.walls.empty();
  });
  removeIf(plan.doorways, leadsNowhere);
  removeIf(plan.stairs, leadsNowhere);
  for (PlanStorey& storey : plan.storeys)
    removeIf(storey.rooms, [from](std::uint32_t room) { return room == from; });
  removeIf(plan.storeys, [](const PlanStorey& storey) { return storey.rooms.empty(); });
}

void
attachOpenings(const Floorplan& before, Floorplan& plan)
{
  constexpr double reach = 0.5; // metres from the face
  const auto attach = [&](PlanOpening& opening) {
    const Eigen::Vector2d middle = (opening.start + opening.end) / 2;
    const Eigen::Vector2d way = (opening.end - opening.start).normalized();
    std::vector<OpeningWall> walls;
    for (const OpeningWall& wall : opening.walls) {
      const PlanRoom* const room = findRoom(plan, wall.room);
      if (!room)
        continue;
      const PlanRoom* const old = findRoom(before, wall.room);
      if (old && isSame(old->boundary, room->boundary)) {
        walls.push_back(wall);
        continue;
      }
      double nearest = opening.depth / 2 + reach;
      std::optional<std::size_t> element;
      for (std::size_t e = 0; e < room->boundary.elements.size(); ++e) {
        const PlanElement& candidate = room->boundary.elements[e];
        const double distance = candidate.distance(middle);
        const double s = candidate.project(middle);
        if (distance < nearest && std::abs(candidate.normalAt(s).dot(way)) < 0.5) {
          nearest = distance;
          element = e;
        }
      }
      if (element)
        walls.push_back({wall.room, *element});
    }
    opening.walls = walls;
    return walls.empty();
  };
  plan.openings.erase(
      std::remove_if(plan.openings.begin(), plan.openings.end(), attach),
      plan.openings.end());
}

} // namespace pcl::sedr
