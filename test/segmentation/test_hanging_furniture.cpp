// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include <pcl/sedr_filters/parallel_voxel_grid.h>
#include <pcl/sedr_segmentation/hanging_furniture.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <random>
#include <vector>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

constexpr double height = 2.5;
constexpr double cell = 0.05;
constexpr double worktop = 0.9;

/** A kitchen of 4 m x 3 m: at the wall y = 0.01 a row of cupboards 0.6 m deep and 0.9 m
 * high, above them one that hangs, 0.36 m deep, from `edge` up to `top`, of whose lower
 * edge `edge` tells the height at x. Of ceiling and wall nothing is seen behind it. */
class Kitchen {
public:
  explicit Kitchen(
      double top = height,
      const std::function<double(double)>& edge = [](double) { return 1.4; },
      bool has_wall = true,
      double spacing = 0.05)
      : points(spacing)
  {
    const PlanLoop loop = rectangle(0.01, 0.01, 4.01, 3.01);
    points.slab(loop, 0, [](double, double y) { return y > 0.61; });
    points.slab(rectangle(0.01, 0.01, 4.01, 0.61), worktop);
    points.wall(segment({4.01, 0.61}, {0.01, 0.61}), 0, worktop);
    for (std::size_t e = 1; e < 4; ++e)
      points.wall(loop.elements[e], 0, height, [&](double s, double) {
        return loop.elements[e].pointAt(s).y() > 0.37;
      });
    const auto isBelow = [&](double s, double z) { return z < edge(s + 0.01); };
    if (has_wall)
      wall = points.wall(loop.elements[0], worktop, height, isBelow);
    front = points.wall(segment({0.01, 0.37}, {4.01, 0.37}), 1, top,
                        [&](double s, double z) { return !isBelow(s, z); });
    ceiling = points.slab(loop, height, [](double, double y) { return y > 0.37; });
  }

  HangingFurniture find() const
  {
    const CellGrid grid(cell);
    const CellSet seen(grid, points.view(), ceiling);
    const CellBox box = grown(boxOf(seen), 16);
    return hangingFurniture(CellMask(seen, box), grid, points.view(),
                            ColumnTable(grid, box, points.view(), points.all()),
                            slabAt(height), slabAt(0));
  }

  RoomPoints points;
  std::vector<int> wall;
  std::vector<int> front;
  std::vector<int> ceiling;
};

/** A kitchen of dense points as a scanner shows it: moved by `shift` in x and y, with
 * noise, and thinned. */
Kitchen
scanned(const Kitchen& dense, double shift, double deviation)
{
  std::mt19937 random(3);
  std::normal_distribution<float> noise(0, static_cast<float>(deviation));
  const Eigen::Vector3f by(static_cast<float>(shift), static_cast<float>(shift), 0);
  const auto cloud = dense.points.cloud();
  for (auto& p : *cloud)
    p.getVector3fMap() +=
        by + Eigen::Vector3f(noise(random), noise(random), noise(random));
  pcl::ParallelVoxelGrid<pcl::PointXYZ> grid;
  grid.setInputCloud(cloud);
  pcl::PointCloud<pcl::PointXYZ> thinned;
  grid.filter(thinned);
  Kitchen kitchen = dense;
  kitchen.points = RoomPoints();
  kitchen.ceiling.clear();
  for (const auto& p : thinned) {
    const int i = kitchen.points.point(p.x, p.y, p.z);
    if (p.z > height - 0.06F)
      kitchen.ceiling.push_back(i);
  }
  return kitchen;
}

