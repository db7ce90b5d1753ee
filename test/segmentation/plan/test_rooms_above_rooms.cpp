// SPDX-License-Identifier: BSD-3-Clause
#include "room_evidence.h"
#include "two_storeys.h"

#include "sedr_segmentation/src/openings/opening_search.h"
#include "sedr_segmentation/src/plan/rooms_above.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

/** The plan fitted to the points of the rooms of another one. */
Floorplan
fittedTo(const Floorplan& truth)
{
  RoomPoints points(0.05);
  PlanEvidence evidence;
  for (const PlanRoom& room : truth.rooms)
    addRoom(points, points.room(room), room.id, evidence);
  return planOf(points, evidence);
}

TEST(RoomsAboveRooms, TakeNothingFromEachOther)
{
  for (const double shift : {0.0, 0.05, 0.3, -1.0}) {
    const Floorplan truth = twoStoreys(shift);
    const Floorplan plan = fittedTo(truth);
    ASSERT_EQ(plan.rooms.size(), 4u) << shift;
    for (std::size_t r = 0; r < 4; ++r) {
      EXPECT_EQ(plan.rooms[r].boundary.elements.size(), 4u) << shift;
      EXPECT_LT(cornerError(plan.rooms[r].boundary, truth.rooms[r].boundary), 0.005)
          << shift;
    }
  }
}

TEST(RoomsAboveRooms, KeepTheirNiches)
{
  Floorplan plan = twoStoreys(0.5);
  // A niche in the wall to the next room, below an existing room.
  const PlanNiche niche{{polygon({{1, 3}, {1, 3.2}, {2, 3.2}, {2, 3}})},
                        slabAt(1),
                        slabAt(2)};
  plan.rooms[2].boundary = rectangle(0, 0, 4.5, 3.5);
  EXPECT_FALSE(isShared(plan, plan.rooms[0], niche));
  plan.rooms[2].floor = slabAt(0);
  EXPECT_TRUE(isShared(plan, plan.rooms[0], niche)) << "the other room is beside it";
}

/** A roof over the hall, rising by `rise` in each metre along x. */
PlanDetail
roofOver(const PlanLoop& loop, double height, double rise)
{
  PlanDetail roof = detailOf(loop, 0);
  roof.slab = slabAt(height, rise);
  roof.is_facet = true;
  return roof;
}

/** A hall of 6 x 4 m, 2.5 m high but for a roof 5 m high for x from 4, and above it a
 * gallery on x up to 5. */
Floorplan
hallBelowGallery()
{
  Floorplan plan;
  plan.rooms = {roomBetween(rectangle(0, 0, 6, 4), 0, 2.5, 1),
                roomBetween(rectangle(0, 0, 5, 4), 2.7, 5.2, 2)};
  plan.rooms[0].details = {roofOver(rectangle(4, 0, 6, 4), 5, 0)};
  return plan;
}

TEST(RoomsAboveRooms, EndTheCeilingsBelowAtTheirFloors)
{
  Floorplan plan = hallBelowGallery();
  endBelowRoomsAbove(plan, Priors());
  const PlanRoom& hall = plan.rooms[0];
  EXPECT_NEAR(hall.ceilingAt({1, 1}), 2.5, 1e-9);    // below the slab
  EXPECT_NEAR(hall.ceilingAt({4.5, 3}), 2.69, 1e-9); // open to the gallery
  EXPECT_NEAR(hall.ceilingAt({5.5, 2}), 5, 1e-9);    // beside it, below the roof
  ASSERT_EQ(hall.details.size(), 2u);
  EXPECT_EQ(hall.details[1].slab.inferred, 1);
  EXPECT_NEAR(hall.details[1].boundary.area(), 1.01 * 4, 1e-9);
  EXPECT_TRUE(plan.rooms[1].details.empty());
}

TEST(RoomsAboveRooms, NothingStaysOfAFacetBelowOneOfThem)
{
  Floorplan plan = hallBelowGallery();
  plan.rooms[1].boundary = rectangle(0, 0, 6, 4);
  endBelowRoomsAbove(plan, Priors());
  ASSERT_EQ(plan.rooms[0].details.size(), 1u);
  EXPECT_EQ(plan.rooms[0].details[0].slab.inferred, 1);
  EXPECT_NEAR(plan.rooms[0].ceilingAt({5, 2}), 2.69, 1e-9);
}

