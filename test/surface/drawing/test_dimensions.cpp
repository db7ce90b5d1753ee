// SPDX-License-Identifier: BSD-3-Clause
#include "drawn_plans.h"

#include "sedr_filters/src/base/number_text.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/floorplan_drawing.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(FloorplanDrawing, EveryDimensionHasItsLength)
{
  // Pilasters of 0.6 m every 1.2 m along a wall: at 1:500 no length of one fits.
  Corners corners;
  for (int k = 0; k < 20; ++k)
    for (const Eigen::Vector2d& p :
         {Eigen::Vector2d(0, 0), Eigen::Vector2d(0.6, 0), Eigen::Vector2d(0.6, 0.3),
          Eigen::Vector2d(1.2, 0.3)})
      corners.emplace_back(p.x() + 1.2 * k, p.y());
  corners.emplace_back(24, 10);
  corners.emplace_back(0, 10);
  for (const double scale : {50.0, 200.0, 500.0}) {
    double across = 0;
    for (const SheetDimension& d :
         PlanDrawing(planOf(polygon(corners)), scaled(scale), 0).dimensions) {
      EXPECT_TRUE(d.text) << "1:" << scale;
      across += d.start.y() == d.end.y() ? d.length : 0;
    }
    EXPECT_NEAR(std::remainder(across, 24), 0, 0.31) << "rows of the whole length";
  }
}

TEST(FloorplanDrawing, RowsOfDimensionsTellEachWall)
{
  // A step of 1 m in the lower wall, which is hidden from above.
  const Floorplan plan = planOf(
      {{segment({0, 0}, {4, 0}), segment({4, 0}, {4, 1}), segment({4, 1}, {6, 1}),
        segment({6, 1}, {6, 5}), segment({6, 5}, {0, 5}), segment({0, 5}, {0, 0})}});
  std::vector<double> below;
  const PlanDrawing drawing(plan, scaled(50), 0);
  for (const SheetDimension& d : drawing.dimensions)
    if (d.start.y() == d.end.y() && d.start.y() < drawing.layout.frame.shift.y())
      below.push_back(std::round(100 * d.length) / 100);
  EXPECT_EQ(below, (std::vector<double>{4, 2, 6}));
}

TEST(FloorplanDrawing, ChainsMeasureTheWallsBesideThemOnAnyPaper)
{
  // The wall between the lower rooms and the upper one is 2 cm thinner on the right.
  const Floorplan plan{{roomOf(rectangle(0, 0, 4, 3), 2.5),
                        roomOf(rectangle(4.24, 0, 8, 3.02), 2.5, 2),
                        roomOf(rectangle(0, 3.26, 8, 5), 2.5, 3)}};
  for (const double scale : {20.0, 50.0, 100.0}) {
    std::array<std::vector<double>, 2> sides; // left and right, from below
    const PlanDrawing drawing(plan, scaled(scale), 0);
    const double middle = drawing.layout.frame(Eigen::Vector2d(4, 0)).x();
    for (const SheetDimension& d : drawing.dimensions)
      if (d.start.x() == d.end.x() && d.length < 5)
        sides[d.start.x() < middle ? 0 : 1].push_back(std::round(100 * d.length) / 100);
    EXPECT_EQ(sides[0], (std::vector<double>{3, 0.26, 1.74})) << "1:" << scale;
    EXPECT_EQ(sides[1], (std::vector<double>{3.02, 0.24, 1.74})) << "1:" << scale;
  }
}

TEST(FloorplanDrawing, OuterOpeningsHaveAChainOfTheirOwn)
{
  // Windows of two walls; one more, below, looks at another room.
  Floorplan plan = planOf(rectangle(0, 0, 8, 6));
  plan.rooms.push_back(roomOf(rectangle(0, -3, 4, -2), 2.5, 2));
  plan.openings = {
      {OpeningKind::Window, {1, 0}, {{1, 0}}, {1, -0.1}, {3, -0.1}, 1, 2, 0, 0.2},
      {OpeningKind::Window, {1, 0}, {{1, 0}}, {6, -0.1}, {7, -0.1}, 1, 2, 0, 0.2},
      {OpeningKind::Door, {1, 0}, {{1, 1}}, {8.1, 2}, {8.1, 3}, 0, 2, 0, 0.2}};
  const PlanDrawing drawing(plan, scaled(50), 0);
  std::map<double, std::vector<double>> below; // by height on the sheet
  std::vector<double> right;
  for (const SheetDimension& d : drawing.dimensions) {
    if (d.start.y() == d.end.y())
      below[d.start.y()].push_back(std::round(100 * d.length) / 100);
    else if (d.start.x() > drawing.layout.frame(Eigen::Vector2d(8, 0)).x())
      right.push_back(std::round(100 * d.length) / 100);
  }
  ASSERT_FALSE(below.empty());
  EXPECT_EQ(below.rbegin()->second, (std::vector<double>{6, 1, 1})) << "nearest";
  EXPECT_EQ(right, (std::vector<double>{5, 1, 3}));
}

} // namespace
