// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/rooms/room_gaps.h"

#include "room_points.h"
#include "sedr_filters/src/grids/cell_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Two rooms with a partition of 10 cm between y = 0 and y = 0.1, from x = 0 to x = 2,
 * turned about z. The ceiling of the upper room begins 5 cm behind its face, the lower
 * one's reaches up to the partition. Returns the shares of both faces' points that are
 * of their own rooms: of the upper face, and of the lower one above a height. */
std::pair<double, double>
sharesOfFaces(double degrees, double from)
{
  const Eigen::Vector2d shift(0.013, 0.021); // no face along a line of the grid
  const CellGrid grid(0.05);
  std::vector<RoomGap> gaps;
  const auto addRoom = [&](std::uint32_t room, double low, double high) {
    RoomPoints points(0.0225);
    points.slab(placed(rectangle(0, low, 2, high), degrees, shift), 2.5);
    const CellSet cells(grid, points.view(), points.all());
    for (std::size_t k = 0; k < cells.size(); ++k)
      gaps.push_back({cells[k], room, 0, 2.5F, 0});
  };
  addRoom(1, -1, -0.01);
  addRoom(2, 0.15, 1);
  const RoomGaps rooms(grid, gaps);
  RoomPoints points(0.045, 0.01);
  const auto shareOf = [&](std::uint32_t room, double y, double low) {
    const PlanLoop face = placed({{segment({0.2, y}, {1.8, y})}}, degrees, shift);
    const std::vector<int> all = points.wall(face.elements[0], low, 2.4);
    return static_cast<double>(std::count_if(
               all.begin(), all.end(),
               [&](int i) { return rooms.ownerOf(points[i]).room == room; })) /
           static_cast<double>(all.size());
  };
  return {shareOf(2, 0.1, 0), shareOf(1, 0, from)};
}

TEST(ThinPartition, BothFacesStayApartHoweverItIsTurned)
{
  for (const double from : {0.0, 2.0}) // a wardrobe hides the lower part
    for (double degrees = 0; degrees < 180; degrees += 7.3) {
      const auto [upper, lower] = sharesOfFaces(degrees, from);
      EXPECT_GT(upper, 0.9) << degrees;
      EXPECT_GT(lower, 0.9) << degrees;
    }
}

/** Cells of 0.1 m, x and y from 0 to 3. */
void
addGaps(std::uint32_t room, float low, float high, std::vector<RoomGap>& gaps)
{
  for (int x = 0; x < 30; ++x)
    for (int y = 0; y < 30; ++y)
      gaps.push_back({{x, y}, room, low, high, low});
}

TEST(RoomGaps, RoomsAboveEachOtherOwnTheWallsAtTheirHeights)
{
  std::vector<RoomGap> gaps;
  addGaps(1, 0, 2.8F, gaps);
  addGaps(2, 3.1F, 5.9F, gaps);
  gaps[15 * 30 + 15].high = 5.65F; // seen through a hole in the slab
  const RoomGaps rooms(CellGrid(0.1), gaps);
  for (const float beside : {-0.05F, -0.4F}) // of the wall at x = 0
    for (float z = 0.05F; z < 5.9F; z += 0.1F) {
      const PointOwner owner = rooms.ownerOf({beside, 1.55F, z});
      EXPECT_EQ(owner.room, z < 2.95F ? 1u : 2u) << z;
      EXPECT_FALSE(owner.beyond);
    }
  EXPECT_EQ(rooms.ownerOf({1.55F, 1.55F, 4.F}).room, 1u) << "in the hole";
  EXPECT_EQ(rooms.ownerOf({1.25F, 1.55F, 4.F}).room, 2u) << "beside it";
  EXPECT_EQ(rooms.ownerOf({1, 1, -0.7F}).room, 0u) << "a reflection in the floor";
}

TEST(RoomGaps, WhatIsFartherAwayThanWallsIsBeyond)
{
  std::vector<RoomGap> gaps;
  addGaps(7, 0, 2.5F, gaps);
  const RoomGaps rooms(CellGrid(0.1), gaps);
  EXPECT_TRUE(rooms.ownerOf({-1.F, 1.5F, 1}).beyond);
  EXPECT_EQ(rooms.ownerOf({-1.F, 1.5F, 1}).room, 7u);
  EXPECT_EQ(rooms.ownerOf({-9.F, 1.5F, 1}).room, 0u);
  EXPECT_EQ(rooms.ownerOf({std::nanf(""), 0, 1}).room, 0u);
}

} // namespace
