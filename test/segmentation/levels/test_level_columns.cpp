// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include "sedr_segmentation/src/levels/level_columns.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

constexpr double cell = 0.05;
constexpr double tolerance = 0.07;

TEST(LevelColumns, HoldThePointsOfEachCellSortedByHeight)
{
  RoomPoints points;
  for (const double z : {0.9, 0.1, 0.5}) {
    points.point(0.02, 0.02, z);
    points.point(0.12, 0.02, -z);
  }
  points.point(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  const LevelColumns columns(points.view(), points.all(), cell, tolerance);
  ASSERT_EQ(columns.cells().size(), 2u);
  ASSERT_EQ(columns.all().size(), 6u) << "what is not finite is left out";
  for (std::size_t c = 0; c < 2; ++c) {
    ASSERT_EQ(columns.last(c) - columns.first(c), 3u);
    for (std::size_t k = columns.first(c); k < columns.last(c); ++k) {
      const Candidate& at = columns.all()[k];
      EXPECT_EQ(at.cell, c);
      EXPECT_EQ(at.position(), points[at.index]);
      EXPECT_TRUE(columns.grid().at(at.x, at.y) == columns.cells()[c]);
      if (k > columns.first(c)) {
        EXPECT_LT(columns.all()[k - 1].z, at.z);
      }
    }
  }
}

TEST(LevelColumns, WithoutWallsAreCeilingAndFloorAndTheEndsOfWalls)
{
  RoomPoints points;
  const RoomParts parts = points.room(rectangle(0.01, 0.01, 3.01, 2.01), 0, 2.5);
  for (const unsigned threads : {1U, 3U}) {
    const LevelColumns columns(points.view(), points.all(), cell, tolerance, threads);
    std::set<int> left;
    float below = -std::numeric_limits<float>::infinity();
    for (const Candidate& c : columns.withoutWalls()) {
      left.insert(c.index);
      EXPECT_LE(below, c.z) << "by height";
      below = c.z;
    }
    for (const auto* slab : {&parts.floor, &parts.ceiling})
      for (const int i : *slab)
        EXPECT_TRUE(left.count(i)) << points[i].transpose();
    for (const int i : parts.walls) {
      const float z = points[i].z();
      if (z > tolerance && z < 2.5 - tolerance) {
        EXPECT_FALSE(left.count(i)) << points[i].transpose();
      }
    }
  }
}

} // namespace
