// SPDX-License-Identifier: BSD-3-Clause
#include "../../plan_loops.h"
#include "measured_room.h"
#include "says.h"

#include <gtest/gtest.h>
#include <pcl/sedr_surface/plan_review.h>

#include <algorithm>
#include <string>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(PlanReview, AMeasuredRoomIsHandedOver)
{
  const PlanReview review = reviewOf(measuredRoom(), {});
  EXPECT_TRUE(review.doubts.empty());
  EXPECT_EQ(review.verdict, ReviewVerdict::HandOver);
  EXPECT_EQ(review.checks, 0u);
  EXPECT_EQ(review.text.rfind("hand it over: 9", 0), 0u) << review.text;
  EXPECT_TRUE(firstOf(review.doubts).empty());
}

TEST(PlanReview, WarningsOfOneWallAreOneDoubtWithItsCertainty)
{
  Floorplan plan = measuredRoom();
  hideWall(plan, 3);
  const PlanReview review =
      reviewOf(plan, {{WarningKind::WallOff, {2, -7}, 1, 3, "", {1, 3}},
                      {WarningKind::GuessedWall, {4, 60, 30}, 1, 3}});
  ASSERT_EQ(review.doubts.size(), 1u);
  const PlanDoubt& doubt = review.doubts[0];
  EXPECT_EQ(doubt.subject, "wall 1.3");
  EXPECT_EQ(doubt.at, Eigen::Vector2d(1, 3));
  EXPECT_EQ(doubt.kinds,
            (std::vector<WarningKind>{WarningKind::WallOff, WarningKind::GuessedWall}));
  const double right = review.walls[2].right();
  EXPECT_NEAR(doubt.stake, 10 * (1 - right), 1e-9);
  EXPECT_EQ(doubt.text,
            "look at wall 1.3, " + std::to_string(std::lround(100 * right)) +
                " % sure: 2.0 m2 of what was seen there lie 7 cm behind it; "
                "its place over 4.0 m is a guess: 60 % of it is inferred "
                "behind what hides it, 30 % nobody saw");
}

TEST(PlanReview, AShortWallThatIsRatherWrongIsCheckedToo)
{
  Floorplan plan =
      measuredRoom(polygon({{0, 0}, {12, 0}, {12, 9}, {6, 9}, {6, 8.5}, {0, 8.5}}));
  EXPECT_EQ(reviewOf(plan, {}).verdict, ReviewVerdict::HandOver);
  hideWall(plan, 4);
  const PlanReview review = reviewOf(plan, {});
  ASSERT_EQ(review.doubts.size(), 1u);
  EXPECT_LT(review.walls[3].right(), 0.5);
  EXPECT_LT(review.doubts[0].stake, 0.02 * 2 * plan.rooms[0].area());
  EXPECT_EQ(review.verdict, ReviewVerdict::Check);
  EXPECT_EQ(review.checks, 1u);
}

TEST(PlanReview, SoAreOpeningsAndRoomsWithoutAWayIn)
{
  Floorplan plan = measuredRoom();
  plan.openings[0].confidence = 0.01;
  plan.openings[0].end.x() = 1.4;
  const PlanReview opening = reviewOf(plan, {});
  ASSERT_EQ(opening.doubts.size(), 1u);
  EXPECT_LT(opening.openings[0].right(), 0.5);
  EXPECT_LT(opening.doubts[0].stake, 0.9) << "of 47 m2 less than 2 %";
  EXPECT_EQ(opening.checks, 1u);
  const PlanReview review = reviewOf(measuredRoom(), {{WarningKind::NoDoor, {0.5}, 1}});
  EXPECT_EQ(review.verdict, ReviewVerdict::Check);
  EXPECT_EQ(review.checks, 1u);
}

