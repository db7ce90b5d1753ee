// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_segmentation/src/details/height_bends.h"

#include "room_points.h"

#include "sedr_segmentation/src/details/detail_fit.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <vector>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** A strip of a ceiling across a room: its start and the height of its level, metres.
 */
struct Strip {
  double from = 0;
  double height = 0;
};

/** A ceiling over 4 m x 3 m whose height depends on x alone, labelled in strips; the
 * first is the main slab. */
struct Ceiling {
  Ceiling(const std::function<double(double)>& height, const std::vector<Strip>& strips)
  {
    const PlanLoop outline = rectangle(0, 0, 4, 3);
    CellMask room(CellBox{{-12, -12}, {91, 71}});
    map.label.assign(room.values().size(), -1);
    for (std::size_t i = 0; i < room.values().size(); ++i) {
      const Eigen::Vector2d p = grid.centre(room.cellAt(i));
      if (!outline.contains(p))
        continue;
      room.values()[i] = 1;
      evidence.main.push_back(points.point(p.x(), p.y(), height(p.x())));
      for (const Strip& strip : strips)
        map.label[i] += p.x() > strip.from ? 1 : 0;
    }
    map.room = room;
    map.main = slabAt(strips[0].height);
    for (std::size_t s = 1; s < strips.size(); ++s)
      map.details.push_back(slabAt(strips[s].height));
    tidyBends(points.view(), evidence, grid, map);
  }

  std::int32_t labelAt(double x) const
  {
    return map.label[map.room.indexOf(grid.at(x, 1.5))];
  }

  std::set<std::int32_t> labels() const
  {
    std::set<std::int32_t> labels(map.label.begin(), map.label.end());
    labels.erase(-1);
    return labels;
  }

  CellGrid grid{0.05};
  RoomPoints points;
  SlabEvidence evidence;
  HeightMap map;
};

/** Falls by `fall` metres per metre from x = 1 on. */
std::function<double(double)>
slopeOf(double fall)
{
  return [fall](double x) { return 2.5 - fall * std::max(0.0, x - 1); };
}

using Labels = std::set<std::int32_t>;

TEST(HeightBends, EdgesOfStripsAreMidwayBetweenTheirHeights)
{
  // The middle height, 2.47 m, is at x = 1.6, wherever the levels were cut.
  for (const double cut : {1.4, 1.6, 2.0}) {
    const Ceiling ceiling(slopeOf(0.05), {{0, 2.5}, {cut, 2.44}});
    EXPECT_EQ(ceiling.labelAt(1.57), 0) << cut;
    EXPECT_EQ(ceiling.labelAt(1.63), 1) << cut;
    EXPECT_EQ(ceiling.map.bends.count({0, 1}), 1u);
    EXPECT_EQ(ceiling.map.bends.count({1, 0}), 1u);
  }
}

TEST(HeightBends, ASliverGoesToTheStripThatIsNearestInHeight)
{
  const Ceiling ceiling(slopeOf(0.05),
                        {{0, 2.5}, {1.6, 2.44}, {2.6, 2.415}, {2.8, 2.37}});
  EXPECT_EQ(ceiling.labels(), (Labels{0, 1, 3}));
  EXPECT_EQ(ceiling.labelAt(2.87), 1) << "2.405 m is at x = 2.9";
  EXPECT_EQ(ceiling.labelAt(2.93), 3);
}

TEST(HeightBends, WhatIsASquareMetreOrSixCentimetresOffIsNoSliver)
{
  EXPECT_EQ(
      Ceiling(slopeOf(0.05), {{0, 2.5}, {1.6, 2.44}, {2.6, 2.405}, {3, 2.37}}).labels(),
      (Labels{0, 1, 2, 3}));
  EXPECT_EQ(
      Ceiling(slopeOf(0.25), {{0, 2.5}, {1.4, 2.31}, {2, 2.23}, {2.3, 2.15}}).labels(),
      (Labels{0, 1, 2, 3}));
}

TEST(HeightBends, WhatAStepPartsStaysAsItIs)
{
  const auto step = [](double x) { return x < 2 ? 2.5 : 2.42; };
  const Ceiling ceiling(step, {{0, 2.5}, {2, 2.42}});
  EXPECT_TRUE(ceiling.map.bends.empty());
  EXPECT_EQ(ceiling.labelAt(1.97), 0);
  EXPECT_EQ(ceiling.labelAt(2.03), 1);
  const BentEdges edges = bentEdges(ceiling.map, ceiling.grid);
  EXPECT_TRUE(edges.points.empty());
  EXPECT_EQ(edges.cells.count(), 0u);
}

TEST(HeightBends, BentEdgesAreWhereTheCeilingIsMidwayBetweenTwoPlanes)
{
  // The middle height, 2.4695 m, is at x = 1.61: within a cell.
  const Ceiling ceiling(slopeOf(0.05), {{0, 2.5}, {1.6, 2.439}});
  const BentEdges edges = bentEdges(ceiling.map, ceiling.grid);
  ASSERT_FALSE(edges.points.empty());
  EXPECT_NEAR(static_cast<double>(edges.points.size()), 300, 10) << "3 m, 1 cm apart";
  for (const Eigen::Vector2d& p : edges.points)
    EXPECT_NEAR(p.x(), 1.61, 0.002);
  EXPECT_TRUE(edges.cells.at(ceiling.grid.at(1.52, 1.5)));
  EXPECT_FALSE(edges.cells.at(ceiling.grid.at(1.42, 1.5)));
}

TEST(HeightBends, OfAPlainCeilingNothingIsNoted)
{
  const Ceiling ceiling(slopeOf(0), {{0, 2.5}});
  EXPECT_TRUE(ceiling.map.relief.empty());
  EXPECT_TRUE(bentEdges(ceiling.map, ceiling.grid).points.empty());
}

} // namespace
