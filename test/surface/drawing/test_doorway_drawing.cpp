// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include "sedr_surface/src/drawing/doorway_drawing.h"
#include "sedr_surface/src/drawing/plan_drawing.h"
#include "sedr_surface/src/sheet/sheet_layout.h"
#include "sedr_surface/src/sheet/text_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** Two rooms with a wall of 10 cm between them, from x = 4 to 4.1. */
Floorplan
twoRooms(const PlanDoorway& doorway)
{
  Floorplan plan{
      {roomOf(rectangle(0, 0, 4, 3), 2.5), roomOf(rectangle(4.1, 0, 8, 3), 2.5, 2)}};
  plan.doorways = {doorway};
  return plan;
}

Eigen::AlignedBox2d
gapOf(const PlanDoorway& doorway)
{
  const std::vector<DrawnDoorway> drawn = drawnDoorways(twoRooms(doorway));
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& corner : drawn.at(0).corners)
    box.extend(corner);
  return box;
}

TEST(DoorwayDrawing, TheGapIsTheWallWhereverTheDoorwaysLineIs)
{
  for (const double x : {3.95, 4.05, 4.2}) {
    const Eigen::AlignedBox2d gap = gapOf({{1, 2}, {x, 1}, {x, 2}, 0, 2});
    EXPECT_NEAR(gap.min().x(), 4, 1e-9) << x;
    EXPECT_NEAR(gap.max().x(), 4.1, 1e-9) << x;
    EXPECT_NEAR(gap.sizes().y(), 1, 1e-9) << x;
  }
}

TEST(DoorwayDrawing, ItsSidesAreSquareToTheWall)
{
  const double skew = 0.2;
  const std::vector<DrawnDoorway> drawn =
      drawnDoorways(twoRooms({{1, 2}, {4.05 - skew, 1}, {4.05 + skew, 2}, 0, 2}));
  for (const auto& [from, to] : drawn.at(0).jambs())
    EXPECT_NEAR(from.y(), to.y(), 1e-9);
  EXPECT_NEAR(drawn[0].width,
              (drawn[0].jambs()[0].first - drawn[0].jambs()[1].first).norm(), 1e-9)
      << "is told as drawn";
}

TEST(DoorwayDrawing, EndsWhereARoomEnds)
{
  // The line goes on 10 cm into the wall below both rooms.
  const Eigen::AlignedBox2d gap = gapOf({{1, 2}, {4.05, -0.1}, {4.05, 0.9}, 0, 2});
  EXPECT_NEAR(gap.min().y(), 0, 0.011);
  EXPECT_NEAR(gap.max().y(), 0.9, 1e-9);
}

TEST(TiltedWallDrawing, ShowsItsHeadAndItsTilt)
{
  const Floorplan plan{{roomOf(rectangle(0, 0, 4, 3), 2.5)}};
  const WallTilts tilts{{1, 0, -10 * M_PI / 180}}; // the wall at y = 0, out of the room
  const std::vector<CeilingLines> ceilings = ceilingsOf(plan, 0.01);
  const std::vector<DrawnElement> drawn = drawnElements(plan, ceilings, tilts);
  const auto head = std::find_if(drawn.begin(), drawn.end(), [](const DrawnElement& e) {
    return e.layer == DrawnLayer::Detail;
  });
  ASSERT_NE(head, drawn.end());
  const double out = 2.5 * std::tan(10 * M_PI / 180);
  EXPECT_NEAR(head->element.start.y(), -out, 1e-9);
  EXPECT_NEAR(head->element.end.y(), -out, 1e-9);
  EXPECT_EQ(head->note, "tilt 10.0°");
  EXPECT_EQ(drawnElements(plan, ceilings).size() + 1, drawn.size());
  const WallTilts stale{tilts[0], {1, 7, 0.1}}; // of a wall that the room has not
  EXPECT_EQ(drawnElements(plan, ceilings, stale).size(), drawn.size());
}

TEST(TextAngle, IsReadFromBelowOrFromTheRight)
{
  EXPECT_NEAR(readableAngle({-1, 0.1}), -5.7, 0.1);
  EXPECT_NEAR(readableAngle({0, -1}), 90, 1e-9);
  EXPECT_NEAR(readableAngle({0.1, -1}), 95.7, 0.1) << "a wall that is slightly aslant";
  EXPECT_NEAR(readableAngle({0.1, 1}), 84.3, 0.1);
  EXPECT_NEAR(readableAngle({1, -1}), -45, 1e-9);
}

TEST(SheetScale, IsTheLargestOfARulerThatFits)
{
  const auto scaleOf = [](double x, double y) {
    return layoutOf({{roomOf(rectangle(0, 0, x, y), 2.5)}}, 0, PaperSize::A3).scale;
  };
  EXPECT_EQ(scaleOf(14.5, 11), 75);
  EXPECT_EQ(scaleOf(25.6, 25.5), 125);
  EXPECT_EQ(scaleOf(61, 61), 300);
  EXPECT_EQ(scaleOf(300, 100), 1000);
  EXPECT_EQ(scaleOf(3000, 1000), 10000);
}

} // namespace
