// SPDX-License-Identifier: BSD-3-Clause
#include "doorway_drawing.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {
namespace {

constexpr double farthest_face = 0.5; ///< metres, from the middle of a wall

const PlanRoom*
roomOf(const Floorplan& plan, std::uint32_t id)
{
  const auto found = std::find_if(plan.rooms.begin(), plan.rooms.end(),
                                  [id](const PlanRoom& room) { return room.id == id; });
  return found == plan.rooms.end() ? nullptr : &*found;
}

/** @brief Distances of a face from the two ends of a doorway; positive to the left of
 * the doorway's direction. */
using FaceOffsets = Eigen::Vector2d;

/** @brief Returns the offsets of the room's wall nearest to the middle of a doorway; 0
 * if it is too far to belong to that wall. A straight wall may be slightly oblique. */
FaceOffsets
offsetsOf(const PlanRoom& room,
          const PlanDoorway& doorway,
          const Eigen::Vector2d& way,
          const Eigen::Vector2d& left)
{
  const Eigen::Vector2d middle = (doorway.start + doorway.end) / 2;
  const PlanElement& wall = room.boundary.elements[room.boundary.nearest(middle)];
  const Eigen::Vector2d to = wall.pointAt(wall.project(middle)) - middle;
  if (to.norm() > farthest_face)
    return FaceOffsets::Zero();
  const Eigen::Vector2d along = wall.end - wall.start;
  constexpr double steepest = 0.2;
  if (wall.isArc() || std::abs(along.dot(left)) > steepest * std::abs(along.dot(way)))
    return FaceOffsets::Constant(to.dot(left));
  const double slope = along.dot(left) / along.dot(way);
  const double at_start = (wall.start - doorway.start).dot(left) -
                          slope * (wall.start - doorway.start).dot(way);
  return {at_start, at_start + slope * doorway.width()};
}

/** @brief Returns a doorway along the nearest straight wall of one of its rooms, if it
 * is within 30 degrees of it. */
PlanDoorway
alongItsWall(const Floorplan& plan, PlanDoorway doorway)
{
  constexpr double min_cosine = 0.866;
  const Eigen::Vector2d middle = (doorway.start + doorway.end) / 2;
  const Eigen::Vector2d way = doorway.end - doorway.start;
  const PlanElement* nearest = nullptr;
  for (const std::uint32_t id : doorway.rooms) {
    const PlanRoom* room = roomOf(plan, id);
    if (!room || room->boundary.elements.empty())
      continue;
    const PlanElement& wall = room->boundary.elements[room->boundary.nearest(middle)];
    if (!nearest || wall.distance(middle) < nearest->distance(middle))
      nearest = &wall;
  }
  if (!nearest || nearest->isArc() || nearest->distance(middle) > farthest_face)
    return doorway;
  const Eigen::Vector2d along = (nearest->end - nearest->start).normalized();
  const double length = along.dot(way);
  if (std::abs(length) < min_cosine * way.norm())
    return doorway;
  doorway.start = middle - length / 2 * along;
  doorway.end = middle + length / 2 * along;
  return doorway;
}

/** @brief Cuts off the ends of a doorway beside which one of its rooms has ended. */
PlanDoorway
withinRooms(const Floorplan& plan, PlanDoorway doorway)
{
  constexpr double step = 0.01;
  constexpr double inside = 0.05; // of a face
  const double width = doorway.width();
  const Eigen::Vector2d way = (doorway.end - doorway.start) / width;
  const Eigen::Vector2d left(-way.y(), way.x());
  double from = 0;
  double to = width;
  for (const std::uint32_t id : doorway.rooms) {
    const PlanRoom* room = roomOf(plan, id);
    if (!room || room->boundary.elements.empty())
      continue;
    const FaceOffsets face = offsetsOf(*room, doorway, way, left);
    const auto isBeside = [&](double s, double side) {
      const double off = face[0] + s / width * (face[1] - face[0]) + side * inside;
      return room->contains(doorway.start + s * way + off * left);
    };
    const double middle = width / 2;
    const double side = isBeside(middle, 1) ? 1 : -1;
    if (!isBeside(middle, side))
      continue;
    double low = middle;
    double high = middle;
    while (low > from && isBeside(std::max(low - step, 0.0), side))
      low -= step;
    while (high < to && isBeside(std::min(high + step, width), side))
      high += step;
    from = std::max(from, low);
    to = std::min(to, high);
  }
  if (to - from < width / 2)
    return doorway;
  const Eigen::Vector2d start = doorway.start;
  doorway.start = start + from * way;
  doorway.end = start + to * way;
  return doorway;
}

} // namespace

std::vector<DrawnDoorway>
drawnDoorways(const Floorplan& plan)
{
  std::vector<DrawnDoorway> drawn;
  for (const PlanDoorway& found : plan.doorways) {
    if (!(found.width() > 0))
      continue;
    const PlanDoorway doorway = withinRooms(plan, alongItsWall(plan, found));
    const Eigen::Vector2d way = (doorway.end - doorway.start) / doorway.width();
    const Eigen::Vector2d left(-way.y(), way.x());
    std::vector<FaceOffsets> faces;
    for (const std::uint32_t id : doorway.rooms) {
      const PlanRoom* room = roomOf(plan, id);
      if (!room || room->boundary.elements.empty())
        continue;
      faces.push_back(offsetsOf(*room, doorway, way, left));
    }
    if (faces.empty())
      faces.emplace_back(FaceOffsets::Zero());
    FaceOffsets low = faces.front().cwiseMin(faces.back());
    FaceOffsets high = faces.front().cwiseMax(faces.back());
    const bool leads_outside =
        !roomOf(plan, doorway.rooms[0]) || !roomOf(plan, doorway.rooms[1]);
    if (leads_outside) {
      high = high.cwiseMax(-low);
      low = -high;
    }
    drawn.push_back({{doorway.start + low[0] * left, doorway.end + low[1] * left,
                      doorway.end + high[1] * left, doorway.start + high[0] * left},
                     doorway.width(),
                     doorway.top - doorway.bottom});
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

} // namespace pcl::sedr