TEST(PlanReview, WhatIsNotSureIsADoubtWithoutAWarning)
{
  Floorplan plan = measuredRoom();
  hideWall(plan, 2);
  plan.openings.push_back(plan.openings[0]);
  plan.openings.push_back(plan.openings[0]);
  PlanOpening& window = plan.openings[2];
  window.kind = OpeningKind::Passage;
  window.number = 7;
  window.residual = 0.05;
  window.confidence = 0.6;
  window.edges[0] = {EdgeSeen::Nothing, 0.07};
  window.edges[1] = {EdgeSeen::Reveal, 0.001};
  const PlanReview review = reviewOf(plan, {});
  ASSERT_EQ(review.doubts.size(), 2u);
  EXPECT_EQ(review.doubts[0].subject, "wall 1.2");
  EXPECT_EQ(review.doubts[0].at, Eigen::Vector2d(4, 1.5));
  EXPECT_TRUE(review.doubts[0].kinds.empty());
  EXPECT_TRUE(says(review.doubts[0].text, "it is 3.00 m long, 10 % of it was measured, "
                                          "its standard error is not known"));
  EXPECT_EQ(review.doubts[1].subject, "passage P7");
  EXPECT_TRUE(says(review.doubts[1].text,
                   "m wide with a standard error of 7.0 cm, a jamb "
                   "was not seen, no room was seen beyond, its kind "
                   "is doubtful"));
}

TEST(PlanReview, OfAnOpeningWithoutEdgesItsResidualIsTold)
{
  Floorplan plan = measuredRoom(); // as plans were written before
  plan.openings[0].residual = 0.013;
  plan.openings[0].confidence = 0.6;
  const PlanReview review = reviewOf(plan, {});
  ASSERT_EQ(review.doubts.size(), 1u);
  EXPECT_TRUE(says(review.doubts[0].text,
                   "sure: its edges are known to 1.3 cm, no room was seen beyond, its "
                   "kind is doubtful"));
}

TEST(PlanReview, WhatIsConfirmedIsNoDoubt)
{
  Floorplan plan = measuredRoom();
  hideWall(plan, 2);
  plan.openings[0].confidence = 0.2;
  const std::vector<PlanWarning> warnings{{WarningKind::WallOff, {2, -7}, 1, 2}};
  EXPECT_EQ(reviewOf(plan, warnings).doubts.size(), 2u);
  plan.rooms[0].boundary.elements[1].is_confirmed = true;
  plan.openings[0].is_confirmed = true;
  const PlanReview review = reviewOf(plan, warnings);
  EXPECT_TRUE(review.doubts.empty());
  EXPECT_EQ(review.walls[1].right(), 1);
  EXPECT_EQ(review.openings[0].right(), 1);
}

TEST(PlanReview, WhatIsOfTheWholeWithoutAStakeIsARemarkAndNoPlace)
{
  const PlanReview review =
      reviewOf(measuredRoom(), {{WarningKind::Levelled, {1.2, 30}, 0, 0, "as asked"},
                                {WarningKind::Noise, {2}},
                                {WarningKind::Tilted, {2}, 1}});
  ASSERT_EQ(review.remarks.size(), 1u);
  EXPECT_TRUE(says(review.remarks[0], "the scan is tilted by 1.20 degrees"));
  ASSERT_EQ(review.doubts.size(), 2u);
  EXPECT_EQ(review.doubts[0].kinds, std::vector<WarningKind>{WarningKind::Noise});
  EXPECT_EQ(review.doubts[1].subject, "room 1");
}

TEST(PlanReview, OnlyWallsThatADoubtNamesAreNumberedOnDrawings)
{
  Floorplan plan = measuredRoom();
  hideWall(plan, 2);
  const auto is_numbered = wallsAmong(leadingSubjects(reviewOf(plan, {}).doubts));
  EXPECT_TRUE(is_numbered(1, 1));
  EXPECT_FALSE(is_numbered(1, 0));
  EXPECT_FALSE(is_numbered(2, 1));
}

TEST(PlanReview, DoubtsOfARoomAreOneAPlace)
{
  const PlanReview review = reviewOf(
      measuredRoom(), {{WarningKind::Standing, {1}, 1, 0, "", {1, 1}},
                       {WarningKind::Hidden, {1, 12}, 1},
                       {WarningKind::Hanging, {1.8, 0.4, 12}, 1, 0, "", {1.5, 1.5}},
                       {WarningKind::FloorOff, {0.5, 0.1, 0.2}, 1, 0, "", {3.5, 2}},
                       {WarningKind::Open, {2}, 1}});
  ASSERT_EQ(review.doubts.size(), 3u);
  // By what they put at stake: half of 1.8 m2, 0.03 of 12 m2, 0.15 of 0.5 m2.
  EXPECT_EQ(review.doubts[0].kinds,
            (std::vector<WarningKind>{WarningKind::Standing, WarningKind::Hanging}));
  EXPECT_NEAR(review.doubts[0].stake, 0.9, 1e-9);
  EXPECT_EQ(review.doubts[1].kinds,
            (std::vector<WarningKind>{WarningKind::Hidden, WarningKind::Open}));
  EXPECT_TRUE(review.doubts[1].at.allFinite());
  EXPECT_NEAR(review.doubts[1].stake, 0.36, 1e-9);
  EXPECT_EQ(review.doubts[2].at, Eigen::Vector2d(3.5, 2));
}

