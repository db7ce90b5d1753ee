// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "compare/comparison.h"
#include "plan_loops.h"

#include <string>

namespace programs {

/** A room with its floor at 0 and its ceiling at 2.8 m. */
inline pcl::sedr::PlanRoom
boxRoomOf(std::uint32_t id, double x0, double y0, double x1, double y1)
{
  return sedr_test::roomOf(sedr_test::rectangle(x0, y0, x1, y1), 2.8, id);
}

/** The outline of a column, clockwise. */
inline pcl::sedr::PlanLoop
columnLoop(double x0, double y0, double x1, double y1)
{
  return sedr_test::polygon({{x0, y1}, {x1, y1}, {x1, y0}, {x0, y0}});
}

/** Two rooms 4.5 m deep, 9 m long in total, with a partition of 10 cm between them. */
inline pcl::sedr::Floorplan
twoRooms(double partition = 5)
{
  return {
      {boxRoomOf(1, 0, 0, partition, 4.5), boxRoomOf(2, partition + 0.1, 0, 9, 4.5)}};
}

/** The two rooms, and two above them with ids from 3. */
inline pcl::sedr::Floorplan
storeysWith(double lower_partition = 5, double upper_partition = 5, double up = 3)
{
  pcl::sedr::Floorplan plan = twoRooms(lower_partition);
  for (pcl::sedr::PlanRoom& room : twoRooms(upper_partition).rooms) {
    room.id += 2;
    room.floor = sedr_test::slabAt(up);
    room.ceiling = sedr_test::slabAt(up + 2.5);
    plan.rooms.push_back(room);
  }
  return plan;
}

using Lines = std::vector<std::string>;

/** Describes every change between two plans. */
inline Lines
told(const pcl::sedr::Floorplan& before, const pcl::sedr::Floorplan& after)
{
  Lines lines;
  for (const auto& change : pcl::sedr::tools::comparePlans(before, after, {}))
    lines.push_back(describe(change));
  return lines;
}

} // namespace programs
