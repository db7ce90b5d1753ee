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

TEST(OpeningGaps, OfOuterWallsGoThroughTheirWall)
{
  // Reveals of 0.4 m in one wall are those of the others, too.
  Floorplan plan{{roomOf(rectangle(0, 0, 4, 3), 2.5)}};
  plan.openings = {
      {OpeningKind::Passage, {1, 0}, {{1, 0}}, {2, -0.2}, {1, -0.2}, 0, 2, 0, 0.4},
      {OpeningKind::Window, {0, 1}, {{1, 2}}, {1, 3.1}, {2, 3.1}, 1, 2, 0, 0.2},
      {OpeningKind::Window, {1, 0}, {{1, 1}}, {4.4, 2}, {4.4, 1}, 1, 2, 0, 0.4}};
  const std::vector<OpeningGap> gaps = openingGaps(plan, findWalls(plan));
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& corner : gaps.at(0).corners)
    box.extend(corner);
  EXPECT_TRUE(box.min().isApprox(Eigen::Vector2d(1, -0.4)));
  EXPECT_NEAR((box.max() - Eigen::Vector2d(2, 0)).norm(), 0, 1e-9);
  box.setEmpty();
  for (const Eigen::Vector2d& corner : gaps.at(1).corners)
    box.extend(corner);
  EXPECT_TRUE(box.min().isApprox(Eigen::Vector2d(1, 3)));
  EXPECT_TRUE(box.max().isApprox(Eigen::Vector2d(2, 3.4)));
  EXPECT_NE(floorplanToDxf(plan).find("\n20\n-0.4000000\n"), std::string::npos);
}

TEST(OpeningGaps, ADoorIsShutByALineAndAPassageIsNot)
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
    lines[kind] = fillingOf(openingGaps(plan, findWalls(plan))[0]).size();
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
  EXPECT_TRUE(fillingOf(openingGaps(plan, findWalls(plan))[0]).empty())
      << "its leaf is drawn";
}

} // namespace
