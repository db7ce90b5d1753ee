// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/niches/wall_cells.h"

#include "plan_loops.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

std::size_t
countedIn(const WallCells& cells)
{
  return std::accumulate(cells.counts().begin(), cells.counts().end(), std::size_t{0});
}

TEST(SeenFrom, GivesPlacesAlongAWallAboveItsFloorAndBehindIt)
{
  const double root = std::sqrt(0.5);
  const PlanElement wall = segment({1, 2}, {4, 5}); // at 45 degrees
  const WallPoint p = seenFrom(wall, slabAt(0.5, 0.1), Eigen::Vector3f(3, 2, 2));
  EXPECT_NEAR(p.along, 2 * root, 1e-6);
  EXPECT_NEAR(p.up, 2 - (0.5 + 0.1 * 3), 1e-6) << "the floor rises along x";
  EXPECT_NEAR(p.behind, 2 * root, 1e-6) << "to the right, outside of a room";
}

TEST(WallCells, CountPointsRowByRow)
{
  WallCells cells(1, 3, 0.5, 2, 0.5); // four columns, three rows
  ASSERT_EQ(cells.counts().size(), 12u);
  cells.add(1.1, 0.6);
  cells.add(2.9, 0.6);
  cells.add(2.9, 1.9);
  cells.add(2.9, 1.8);
  EXPECT_EQ(cells.counts(),
            (std::vector<std::size_t>{1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 2}));
}

TEST(WallCells, BothEndsOfAStretchAreOfItAndWhatLiesBesideIsNot)
{
  for (const double cell : {0.1, 0.2, 0.3, 0.7}) {
    const double right = 0.4 + 7 * cell; // rounded: above or below seven cells
    const double high = 2.1 + 3 * cell;
    WallCells cells(0.4, right, 2.1, high, cell);
    ASSERT_EQ(cells.counts().size(), 21u) << cell;
    for (const double along : {0.4, right})
      for (const double up : {2.1, high})
        cells.add(along, up);
    EXPECT_EQ(countedIn(cells), 4u) << cell;
    for (const std::size_t corner : {0u, 6u, 14u, 20u})
      EXPECT_EQ(cells.counts()[corner], 1u) << cell << ' ' << corner;
    for (const double off : {-0.01, 7 * cell + 0.01})
      cells.add(0.4 + off, 2.2);
    for (const double off : {-0.01, 3 * cell + 0.01})
      cells.add(0.5, 2.1 + off);
    EXPECT_EQ(countedIn(cells), 4u) << cell;
  }
}

TEST(WallCells, TheLastCellReachesBeyondAStretchThatItsCellsDoNotFill)
{
  WallCells cells(0, 1, 0.3);
  ASSERT_EQ(cells.counts().size(), 4u);
  cells.add(1.15);
  cells.add(1.25);
  EXPECT_EQ(cells.counts(), (std::vector<std::size_t>{0, 0, 0, 1}));
}

TEST(WallCells, WithoutLengthThereAreNone)
{
  for (const double right : {2.0, 1.0}) {
    WallCells cells(2, right, 0.1);
    cells.add(2);
    cells.add(std::nan(""));
    EXPECT_TRUE(cells.counts().empty());
  }
}

TEST(WallCells, OfTwoThreadsAreAdded)
{
  WallCells cells(0, 1, 0.5);
  WallCells others = cells;
  cells.add(0.1);
  others.add(0.1);
  others.add(0.9);
  cells.add(others);
  EXPECT_EQ(cells.counts(), (std::vector<std::size_t>{2, 1}));
}

} // namespace
