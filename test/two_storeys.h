// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_loops.h"

namespace sedr_test {

/** A room of a storey with its own floor and ceiling heights. */
inline pcl::sedr::PlanRoom
roomBetween(const pcl::sedr::PlanLoop& boundary,
            double floor,
            double ceiling,
            std::uint32_t id)
{
  pcl::sedr::PlanRoom room = roomOf(boundary, ceiling, id);
  room.floor = slabAt(floor);
  return room;
}

/** Two rooms, 4 x 3 m and 5 x 3 m, with 10 cm of wall between them; ids from
 * `first_id`. That wall and the back wall of the second room are shifted by `shift`
 * metres. */
inline std::vector<pcl::sedr::PlanRoom>
storeyBetween(double floor, double ceiling, std::uint32_t first_id, double shift = 0)
{
  return {roomBetween(rectangle(0, 0, 4 + shift, 3), floor, ceiling, first_id),
          roomBetween(rectangle(4.1 + shift, 0, 9.1, 3 + shift), floor, ceiling,
                      first_id + 1)};
}

/** Rooms 1 and 2 from 0 to 2.5 m, and rooms 3 and 4 above them from 2.8 to 5.2 m, with
 * walls shifted by `shift`. */
inline pcl::sedr::Floorplan
twoStoreys(double shift = 0)
{
  pcl::sedr::Floorplan plan;
  plan.rooms = storeyBetween(0, 2.5, 1);
  for (const auto& room : storeyBetween(2.8, 5.2, 3, shift))
    plan.rooms.push_back(room);
  return plan;
}

/** An opening by its ends in the middle of its wall. */
inline pcl::sedr::PlanOpening
openingOf(pcl::sedr::OpeningKind kind,
          const std::array<std::uint32_t, 2>& rooms,
          const std::vector<pcl::sedr::OpeningWall>& walls,
          const Eigen::Vector2d& start,
          const Eigen::Vector2d& end,
          double bottom,
          double top,
          double depth = 0)
{
  return {kind, rooms, walls, start, end, bottom, top, 0, depth};
}

/** A door of all kinds of parts in a wall of room 3 along x. */
inline pcl::sedr::PlanOpening
ajarDoor()
{
  pcl::sedr::PlanOpening door{
      pcl::sedr::OpeningKind::Door, {3, 0}, {{3, 0}}, {1, -0.1}, {1.9, -0.1}, 0, 2.05};
  door.rise = 0.2;
  door.depth = 0.2;
  door.hinge = pcl::sedr::OpeningHinge::End;
  door.swing = 3;
  door.state = pcl::sedr::OpeningState::Ajar;
  door.confidence = 0.9;
  door.residual = 0.003;
  door.deviation_95 = 0.007;
  door.edges = {{{pcl::sedr::EdgeSeen::Nothing, 0}, // the list is told all the same
                 {pcl::sedr::EdgeSeen::Reveal, 0.003},
                 {pcl::sedr::EdgeSeen::Rim, 0.01},
                 {pcl::sedr::EdgeSeen::Leaf, 0.02}}};
  return door;
}

} // namespace sedr_test