TEST(PlanReview, WallsAMetreFromEachOtherAreOneDoubtThatNamesThemAll)
{
  Floorplan plan =
      measuredRoom(polygon({{0, 0}, {12, 0}, {12, 9}, {6, 9}, {6, 8.5}, {0, 8.5}}));
  hideWall(plan, 4);
  const std::vector<PlanWarning> off{
      {WarningKind::WallOff, {4, -7}, 1, 3, "", {6.4, 9}},
      {WarningKind::WallOff, {2, -7}, 1, 1, "", {5, 0}},
      {WarningKind::WallOff, {0.4, -7}, 1, 0, "", {5.5, 0}}};
  const PlanReview review = reviewOf(plan, off);
  ASSERT_EQ(review.doubts.size(), 2u);
  const PlanDoubt& corner = review.doubts[0];
  EXPECT_EQ(corner.subject, "wall 1.4");
  EXPECT_EQ(corner.beside, std::vector<std::string>{"wall 1.3"});
  EXPECT_TRUE(says(corner.text, "; beside it wall 1.3, "));
  EXPECT_NEAR(corner.stake,
              review.walls[2].area * (1 - review.walls[2].right()) +
                  review.walls[3].area * (1 - review.walls[3].right()),
              1e-9);
  EXPECT_EQ(review.doubts[1].beside, std::vector<std::string>{"column of room 1"});
  EXPECT_EQ(leadingSubjects(review.doubts).count("wall 1.3"), 1u);
  EXPECT_EQ(leadingSubjects({corner}, 0).size(), 0u);
  plan.rooms.push_back(plan.rooms[0]);
  plan.rooms[1].id = 2;
  plan.rooms[1].floor = slabAt(2.7);
  plan.rooms[1].ceiling = slabAt(5.2);
  const std::vector<PlanDoubt> doubts = reviewOf(plan, off).doubts;
  EXPECT_TRUE(std::any_of(doubts.begin(), doubts.end(), [](const PlanDoubt& doubt) {
    return doubt.subject == "wall 2.4" && doubt.beside.empty();
  })) << "on another storey";
}

TEST(PlanReview, ANarrowDoorIsADoubtOfTheDoor)
{
  Floorplan plan = measuredRoom();
  plan.openings[0].end = {1.6, 0};
  const PlanReview review = reviewOf(plan, {});
  ASSERT_EQ(review.doubts.size(), 1u);
  EXPECT_EQ(review.doubts[0].subject, "door D1");
  EXPECT_TRUE(says(review.doubts[0].text, "% sure: a door of 0.60 m"));
  EXPECT_NEAR(review.doubts[0].stake, 1.2 * (1 - review.openings[0].right()), 1e-9);
  plan.openings.insert(plan.openings.begin(), plan.openings[0]);
  plan.openings[0].kind = OpeningKind::Window; // above it
  EXPECT_EQ(reviewOf(plan, {}).doubts[0].subject, "door D1");
}

TEST(PlanReview, APlanIsNotHandedOverIfNobodySawALargePartOfItsOutline)
{
  Floorplan plan = measuredRoom();
  const PlanReview seen = reviewOf(plan, {});
  for (const std::size_t wall : {2, 3}) {
    PlanElement& element = plan.rooms[0].boundary.elements[wall - 1];
    element.evidence = {};
    element.accuracy = {};
  }
  const PlanReview review = reviewOf(plan, {});
  EXPECT_EQ(review.verdict, ReviewVerdict::ScanAgain) << review.text;
  ASSERT_EQ(review.doubts.size(), 2u);
  EXPECT_EQ(review.doubts[0].subject, "wall 1.3");
  EXPECT_TRUE(says(review.doubts[0].text, "0 % of it was measured"));
  EXPECT_LT(review.within[2], seen.within[2] - 0.2);
}