TEST(HangingFurniture, IsFoundWhereverTheGridLiesAndWithNoise)
{
  const Kitchen dense(
      height, [](double) { return 1.4; }, true, 0.0125);
  for (const double deviation : {0.0, 0.01, 0.02})
    for (const double shift : {0.0, 0.00625, 0.0125, 0.01875, 0.025, 0.03125, 0.0375}) {
      SCOPED_TRACE(testing::Message() << deviation << " m, " << shift << " m");
      const Kitchen kitchen = scanned(dense, shift, deviation);
      const HangingFurniture found = kitchen.find();
      const auto front = static_cast<float>(0.37 + shift);
      for (int i = 0; i < static_cast<int>(kitchen.points.size()); ++i) {
        const Eigen::Vector3f& p = kitchen.points[i];
        if (std::abs(p.y() - front) < 0.03F && std::abs(p.x() - 2) < 1.8F &&
            p.z() > 1.45F && p.z() < height - 0.1F) {
          EXPECT_TRUE(std::binary_search(found.points.begin(), found.points.end(), i))
              << p.transpose();
        }
      }
      EXPECT_GT(found.behind.size(), 1500U);
    }
}

TEST(HangingFurniture, IsACupboardBelowWhichTheWallIsSeenBehindIt)
{
  for (const double top : {height, height - 0.1}) {
    const Kitchen kitchen(top);
    const HangingFurniture found = kitchen.find();
    std::vector<int> missed;
    std::set_difference(kitchen.front.begin(), kitchen.front.end(),
                        found.points.begin(), found.points.end(),
                        std::back_inserter(missed));
    for (const int i : missed)
      EXPECT_TRUE(kitchen.points[i].z() > height - 0.06 || // beside the ceiling
                  std::abs(kitchen.points[i].x() - 2.01F) > 1.94F)
          << "beside the walls";
    for (const int i : found.points)
      EXPECT_NEAR(kitchen.points[i].y(), 0.37, 1e-3) << "nothing else";
  }
}

TEST(HangingFurniture, HidesTheWallThatIsContinuedUpToTheCeiling)
{
  const HangingFurniture found = Kitchen().find();
  // A point every 5 cm from the cupboard's lower edge to the ceiling.
  EXPECT_NEAR(static_cast<double>(found.behind.size()), 4 * 1.1 / 0.0025, 200);
  for (const Eigen::Vector3f& p : found.behind) {
    EXPECT_FLOAT_EQ(p.y(), 0.01F) << "exactly on the wall";
    EXPECT_GT(p.z(), 1.37F);
    EXPECT_LT(p.z(), height);
  }
}

TEST(HangingFurniture, LeavesTheSoffitAboveItAndTheWallEndsThere)
{
  Kitchen kitchen(2.1);
  const auto riser = kitchen.points.wall(segment({0.01, 0.37}, {4.01, 0.37}), 2.2, 2.5);
  const auto underside = kitchen.points.slab(rectangle(0.01, 0.01, 4.01, 0.37), 2.2);
  const HangingFurniture found = kitchen.find();
  EXPECT_GT(found.points.size(), 0.95 * static_cast<double>(kitchen.front.size()));
  for (const auto* soffit : {&riser, &underside})
    for (const int i : *soffit)
      EXPECT_FALSE(std::binary_search(found.points.begin(), found.points.end(), i));
  ASSERT_FALSE(found.behind.empty());
  for (const Eigen::Vector3f& p : found.behind)
    EXPECT_LT(p.z(), 2.2F);
}

TEST(HangingFurniture, IsNoWallBehindWhichNothingIsSeen)
{
  const HangingFurniture found = Kitchen(
                                     height, [](double) { return 1.4; }, false)
                                     .find();
  EXPECT_TRUE(found.points.empty());
  EXPECT_TRUE(found.behind.empty());
}

TEST(HangingFurniture, BeginsWhereNoHeadOfADoorAndNoSoffitDoes)
{
  EXPECT_TRUE(Kitchen(height, [](double) { return 1.95; }).find().points.empty());
  EXPECT_TRUE(Kitchen(height, [](double) { return 1.0; }).find().points.empty());
}

TEST(HangingFurniture, HasALevelEdge)
{
  // What furniture hides of a wall may end anywhere.
  const auto uneven = [](double x) { return 1.15 + 0.15 * x; };
  EXPECT_TRUE(Kitchen(height, uneven).find().points.empty());
  const auto of_two_heights = [](double x) { return x < 1.5 ? 1.6 : 1.4; };
  EXPECT_FALSE(Kitchen(height, of_two_heights).find().points.empty());
}

