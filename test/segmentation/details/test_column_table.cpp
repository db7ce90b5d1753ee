// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include "sedr_segmentation/src/plan/box_clusters.h"
#include "sedr_filters/src/grids/cell_count.h"
#include "sedr_segmentation/src/details/column_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr CellBox box{{-3, -2}, {4, 5}};

/** Returns random points in and around the box, with heights from 0 to 3. */
RoomPoints
randomPoints(int count)
{
  RoomPoints points;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-0.25, 0.35);
  std::uniform_real_distribution<double> height(0, 3);
  for (int i = 0; i < count; ++i)
    points.point(place(random), place(random), height(random));
  return points;
}

/** Returns the heights of one profile by a scan of all points. */
std::vector<float>
heightsIn(const RoomPoints& points, const std::vector<int>& indices, Cell cell)
{
  const CellGrid grid(0.05);
  std::vector<float> heights;
  for (const int i : indices)
    if (grid.at(points[i].x(), points[i].y()) == cell)
      heights.push_back(points[i].z());
  std::sort(heights.begin(), heights.end());
  return heights;
}

TEST(ColumnTable, HoldsThePointsOfEachColumnByHeight)
{
  const RoomPoints points = randomPoints(2000);
  std::vector<int> odd;
  for (int i = 1; i < 2000; i += 2)
    odd.push_back(i);
  const ColumnTable table(CellGrid(0.05), box, points.view(), odd);
  for (const Cell cell : {Cell{0, 0}, Cell{-3, -2}, Cell{4, 5}, Cell{-1, 3}}) {
    std::vector<float> heights;
    for (auto* e = table.begin(cell); e != table.end(cell); ++e) {
      heights.push_back(e->z);
      EXPECT_EQ(points[e->index].z(), e->z);
      EXPECT_EQ(e->index % 2, 1);
    }
    ASSERT_FALSE(heights.empty());
    EXPECT_EQ(heights, heightsIn(points, odd, cell));
  }
}

TEST(ColumnTable, IsEmptyOutsideOfItsBoxAndForPointsThatAreNotFinite)
{
  RoomPoints points;
  points.point(0.01, 0.01, nan);
  points.point(nan, 0.01, 1);
  points.point(0.01, std::numeric_limits<double>::infinity(), 1);
  points.point(5, 5, 1);
  points.point(1e30, 0, 1);
  const ColumnTable table(CellGrid(0.05), box, points.view(), points.all());
  for (const Cell cell : {Cell{0, 0}, Cell{100, 100}, Cell{-4, 0}}) {
    EXPECT_EQ(table.begin(cell), table.end(cell));
    EXPECT_FALSE(table.hasWithin(cell, -10, 10));
    EXPECT_TRUE(table.runs(cell, 1).empty());
  }
}

TEST(ColumnTable, HasWithinIsWhatLookingAtAllSays)
{
  const RoomPoints points = randomPoints(500);
  const ColumnTable table(CellGrid(0.05), box, points.view(), points.all());
  std::mt19937 random(4);
  std::uniform_real_distribution<double> height(-0.1, 3.1);
  for (int trial = 0; trial < 300; ++trial) {
    const Cell cell{static_cast<int>(random() % 8) - 3,
                    static_cast<int>(random() % 8) - 2};
    const double low = height(random);
    const double high = low + 0.2;
    const auto heights = heightsIn(points, points.all(), cell);
    ASSERT_EQ(table.hasWithin(cell, low, high),
              std::any_of(heights.begin(), heights.end(),
                          [&](float z) { return z >= low && z <= high; }));
  }
}

TEST(ColumnTable, TheEndsOfAHeightRangeAreWithin)
{
  RoomPoints points;
  points.point(0.01, 0.01, 1.5);
  const ColumnTable table(CellGrid(0.05), box, points.view(), points.all());
  EXPECT_TRUE(table.hasWithin({0, 0}, 1.5, 2));
  EXPECT_TRUE(table.hasWithin({0, 0}, 1, 1.5));
  EXPECT_FALSE(table.hasWithin({0, 0}, 1.501, 2));
  EXPECT_FALSE(table.hasWithin({1, 0}, 1, 2));
}

