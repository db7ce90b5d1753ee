// SPDX-License-Identifier: BSD-3-Clause
#include "room_evidence.h"
#include "two_storeys.h"

#include "sedr_segmentation/src/openings/opening_search.h"
#include "sedr_segmentation/src/plan/rooms_above.h"

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

/** A hall of 6 x 4 m below a ceiling that rises from `height` by `rise` in each metre,
 * and a room above all of it. */
Floorplan
hallBelowRoom(double height, double rise)
{
  Floorplan plan{{roomBetween(rectangle(0, 0, 6, 4), 0, 2.5, 1),
                  roomBetween(rectangle(0, 0, 6, 4), 2.7, 5.2, 2)}};
  plan.rooms[0].ceiling = slabAt(height, rise);
  return plan;
}

TEST(RoomsAboveRooms, EndTheCeilingsBelowAtTheirFloorsAndRaiseNone)
{
  struct Case {
    const char* what;
    Floorplan plan;
    std::vector<Eigen::Vector3d> ceilings; ///< of the first room: x, y, height
    std::size_t details;                   ///< of it
  };
  Floorplan covered = hallBelowGallery();
  covered.rooms[1].boundary = rectangle(0, 0, 6, 4);
  Floorplan relief = hallBelowGallery(); // that rises from 2 m at x = 0 to 3 m at x = 6
  SlabCurve heights;
  heights.kind = CurveKind::Relief;
  heights.spacing = 0.5;
  heights.centre = {0.001, 0.001};
  heights.columns = 13;
  for (int k = 0; k < 9 * 13; ++k)
    heights.heights.push_back(2 + (0.001 + 0.5 * (k % 13)) / 6);
  relief.rooms[0].details[0].slab.curve = std::make_shared<const SlabCurve>(heights);
  // Of 20 x 4 m a shaft of 0.8 x 0.8 m is left, and 2 cm all along both sides.
  Floorplan shaft{{roomBetween(rectangle(0, 0, 20, 4), 0, 2.5, 1),
                   roomBetween(rectangle(0, 0.03, 20, 3.97), 2.7, 5.2, 2)}};
  shaft.rooms[0].details = {roofOver(rectangle(0, 0, 20, 4), 5, 0)};
  shaft.rooms[1].columns = {reversed(rectangle(4, 3, 4.8, 3.8))};
  Floorplan round_void = hallBelowGallery();
  round_void.rooms[0].details = {roofOver(rectangle(0, 0, 6, 4), 5, 0)};
  round_void.rooms[1].boundary = bittenRectangle(6, 4, 1.2);
  Floorplan two = hallBelowGallery();
  two.rooms.push_back(roomBetween(rectangle(0, 0, 5.5, 4), 4, 6, 3));
  Floorplan highest_first = two;
  std::swap(highest_first.rooms[1], highest_first.rooms[2]);
  const std::vector<Eigen::Vector3d> steps{{4.5, 2, 2.69}, {5.2, 2, 3.99}, {5.8, 2, 5}};
  Floorplan pit = hallBelowGallery();
  pit.rooms[1].floor_details = {roofOver(rectangle(4.5, 1, 5, 3), 2.6, 0)};
  for (const Case& c : std::vector<Case>{
           {"beside a gallery",
            hallBelowGallery(),
            {{1, 1, 2.5}, {4.5, 3, 2.69}, {5.5, 2, 5}},
            2},
           {"of a facet below a room nothing stays", covered, {{5, 2, 2.69}}, 1},
           {"a relief",
            relief,
            {{4, 3.5, 2 + 4 / 6.0}, {4.9, 3, 2.69}, {5.99, 1, 2 + 5.99 / 6}},
            1},
           {"a piece beside strips stays", shaft, {{4.4, 3.4, 5}, {9, 2, 2.69}}, 2},
           {"a round void",
            round_void,
            {{3, 1.15, 5}, {3.8, 0.8, 5}, {3.9, 0.9, 2.69}, {5.9, 0.1, 2.69}},
            2},
           {"the lowest room counts", two, steps, 3},
           {"in any order", highest_first, steps, 3},
           {"the lowest part of a floor", pit, {{4.2, 2, 2.69}, {4.8, 2, 2.59}}, 3},
           {"that rises through a floor",
            hallBelowRoom(2.2, 1.0 / 6),
            {{0.05, 2, 2.2 + 0.05 / 6},
             {2.9, 2, 2.2 + 2.9 / 6},
             {3, 2, 2.69},
             {5.95, 2, 2.69}},
            1}}) {
    Floorplan plan = c.plan;
    endBelowRoomsAbove(plan, Priors());
    for (const Eigen::Vector3d& p : c.ceilings)
      EXPECT_NEAR(plan.rooms[0].ceilingAt(p.head<2>()), p.z(), 0.006)
          << c.what << " at " << p.transpose();
    EXPECT_EQ(plan.rooms[0].details.size(), c.details) << c.what;
    const PlanDetail& last = plan.rooms[0].details.back();
    EXPECT_NEAR(last.slab.inferred, last.slab.curve ? 0.75 : 1, 1e-9)
        << c.what << ", of heights at x = 4, 4.5, 5 and 5.5 all but the first";
    EXPECT_TRUE(plan.rooms[1].details.empty()) << c.what;
  }
}

} // namespace
