// SPDX-License-Identifier: BSD-3-Clause
#include "doorway_drawing.h"

#include <algorithm>

namespace pcl {
namespace sedr {
namespace {

constexpr double farthest_face = 0.5; ///< from the middle of a wall, metres

const PlanRoom*
roomOf(const Floorplan& plan, std::uint32_t id)
{
  const auto found = std::find_if(plan.rooms.begin(), plan.rooms.end(),
                                  [id](const PlanRoom& room) { return room.id == id; });
  return found == plan.rooms.end() ? nullptr : &*found;
}

/** @brief How far a room's nearest wall is from a place in the middle of a wall, to the
 * left of a way (negative: to its right); 0 where it is too far to be of that wall. */
double
offsetOf(const PlanRoom& room,
         const Eigen::Vector2d& place,
         const Eigen::Vector2d& left)
{
  const PlanElement& wall = room.boundary.elements[room.boundary.nearest(place)];
  const Eigen::Vector2d to = wall.pointAt(wall.project(place)) - place;
  return to.norm() <= farthest_face ? to.dot(left) : 0;
}

} // namespace

std::vector<DrawnDoorway>
drawnDoorways(const Floorplan& plan)
{
  std::vector<DrawnDoorway> drawn;
  for (const PlanDoorway& doorway : plan.doorways) {
    if (!(doorway.width() > 0))
      continue;
    const Eigen::Vector2d way = (doorway.end - doorway.start) / doorway.width();
    const Eigen::Vector2d left(-way.y(), way.x());
    double low = 0;
    double high = 0;
    for (const std::uint32_t id : doorway.rooms) {
      const PlanRoom* room = roomOf(plan, id);
      if (!room || room->boundary.elements.empty())
        continue;
      const double offset = offsetOf(*room, (doorway.start + doorway.end) / 2, left);
      low = std::min(low, offset);
      high = std::max(high, offset);
    }
    const bool leads_outside =
        !roomOf(plan, doorway.rooms[0]) || !roomOf(plan, doorway.rooms[1]);
    if (leads_outside) {
      high = std::max(high, -low);
      low = -high;
    }
    drawn.push_back({{doorway.start + low * left, doorway.end + low * left,
                      doorway.end + high * left, doorway.start + high * left}});
  }
  return drawn;
}

std::vector<StairNote>
stairNotes(const Floorplan& plan)
{
  std::vector<StairNote> notes;
  for (const PlanStair& stair : plan.stairs) {
    const bool is_up = roomOf(plan, stair.rooms[0]);
    if (!is_up && !roomOf(plan, stair.rooms[1]))
      continue;
    const std::uint32_t other = stair.rooms[is_up ? 1 : 0];
    std::string text = is_up ? "up" : "down";
    if (other != 0)
      text += " to room " + std::to_string(other);
    notes.push_back({stair.at, text});
  }
  return notes;
}

} // namespace sedr
} // namespace pcl
