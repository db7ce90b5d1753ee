// SPDX-License-Identifier: BSD-3-Clause
#include "two_storeys.h"

#include "sedr_surface/src/drawing/plan_drawing.h"
#include <pcl/sedr_surface/floorplan_drawing.h>

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** The gap of a doorway between two rooms with a wall of 10 cm from x = 4 to 4.1. */
Eigen::AlignedBox2d
gapOf(const PlanDoorway& doorway)
{
  Floorplan plan{
      {roomOf(rectangle(0, 0, 4, 3), 2.5), roomOf(rectangle(4.1, 0, 8, 3), 2.5, 2)}};
  plan.doorways = {doorway};
  const std::vector<DoorwayGap> gaps = doorwayGaps(plan);
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& corner : gaps.at(0).corners)
    box.extend(corner);
  return box;
}

TEST(DoorwayGaps, AreTheWallWhereverTheirLineIs)
{
  for (const double x : {3.95, 4.05, 4.2})
    for (const double skew : {0.0, 0.2}) {
      const Eigen::AlignedBox2d gap =
          gapOf({{1, 2}, {x - skew, 1}, {x + skew, 2}, 0, 2});
      EXPECT_TRUE(gap.min().isApprox(Eigen::Vector2d(4, 1))) << x;
      EXPECT_TRUE(gap.max().isApprox(Eigen::Vector2d(4.1, 2))) << x;
    }
  const Eigen::AlignedBox2d cut = gapOf({{1, 2}, {4.05, -0.1}, {4.05, 0.9}, 0, 2});
  EXPECT_NEAR(cut.min().y(), 0, 1e-9) << "both rooms end there";
}

TEST(DoorwayGaps, ToOutsideAreAsDeepThere)
{
  Floorplan plan{{roomOf(rectangle(0, 0, 4, 3), 2.5)}};
  plan.doorways = {{{1, 0}, {1, -0.2}, {2, -0.2}, 0, 2}};
  EXPECT_NE(floorplanToDxf(plan).find("\n20\n-0.4000000\n"), std::string::npos);
  plan.doorways[0].end = plan.doorways[0].start; // of no width
  EXPECT_TRUE(doorwayGaps(plan).empty());
}

TEST(DoorwayGaps, ADoorIsShutByALineAndAPassageIsNot)
{
  Floorplan plan{
      {roomOf(rectangle(0, 0, 4, 3), 2.5), roomOf(rectangle(4.1, 0, 8, 3), 2.5, 2)}};
  plan.openings = {{OpeningKind::Door,
                    {1, 2},
                    {{1, 1}, {2, 3}},
                    {4.05, 1},
                    {4.05, 2},
                    0,
                    2,
                    0,
                    0.1}};
  std::map<OpeningKind, std::size_t> lines;
  for (const OpeningKind kind :
       {OpeningKind::Door, OpeningKind::Window, OpeningKind::Passage}) {
    plan.openings[0].kind = kind;
    lines[kind] = fillingOf(doorwayGaps(plan)[0]).size();
  }
  EXPECT_EQ(lines[OpeningKind::Door], 1u);
  EXPECT_EQ(lines[OpeningKind::Window], 2u);
  EXPECT_EQ(lines[OpeningKind::Passage], 0u);
  plan.openings[0].kind = OpeningKind::Door;
  Floorplan passage = plan;
  passage.openings[0].kind = OpeningKind::Passage;
  EXPECT_NE(floorplanToSvg(plan), floorplanToSvg(passage));
  EXPECT_NE(floorplanToDxf(plan), floorplanToDxf(passage));
  plan.openings[0].hinge = OpeningHinge::Start;
  plan.openings[0].swing = 1;
  EXPECT_TRUE(fillingOf(doorwayGaps(plan)[0]).empty()) << "its leaf is drawn";
}

} // namespace