TEST(RoomsAboveRooms, AReliefThatRisesThroughThemEndsAtThem)
{
  // A relief that rises from 2 m at x = 0 to 3 m at x = 6.
  Floorplan plan = hallBelowGallery();
  SlabCurve relief;
  relief.kind = CurveKind::Relief;
  relief.spacing = 0.5;
  relief.centre = {0.001, 0.001};
  relief.columns = 13;
  for (int k = 0; k < 9 * 13; ++k)
    relief.heights.push_back(2 + (0.001 + 0.5 * (k % 13)) / 6);
  plan.rooms[0].details[0].slab.curve = std::make_shared<const SlabCurve>(relief);
  endBelowRoomsAbove(plan, Priors());
  ASSERT_EQ(plan.rooms[0].details.size(), 1u);
  EXPECT_NEAR(plan.rooms[0].ceilingAt({4, 3.5}), 2 + 4 / 6.0, 1e-9);
  EXPECT_NEAR(plan.rooms[0].ceilingAt({4.9, 3}), 2.69, 1e-9) << "open to the gallery";
  EXPECT_NEAR(plan.rooms[0].ceilingAt({5.99, 1}), 3, 0.01) << "beside it";
  // Of the heights at x = 4, 4.5, 5 and 5.5 all but the first are lowered.
  EXPECT_NEAR(plan.rooms[0].details[0].slab.inferred, 0.75, 1e-9);
}

TEST(RoomsAboveRooms, APieceOfAFacetBesideStripsStays)
{
  // Of 20 x 4 m a shaft of 0.8 x 0.8 m is left, and 2 cm all along both sides.
  Floorplan plan;
  plan.rooms = {roomBetween(rectangle(0, 0, 20, 4), 0, 2.5, 1),
                roomBetween(rectangle(0, 0.03, 20, 3.97), 2.7, 5.2, 2)};
  plan.rooms[0].details = {roofOver(rectangle(0, 0, 20, 4), 5, 0)};
  plan.rooms[1].columns = {reversed(rectangle(4, 3, 4.8, 3.8))};
  endBelowRoomsAbove(plan, Priors());
  EXPECT_NEAR(plan.rooms[0].ceilingAt({4.4, 3.4}), 5, 1e-9);
  EXPECT_NEAR(plan.rooms[0].ceilingAt({9, 2}), 2.69, 1e-9);
}

TEST(RoomsAboveRooms, TheLowestOfThemCounts)
{
  for (const bool is_highest_first : {false, true}) {
    Floorplan plan = hallBelowGallery();
    plan.rooms.push_back(roomBetween(rectangle(0, 0, 5.5, 4), 4, 6, 3));
    if (is_highest_first)
      std::swap(plan.rooms[1], plan.rooms[2]);
    endBelowRoomsAbove(plan, Priors());
    EXPECT_NEAR(plan.rooms[0].ceilingAt({4.5, 2}), 2.69, 1e-9);
    EXPECT_NEAR(plan.rooms[0].ceilingAt({5.2, 2}), 3.99, 1e-9);
    EXPECT_NEAR(plan.rooms[0].ceilingAt({5.8, 2}), 5, 1e-9);
  }
}

TEST(RoomsAboveRooms, AndTheLowestPartOfTheirFloors)
{
  Floorplan plan = hallBelowGallery();
  plan.rooms[1].floor_details = {roofOver(rectangle(4.5, 1, 5, 3), 2.6, 0)};
  endBelowRoomsAbove(plan, Priors());
  EXPECT_NEAR(plan.rooms[0].ceilingAt({4.2, 2}), 2.69, 1e-9);
  EXPECT_NEAR(plan.rooms[0].ceilingAt({4.8, 2}), 2.59, 1e-9);
}

TEST(RoomsAboveRooms, RaiseNoCeiling)
{
  // It rises from 2.2 to 3.2 m and crosses the floor above.
  Floorplan plan;
  plan.rooms = {roomBetween(rectangle(0, 0, 6, 4), 0, 2.5, 1),
                roomBetween(rectangle(0, 0, 6, 4), 2.7, 5.2, 2)};
  plan.rooms[0].ceiling = roofOver({}, 2.2, 1.0 / 6).slab;
  const PlanRoom before = plan.rooms[0];
  endBelowRoomsAbove(plan, Priors());
  for (double x = 0.05; x < 6; x += 0.1)
    EXPECT_NEAR(plan.rooms[0].ceilingAt({x, 2}),
                std::min(before.ceilingAt({x, 2}), 2.69), 1e-9)
        << x;
}

} // namespace