TEST(PlanReview, EnoughIsCheckedForLittleToRemainAtStake)
{
  // 35 m2 of walls and 12 m2 of floor: 2 % is 0.94 m2, a tenth 4.7 m2.
  const auto of = [](std::vector<double> areas) {
    std::vector<PlanWarning> warnings;
    for (std::size_t k = 0; k < areas.size(); ++k)
      warnings.push_back(
          {WarningKind::LeftOut, {areas[k]}, 0, 0, "a bay", {10.0 * k, 10}});
    return reviewOf(measuredRoom(), warnings);
  };
  EXPECT_EQ(of({0.9}).verdict, ReviewVerdict::HandOver);
  EXPECT_EQ(of({0.9}).doubts.size(), 1u) << "it is told all the same";
  const PlanReview two = of({0.8, 0.8, 2.5, 2});
  EXPECT_EQ(two.verdict, ReviewVerdict::Check);
  EXPECT_EQ(two.checks, 2u);
  EXPECT_EQ(two.text.rfind("check the first 2 places before you hand it over: ", 0), 0u)
      << two.text;
  EXPECT_EQ(of({2}).text.rfind("check this place", 0), 0u);
  const PlanReview small = of(std::vector<double>(30, 0.3));
  EXPECT_EQ(small.checks, 10u);
  EXPECT_TRUE(
      says(small.text, "hand it over (6 % of walls and floors remain at stake): "));
  const PlanReview many = of({3, 3, 3, 3});
  EXPECT_EQ(many.verdict, ReviewVerdict::ScanAgain);
  EXPECT_EQ(many.text.rfind("scan again, 13 % of walls and floors are at stake", 0), 0u)
      << many.text;
  const std::vector<std::string> lines = firstOf(many.doubts);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[3], "and 1 more place where less is at stake, see the report");
}

TEST(PlanReview, WhatIsAtStakeCountsOnce)
{
  // Half of 12 m2 are at stake as the room, about as much as all four walls: 13 %.
  Floorplan plan = measuredRoom();
  const std::vector<PlanWarning> room{{WarningKind::SmallRoom, {12}, 1}};
  const PlanReview alone = reviewOf(plan, room);
  EXPECT_TRUE(says(alone.text, "again, 13 %"));
  const PlanReview plan_too =
      reviewOf(plan, {room[0], warningOf(WarningKind::Stage, "odd")});
  EXPECT_TRUE(says(plan_too.text, "again, 13 %"));
  hideWall(plan, 2);
  EXPECT_EQ(reviewOf(plan, room).doubts.size(), 2u);
  EXPECT_EQ(reviewOf(plan, room).text.substr(0, 16), alone.text.substr(0, 16));
  for (const std::size_t wall : {1, 3, 4})
    hideWall(plan, wall);
  const PlanReview hidden = reviewOf(plan, room);
  double walls = 0;
  for (const Certainty& wall : hidden.walls)
    walls += wall.area * (1 - wall.right());
  ASSERT_GT(walls, 6) << "more than the room";
  EXPECT_EQ(hidden.text.rfind("scan again, " +
                                  std::to_string(std::lround(100 * walls / 47)) + " %",
                              0),
            0u)
      << hidden.text;
}

TEST(PlanReview, AWrongUnitOrAxisIsNotScannedAgain)
{
  for (const WarningKind kind : {WarningKind::Unit, WarningKind::Up}) {
    const PlanReview review = reviewOf(measuredRoom(), {warningOf(kind, "odd")});
    EXPECT_EQ(review.verdict, ReviewVerdict::Check);
    EXPECT_EQ(review.checks, 1u);
    const PlanReview more = reviewOf(
        measuredRoom(), {warningOf(kind, "odd"), {WarningKind::SmallRoom, {12}, 1}});
    EXPECT_EQ(more.verdict, ReviewVerdict::ScanAgain);
  }
}

TEST(PlanReview, SharesOfWallsAreThoseOfTheirArea)
{
  Floorplan plan = measuredRoom();
  hideWall(plan, 2);
  const PlanReview review = reviewOf(plan, {});
  double expected = 0;
  for (const Certainty& wall : review.walls)
    expected += wall.area * wall.within[1] / 35;
  EXPECT_NEAR(review.within[1], expected, 1e-9);
  plan.rooms[0].boundary = sedr_test::rectangle(0, 0, 4, 3); // nothing is known
  EXPECT_EQ(reviewOf(plan, {}).within[0], 1);
}

} // namespace
