// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_loops.h"

#include <pcl/sedr_surface/room_solid.h>

#include "sedr_surface/src/solid/plan_subdivision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace sedr_test {

/** A room of 4 m x 3 m, 2.5 m high, with a detail 1 m wide along the wall y = 3. */
inline pcl::sedr::PlanRoom
roomWithSoffit(const pcl::sedr::PlanSlab& slab)
{
  pcl::sedr::PlanRoom room = roomOf(rectangle(0, 0, 4, 3), 2.5);
  room.details = {detailOf(rectangle(0, 2, 4, 3), 0)};
  room.details[0].slab = slab;
  return room;
}

/** A room's plan cut into regions. */
struct SubdividedRoom {
  explicit SubdividedRoom(const pcl::sedr::PlanRoom& plan)
      : room(plan)
      , layers(room)
      , problem(pcl::sedr::subdivideRoom(layers, {}, subdivision, warnings))
      , spokes(pcl::sedr::spokesOf(subdivision))
  {}

  pcl::sedr::PlanRoom room;
  pcl::sedr::RoomLayers layers; ///< of `room`
  pcl::sedr::PlanSubdivision subdivision;
  std::vector<std::string> warnings;
  std::string problem;
  std::vector<std::vector<pcl::sedr::Spoke>> spokes;
};

} // namespace sedr_test
