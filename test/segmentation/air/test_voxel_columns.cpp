// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/air/voxel_columns.h"

#include "room_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <tuple>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

constexpr double cell = 0.1;
constexpr double voxel_height = 0.05;

/** A voxel: the cell of its profile and its height. */
using Voxel = std::tuple<std::int32_t, std::int32_t, std::int32_t>;
using Voxels = std::set<Voxel>;

VoxelColumns
columnsOf(const RoomPoints& points)
{
  return VoxelColumns(points.view(), {}, cell, voxel_height, 1);
}

/** Returns all occupied voxels, read by runs. */
Voxels
voxelsOf(const VoxelColumns& columns)
{
  Voxels voxels;
  for (std::uint32_t c = 0; c < columns.size(); ++c)
    columns.forEachRun(c, [&](std::int32_t begin, std::int32_t end) {
      for (std::int32_t k = begin; k < end; ++k)
        voxels.emplace(columns.cellOf(c).x, columns.cellOf(c).y, k);
    });
  return voxels;
}

TEST(VoxelColumns, LoseStraysAndKeepTheEdgesOfSurfaces)
{
  RoomPoints points(0.05);
  points.slab(rectangle(-2, -2, 2, 2), 0.01);
  const Voxels plane = voxelsOf(columnsOf(points));
  for (const double x : {-1.45, -1.35, -1.25, 1.25, 1.75})
    points.point(x, x, 1.01);
  VoxelColumns columns = columnsOf(points);
  columns.keepSurfaces(3);
  const Voxels kept = voxelsOf(columns);
  EXPECT_TRUE(std::includes(plane.begin(), plane.end(), kept.begin(), kept.end()));
  EXPECT_EQ(kept.size() + 4, plane.size()) << "without its corners";
}

TEST(VoxelColumns, ADenseSurfaceDoesNotMakeASparseScanDense)
{
  RoomPoints points(0.05);
  const auto sparse =
      points.slab(rectangle(-3, -3, 3, 3), 0.01, [](double x, double y) {
        return std::lround(x / 0.05 - 0.5) % 4 == 0 &&
               std::lround(y / 0.05 - 0.5) % 4 == 0;
      });
  const auto dense = points.slab(rectangle(10, 0, 12, 1.5), 0.01);
  ASSERT_GT(dense.size(), sparse.size());
  EXPECT_EQ(columnsOf(points).usualCompany(1), 0);
}

TEST(VoxelColumns, TakeMemoryForWhatIsKeptAndNotForTheBox)
{
  RoomPoints points(0.05);
  points.room(rectangle(0, 0, 2, 1.5), 0.02, 2.42);
  const Voxels room = voxelsOf(columnsOf(points));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> far(-150, 150);
  for (int k = 0; k < 3000; ++k) // all columns of the box would take 24 GB
    points.point(far(random), far(random), far(random));
  const VoxelColumns columns = columnsOf(points);
  EXPECT_LT(columns.tiles(), 100u) << "of 2209";
  const Voxels all = voxelsOf(columns);
  EXPECT_TRUE(std::includes(all.begin(), all.end(), room.begin(), room.end()));
}

TEST(VoxelColumns, AScanMayBeAsHighAsAMountain)
{
  for (const double off : {-1e5, 1e5}) {
    RoomPoints high;
    high.slab(rectangle(0, 0, 1, 1), off);
    high.point(0.5, 0.5, 0);
    EXPECT_EQ(voxelsOf(columnsOf(high)).size(), 100u);
  }
}

} // namespace
