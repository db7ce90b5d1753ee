// SPDX-License-Identifier: BSD-3-Clause
// Recesses of a loop that are openings: below a lintel, or with a pane.
#include "sedr_segmentation/src/loop/loop_recesses.h"

#include "segmentation/loop/recess_room.h"
#include "segmentation/plan/room_evidence.h"

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

TEST(LoopOpenings, BelowALintelAreNoRecessesHoweverNarrow)
{
  PlanRoom room = roomOf(polygon({{0, 0},
                                  {5, 0},
                                  {5, 4},
                                  {2.7, 4},
                                  {2.7, 4.1},
                                  {2.35, 4.1},
                                  {2.35, 4},
                                  {0, 4}}),
                         2.6);
  RoomPoints points;
  points.wall(segment({3.5, 4}, {1.5, 4}), 2.05, 2.6);
  closeRecesses(room, points.view(), points.all());
  EXPECT_EQ(room.boundary.elements.size(), 4u);
}

TEST(LoopOpenings, AStrayIsNoLintel)
{
  for (const bool has_lintel : {true, false}) {
    PlanRoom room = roomOf(polygon({{0, 0},
                                    {5, 0},
                                    {5, 4},
                                    {2.6, 4},
                                    {2.6, 4.1},
                                    {2.35, 4.1},
                                    {2.35, 4},
                                    {0, 4}}),
                           2.6);
    RoomPoints points;
    points.wall(segment({2.6, 4.1}, {2.35, 4.1}), 0, 2.6);
    const double width = has_lintel ? 0.25 : 0.03;
    points.wall(segment({2.46 + width / 2, 4}, {2.46 - width / 2, 4}), 2.42, 2.45);
    if (has_lintel)
      points.wall(segment({2.6, 4}, {2.35, 4}), 2.05, 2.6);
    closeRecesses(room, points.view(), points.all());
    EXPECT_EQ(room.boundary.elements.size(), has_lintel ? 4u : 8u);
  }
}

TEST(LoopOpenings, BelowALintelUpToALowerPartOfTheCeilingAreNoRecesses)
{
  PlanRoom room = roomOf(withRecess(0.1), 2.6);
  RoomPoints points;
  points.wall(segment({3.5, 4.1}, {1.5, 4.1}), 0, 2.05);
  points.wall(segment({3.5, 4}, {1.5, 4}), 2.05, 2.3);
  points.slab(rectangle(0, 3, 5, 4), 2.3);
  points.slab(rectangle(0, 0, 5, 3), 2.6);
  closeRecesses(room, points.view(), points.all());
  EXPECT_EQ(room.boundary.elements.size(), 4u);
}

/** A recess 15 cm deep whose back was seen from floor to ceiling, and more. */
RoomPoints
recessAndMore(const std::vector<PlanElement>& more, double noise)
{
  RoomPoints points(0.05, noise);
  points.wall(segment({3.5, 4.15}, {1.5, 4.15}), 0, 2.6);
  for (const PlanElement& e : more)
    points.wall(e, 0, 2.6);
  return points;
}

std::size_t
elementsWith(const std::vector<PlanElement>& more, double noise = 0.003)
{
  PlanRoom room = roomOf(withRecess(0.15), 2.6);
  const RoomPoints points = recessAndMore(more, noise);
  closeRecesses(room, points.view(), points.all());
  return room.boundary.elements.size();
}

PlanElement
jamb(double x, double reveal) ///< metres, behind the back
{
  return segment({x, 4}, {x, 4.15 + reveal});
}

TEST(LoopOpenings, AreRecessesInWhichAPaneStands)
{
  for (const double noise : {0.003, 0.02}) {
    EXPECT_EQ(elementsWith({jamb(1.5, 0.15), jamb(3.5, 0.15)}, noise), 4u);
    EXPECT_EQ(elementsWith({jamb(1.5, 0), jamb(3.5, 0)}, noise), 8u);
    EXPECT_EQ(elementsWith({jamb(1.5, 0.15)}, noise), 8u) << "one jamb";
    EXPECT_EQ(elementsWith({jamb(3.5, 0.15)}, noise), 8u) << "one jamb";
  }
}

TEST(LoopOpenings, AreNoneWhereTheOtherFaceOfTheWallWasSeen)
{
  for (const double noise : {0.003, 0.02})
    for (const double behind : {0.08, 0.12, 0.25}) {
      const double y = 4.15 + behind;
      EXPECT_EQ(elementsWith({segment({5, y}, {0, y})}, noise), 8u) << behind;
      EXPECT_EQ(elementsWith({segment({3.5, y}, {1.5, y})}, noise), 8u) << behind;
    }
}
} // namespace
