// SPDX-License-Identifier: BSD-3-Clause
#include "segmented_rooms.h"

#include <pcl/sedr_segmentation/enclosed_regions.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::sedr;
using namespace sedr_test;

namespace {

/** Which cells of the highest level count as a room if none was kept. */
CellSet
enclosedOf(const RoomPoints& points)
{
  const SegmentedRooms scene(points);
  const std::size_t ceiling = scene.levels.size() - 1;
  RegionMap map;
  map.cell_size = 0.05;
  map.cells = scene.levels[ceiling].cells;
  map.regions = labelRegions(map.cells);
  map.number.assign(map.regions.sizes.size(), 0);
  return enclosedRegions(map, scene.levels, ceiling, points.view(), points.all(), {});
}

/** A room of 3 x 2 metres of whose floor a third was seen. */
RoomPoints
smallRoom(const RoomPoints::OnWall& on_front)
{
  RoomPoints points;
  const PlanLoop room = rectangle(0.01, 0.01, 3.01, 2.01);
  points.slab(room, 0, [](double x, double) { return x < 1.01; });
  points.slab(room, 2.5);
  points.wall(room.elements[0], 0, 2.5, on_front);
  for (std::size_t e = 1; e < 4; ++e)
    points.wall(room.elements[e], 0, 2.5);
  return points;
}

} // namespace

TEST(EnclosedRegions, ARoomWithAnOpenDoorIsOne)
{
  const CellSet enclosed = enclosedOf(
      smallRoom([](double s, double z) { return s < 0.1 || s > 1 || z > 2.05; }));
  EXPECT_NEAR(static_cast<double>(enclosed.size()) * 0.0025, 6, 0.3);
}

TEST(EnclosedRegions, WallsAreAroundFourFifthsOfOne)
{
  // What is within 0.6 m of a wall has one: of an outline of 10 m, 1.2 m more are open.
  for (const double share : {0.86, 0.74}) {
    const double open = (1 - share) * 10 / 2; // of either side
    RoomPoints points;
    const PlanLoop room = rectangle(0.01, 0.01, 3.01, 2.01);
    points.slab(room, 0, [](double x, double) { return x > 1.01 && x < 2.01; });
    points.slab(room, 2.5);
    for (const std::size_t e : {1u, 3u})
      points.wall(room.elements[e], 0, 2.5);
    for (const std::size_t e : {0u, 2u})
      points.wall(room.elements[e], 0, 2.5,
                  [&](double s, double) { return std::abs(s - 1.5) > open / 2 + 0.6; });
    EXPECT_EQ(enclosedOf(points).empty(), share < 0.8) << share;
  }
}

TEST(EnclosedRegions, WhatWasSeenOfOneThroughADoorIsNone)
{
  // A doorway in y = 0 shows the far wall and what is before it, nothing of the others.
  RoomPoints points;
  const PlanLoop room = rectangle(0.01, 0.01, 3.01, 2.01);
  points.slab(room, 0, [](double x, double) { return x > 0.61 && x < 1.61; });
  points.slab(room, 2.5, [](double, double y) { return y > 0.81; });
  points.wall(room.elements[2], 0, 2.5);
  EXPECT_TRUE(enclosedOf(points).empty());
}

TEST(EnclosedRegions, NeitherIsOneWithoutAnyFloor)
{
  RoomPoints points;
  const PlanLoop room = rectangle(0.01, 0.01, 3.01, 2.01);
  points.slab(rectangle(4.01, 0.01, 7.01, 2.01), 0);
  points.slab(room, 2.5);
  for (const auto& wall : room.elements)
    points.wall(wall, 0, 2.5);
  EXPECT_TRUE(enclosedOf(points).empty());
}