TEST(ColumnTable, RunsArePartedByLargerGaps)
{
  RoomPoints points;
  for (const double z : {2.4, 0.0, 0.125, 0.25, 0.9, 1.0, 2.375})
    points.point(0.01, 0.01, z);
  const ColumnTable table(CellGrid(0.05), box, points.view(), points.all());
  const auto runs = table.runs({0, 0}, 0.125);
  ASSERT_EQ(runs.size(), 3u);
  EXPECT_EQ(runs[0].low, 0.f);
  EXPECT_EQ(runs[0].high, 0.25f);
  EXPECT_EQ(runs[1].low, 0.9f);
  EXPECT_EQ(runs[1].high, 1.f);
  EXPECT_EQ(runs[2].low, 2.375f);
  EXPECT_EQ(runs[2].high, 2.4f);
  EXPECT_EQ(table.runs({0, 0}, 0.11).size(), 5u);
  EXPECT_EQ(table.runs({0, 0}, 3).size(), 1u);
}

TEST(CellsFor, RoundsALengthToWholeCellsAtLeastSoMany)
{
  EXPECT_EQ(cellsFor(0.4, 0.05), 8);
  EXPECT_EQ(cellsFor(0.12, 0.05), 2);
  EXPECT_EQ(cellsFor(0.13, 0.05), 3);
  EXPECT_EQ(cellsFor(0.01, 0.05), 1);
  EXPECT_EQ(cellsFor(0.01, 0.05, 3), 3);
}

bool
operator==(const CellBox& a, const CellBox& b)
{
  return a.low == b.low && a.high == b.high;
}

TEST(ClusterBoxes, KeepApartWhatIsFarApart)
{
  const auto clusters = clusterBoxes({{{0, 0}, {9, 9}}, {{200000, 0}, {200009, 9}}}, 3);
  ASSERT_EQ(clusters.size(), 2u);
  EXPECT_TRUE(clusters[0] == (CellBox{{-3, -3}, {12, 12}}));
  EXPECT_TRUE(clusters[1] == (CellBox{{199997, -3}, {200012, 12}}));
}

TEST(ClusterBoxes, JoinWhatTheirMarginsMakeOverlap)
{
  EXPECT_EQ(clusterBoxes({{{0, 0}, {9, 9}}, {{15, 0}, {20, 9}}}, 3).size(), 1u);
  EXPECT_EQ(clusterBoxes({{{0, 0}, {9, 9}}, {{16, 0}, {20, 9}}}, 3).size(), 2u);
  EXPECT_TRUE(clusterBoxes({{{0, 0}, {9, 9}}, {{15, 4}, {20, 30}}}, 3)[0] ==
              (CellBox{{-3, -3}, {23, 33}}));
}

TEST(ClusterBoxes, LeaveNoOverlapHoweverTheBoxesLie)
{
  std::mt19937 random(12);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<CellBox> boxes;
    for (int k = 0; k < 12; ++k) {
      const Cell low{static_cast<int>(random() % 100),
                     static_cast<int>(random() % 100)};
      boxes.push_back({low,
                       {low.x + static_cast<int>(random() % 15),
                        low.y + static_cast<int>(random() % 15)}});
    }
    const auto clusters = clusterBoxes(boxes, 2);
    const auto isIn = [](const CellBox& a, const CellBox& b) {
      return a.low.x >= b.low.x && a.low.y >= b.low.y && a.high.x <= b.high.x &&
             a.high.y <= b.high.y;
    };
    for (const auto& b : boxes)
      EXPECT_EQ(std::count_if(clusters.begin(), clusters.end(),
                              [&](const auto& c) { return isIn(grown(b, 2), c); }),
                1);
    for (std::size_t i = 0; i < clusters.size(); ++i)
      for (std::size_t j = i + 1; j < clusters.size(); ++j)
        EXPECT_TRUE(clusters[i].high.x < clusters[j].low.x ||
                    clusters[j].high.x < clusters[i].low.x ||
                    clusters[i].high.y < clusters[j].low.y ||
                    clusters[j].high.y < clusters[i].low.y);
  }
}

TEST(ClusterBoxes, OfEmptyBoxesAreNone)
{
  EXPECT_TRUE(clusterBoxes({}, 3).empty());
  EXPECT_TRUE(clusterBoxes({{{0, 0}, {-1, -1}}}, 3).empty());
}

} // namespace
