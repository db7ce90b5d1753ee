// SPDX-License-Identifier: BSD-3-Clause
#include "plan_loops.h"

#include "sedr_segmentation/src/plan/doorway_reveals.h"

#include <gtest/gtest.h>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** A room 5 m by 5 m that goes on through a wall of 28 cm, 3 m wide and 1 m from the
 * corner, up to another room. The doorway is 2.1 m high, the rooms are 3 m. */
Floorplan
withReveal()
{
  const PlanLoop loop{{segment({0, 0}, {5, 0}), segment({5, 0}, {5, 1}),
                       segment({5, 1}, {5.28, 1}), segment({5.28, 1}, {5.28, 4}),
                       segment({5.28, 4}, {5, 4}), segment({5, 4}, {5, 5}),
                       segment({5, 5}, {0, 5}), segment({0, 5}, {0, 0})}};
  Floorplan plan{{roomOf(loop, 3), roomOf(rectangle(5.285, 0, 9, 5), 3, 2)}};
  plan.doorways = {{{1, 2}, {5.28, 4}, {5.28, 1}, 0, 2.1}};
  return plan;
}

TEST(DoorwayReveals, BelowALintelARevealIsPartOfTheWall)
{
  Floorplan plan = withReveal();
  for (PlanElement& e : plan.rooms[0].boundary.elements) {
    e.inliers = 10;
    e.residual = 0.01;
    e.evidence = {1, 0, 0};
  }
  closeReveals(plan);
  const PlanLoop& loop = plan.rooms[0].boundary;
  EXPECT_NEAR(loop.area(), 25, 1e-12);
  ASSERT_EQ(loop.elements.size(), 4u) << "one element a face";
  const PlanElement& wall = loop.elements[loop.nearest({5, 2.5})];
  EXPECT_NEAR(wall.length(), 5, 1e-12);
  EXPECT_EQ(wall.inliers, 20u);
  EXPECT_NEAR(wall.residual, 0.01, 1e-12);
  EXPECT_NEAR(wall.evidence.seen, 0.4, 1e-12);
  EXPECT_NEAR(wall.evidence.opening, 0.6 * 0.7, 1e-12) << "3 of 5 m, 2.1 of 3 m";
  EXPECT_NEAR(wall.evidence.hidden, 0.6 * 0.3, 1e-12);
  EXPECT_NEAR(plan.rooms[1].boundary.area(), 3.715 * 5, 1e-12);
  closeReveals(plan); // nothing is left to close
  EXPECT_NEAR(loop.area(), 25, 1e-12);
}

TEST(DoorwayReveals, WithoutALintelARoomGoesOn)
{
  Floorplan plan = withReveal();
  plan.doorways[0].top = 2.95;
  closeReveals(plan);
  EXPECT_NEAR(plan.rooms[0].boundary.area(), 25.84, 1e-12);
}

TEST(DoorwayReveals, OnlyThoseOfDoorwaysAreClosed)
{
  const auto areaWith = [](const PlanDoorway& doorway) {
    Floorplan plan = withReveal();
    plan.doorways = {doorway};
    closeReveals(plan);
    return plan.rooms[0].boundary.area();
  };
  EXPECT_NEAR(areaWith({{1, 2}, {5.14, 4}, {5.14, 1}, 0, 2.1}), 25, 1e-12);
  EXPECT_NEAR(areaWith({{2, 3}, {5.28, 4}, {5.28, 1}, 0, 2.1}), 25.84, 1e-12);
  EXPECT_NEAR(areaWith({{1, 2}, {5.9, 4}, {5.9, 1}, 0, 2.1}), 25.84, 1e-12);
  EXPECT_NEAR(areaWith({{1, 2}, {5.28, 9}, {5.28, 6}, 0, 2.1}), 25.84, 1e-12);
}

TEST(DoorwayReveals, WhatIsNoRevealStays)
{
  // A metre deep: a room of its own, or a corridor.
  Floorplan deep = withReveal();
  for (PlanElement& e : deep.rooms[0].boundary.elements)
    for (Eigen::Vector2d* p : {&e.start, &e.end})
      if (p->x() > 5.1)
        p->x() = 6;
  deep.doorways[0].start.x() = deep.doorways[0].end.x() = 6;
  closeReveals(deep);
  EXPECT_NEAR(deep.rooms[0].boundary.area(), 28, 1e-12);
  // A pilaster beside a doorway: its sides lead the other way.
  Floorplan pilaster = withReveal();
  for (PlanElement& e : pilaster.rooms[0].boundary.elements)
    for (Eigen::Vector2d* p : {&e.start, &e.end})
      if (p->x() > 5.1)
        p->x() = 4.72;
  closeReveals(pilaster);
  EXPECT_NEAR(pilaster.rooms[0].boundary.area(), 24.16, 1e-12);
}

TEST(DoorwayReveals, DetailsEndAtTheMouth)
{
  // A slope of the ceiling and a platform of 10 cm reach into the reveal.
  Floorplan plan = withReveal();
  PlanRoom& room = plan.rooms[0];
  room.floor_details = {detailOf(rectangle(4, 1, 5.28, 4), 0.1)};
  room.details = {detailOf(rectangle(3, 1, 5.28, 4), 2.8)};
  room.details[0].is_facet = true;
  closeReveals(plan);
  ASSERT_EQ(room.floor_details.size(), 1u);
  EXPECT_NEAR(room.floor_details[0].boundary.area(), 3, 1e-9);
  EXPECT_NEAR(room.floor_details[0].slab.heightAt({4.5, 2}), 0.1, 1e-12);
  ASSERT_EQ(room.details.size(), 1u);
  EXPECT_NEAR(room.details[0].boundary.area(), 6, 1e-9);
  EXPECT_TRUE(room.details[0].is_facet);
}

TEST(DoorwayReveals, AreAsDeepAsAWallMayBe)
{
  const auto areaFor = [](double max_wall) {
    Priors priors;
    priors.max_wall = max_wall;
    Floorplan plan = withReveal();
    closeReveals(plan, priors);
    return plan.rooms[0].boundary.area();
  };
  EXPECT_NEAR(areaFor(0.25), 25.84, 1e-12);
  EXPECT_NEAR(areaFor(0.3), 25, 1e-12);
}

TEST(DoorwayReveals, OfAnIslandToo)
{
  // A core within a ring; the ring goes on into the wall of the core, 20 cm deep.
  PlanRoom ring = roomOf(rectangle(0, 0, 12, 12), 3);
  ring.columns = {reversed(PlanLoop{
      {segment({3, 3}, {5, 3}), segment({5, 3}, {5, 3.2}), segment({5, 3.2}, {6, 3.2}),
       segment({6, 3.2}, {6, 3}), segment({6, 3}, {9, 3}), segment({9, 3}, {9, 9}),
       segment({9, 9}, {3, 9}), segment({3, 9}, {3, 3})}})};
  Floorplan plan{{ring, roomOf(rectangle(3.2, 3.2, 8.8, 8.8), 3, 2)}};
  plan.doorways = {{{1, 2}, {5, 3.1}, {6, 3.1}, 0, 2.1}};
  EXPECT_NEAR(plan.rooms[0].columns[0].area(), -35.8, 1e-12);
  closeReveals(plan);
  EXPECT_NEAR(plan.rooms[0].columns[0].area(), -36, 1e-12);
}

} // namespace