TEST(HangingFurniture, IsNotTheLowHeadOfANiche)
{
  // The wall goes on beside it, down to the floor.
  Kitchen kitchen;
  EXPECT_FALSE(kitchen.find().points.empty());
  for (const double x : {-0.49, 4.01})
    kitchen.points.wall(segment({x, 0.37}, {x + 0.5, 0.37}), 0, height);
  EXPECT_TRUE(kitchen.find().points.empty());
}

TEST(HangingFurniture, IsWhatItIsAboveAnotherStorey)
{
  Kitchen kitchen;
  const HangingFurniture expected = kitchen.find();
  for (const double y : {0.01, 0.37})
    kitchen.points.wall(segment({0.01, y}, {4.01, y}), -2.8, -0.3);
  const HangingFurniture found = kitchen.find();
  EXPECT_FALSE(found.points.empty());
  EXPECT_EQ(found.points, expected.points);
  EXPECT_EQ(found.behind, expected.behind);
}

/** A plane seen in the cells of some points. */
Level
levelOf(LevelKind kind,
        double z,
        const RoomPoints& points,
        const std::vector<int>& seen)
{
  Level level;
  level.kind = kind;
  level.slab = slabAt(z);
  level.cells = CellSet(CellGrid(cell), points.view(), seen);
  return level;
}

TEST(HangingFurnitureBelow, IsFoundInEveryBuildingOfAScan)
{
  // Each has a table of columns of its own; a point is nowhere.
  Kitchen kitchen;
  RoomPoints both = kitchen.points;
  std::vector<int> ceilings = kitchen.ceiling;
  const auto size = static_cast<int>(both.size());
  for (int i = 0; i < size; ++i)
    both.point(both[i].x() + 64.0, both[i].y(), both[i].z());
  for (const int i : kitchen.ceiling)
    ceilings.push_back(i + size);
  both.point(std::numeric_limits<double>::quiet_NaN(), 0, 1);
  const Level floor = levelOf(LevelKind::Floor, 0, both, ceilings);
  const Level ceiling = levelOf(LevelKind::Ceiling, height, both, ceilings);
  const HangingFurniture found =
      hangingFurnitureBelow({floor, ceiling}, both.view(), cell, 1.5);
  const HangingFurniture by_three =
      hangingFurnitureBelow({floor, ceiling}, both.view(), cell, 1.5, 3);
  EXPECT_EQ(by_three.points, found.points);
  EXPECT_EQ(by_three.behind, found.behind);
  const auto first_of_second =
      std::lower_bound(found.points.begin(), found.points.end(), size);
  const std::vector<int> first(found.points.begin(), first_of_second);
  EXPECT_EQ(first, kitchen.find().points);
  EXPECT_NEAR(static_cast<double>(found.points.end() - first_of_second),
              static_cast<double>(first.size()),
              0.05 * static_cast<double>(first.size()))
      << "coordinates are rounded there";
}

TEST(HangingFurnitureBelow, IsFoundBelowTheCeilingsOfAScan)
{
  const Kitchen kitchen;
  const Level floor = levelOf(LevelKind::Floor, 0, kitchen.points, kitchen.ceiling);
  const Level ceiling =
      levelOf(LevelKind::Ceiling, height, kitchen.points, kitchen.ceiling);
  const HangingFurniture expected = kitchen.find();
  const HangingFurniture found =
      hangingFurnitureBelow({floor, ceiling}, kitchen.points.view(), cell, 1.5);
  EXPECT_FALSE(found.points.empty());
  EXPECT_EQ(found.points, expected.points);
  EXPECT_EQ(found.behind.size(), expected.behind.size());
  EXPECT_TRUE(
      hangingFurnitureBelow({ceiling}, kitchen.points.view(), cell, 1.5).points.empty())
      << "without a floor nothing is known";
  EXPECT_TRUE(
      hangingFurnitureBelow({}, kitchen.points.view(), cell, 1.5).points.empty());
}

} // namespace
