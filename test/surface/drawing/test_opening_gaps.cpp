// SPDX-License-Identifier: BSD-3-Clause
#include "drawn_plans.h"

#include "sedr_surface/src/sheet/text_places.h"
#include <pcl/sedr_surface/floorplan_drawing.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(OpeningGaps, CutTheFacesOfTheirWall)
{
  const OpeningGap gap{"D1", {{{1, 0.1}, {2, 0.1}, {2, -0.1}, {1, -0.1}}}};
  const auto left = [&gap](const PlanElement& element) {
    double length = 0;
    for (const PlanElement& part : cutAtGaps(element, {gap}))
      length += part.length();
    return element.length() - length;
  };
  EXPECT_NEAR(left(segment({0, 0.1}, {4, 0.1})), 1, 1e-12);
  EXPECT_NEAR(left(segment({4, -0.1}, {0, -0.1})), 1, 1e-12) << "the other face";
  EXPECT_NEAR(left(segment({1.7, 0.1}, {4, 0.1})), 0.3, 1e-12) << "beyond a corner";
  EXPECT_EQ(cutAtGaps(segment({1.2, 0.1}, {1.8, 0.1}), {gap}).size(), 0u);
  EXPECT_EQ(left(segment({0, 0.5}, {4, 0.5})), 0) << "another wall";
  EXPECT_EQ(left(segment({1.5, -1}, {1.5, 1})), 0) << "across";
  EXPECT_EQ(left(segment({3, 0.1}, {4, 0.1})), 0) << "farther on";
  const double angle = 2 * std::asin(0.5 / 3); // of a chord of 1 m
  const OpeningGap curved{"W1",
                          {{{-0.5, 2.958}, {0.5, 2.958}, {0.5, 3.158}, {-0.5, 3.158}}}};
  const PlanElement bow = arc({0, 0}, 3, 0, 180);
  const auto parts = cutAtGaps(bow, {curved});
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_NEAR(bow.length() - parts[0].length() - parts[1].length(), 3 * angle, 1e-9);
  for (const double degrees : {0.0, 90.0, 180.0, 250.0}) { // from the end of the circle
    const Eigen::Rotation2Dd turn(degrees * M_PI / 180);
    OpeningGap wide{"W2", {{{4, -0.8}, {4, 0.8}, {4.2, 0.8}, {4.2, -0.8}}}};
    for (Eigen::Vector2d& corner : wide.corners)
      corner = turn * corner;
    double length = 0;
    for (const PlanElement& part : cutAtGaps(circle({0, 0}, 4).elements[0], {wide}))
      length += part.length();
    EXPECT_NEAR(length, 4 * (2 * M_PI - 2 * std::asin(0.8 / 4)), 1e-9) << degrees;
  }
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
    lines[kind] = linesOf(openingGaps(plan, findWalls(plan))[0]).size();
  }
  constexpr std::size_t jambs = 2;
  constexpr std::size_t faces = 2;
  EXPECT_EQ(lines[OpeningKind::Door], jambs + 1);
  EXPECT_EQ(lines[OpeningKind::Window], jambs + faces + 2);
  EXPECT_EQ(lines[OpeningKind::Passage], jambs);
  plan.openings[0].kind = OpeningKind::Door;
  Floorplan passage = plan;
  passage.openings[0].kind = OpeningKind::Passage;
  EXPECT_NE(svgOf(plan), svgOf(passage));
  EXPECT_NE(dxfOf(plan), dxfOf(passage));
  plan.openings[0].hinge = OpeningHinge::Start;
  plan.openings[0].swing = 1;
  EXPECT_EQ(linesOf(openingGaps(plan, findWalls(plan))[0]).size(), jambs + 2)
      << "its leaf and the swing";
}

TEST(TextPlaces, ALineToAvoidIsCrossedWhereThereIsNoOtherPlace)
{
  const TextBox on{{0, 0}, {2, 1}, 0};
  const TextBox off{{0, 3}, {2, 1}, 0};
  TextPlaces places;
  places.avoid(segment({-9, 0}, {9, 0}));
  EXPECT_EQ(places.takeFirst({on, off})->middle.y(), 3);
  EXPECT_EQ(places.takeFirst({on, off})->middle.y(), 0);
}

TEST(TextPlaces, TextsAreReadFromBelowOrFromTheRight)
{
  EXPECT_NEAR(readableAngle({-1, 0.1}), -5.7, 0.1);
  EXPECT_NEAR(readableAngle({0, -1}), 90, 1e-9);
  EXPECT_NEAR(readableAngle({0.1, -1}), 95.7, 0.1) << "a wall that is slightly aslant";
  EXPECT_NEAR(readableAngle({1, -1}), -45, 1e-9);
}

} // namespace
