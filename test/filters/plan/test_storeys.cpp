// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"
#include "sedr_filters/src/base/plane_fit.h"
#include "two_storeys.h"

#include <gtest/gtest.h>
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_filters/plan_measures.h>

#include <string>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

using Ids = std::vector<std::uint32_t>;

TEST(Storeys, RoomsAboveEachOtherAreOfSeveral)
{
  const Floorplan plan{{roomBetween(rectangle(0, 0, 4, 3), 2.8, 5.3, 3),
                        roomOf(rectangle(0, 0, 4, 3), 2.5, 2),
                        roomBetween(rectangle(5, 0, 9, 3), 0.4, 3, 1)}};
  const auto storeys = storeysOf(plan);
  ASSERT_EQ(storeys.size(), 2u);
  EXPECT_EQ(storeys[0].number, 1u);
  EXPECT_EQ(storeys[0].name, "storey 1");
  EXPECT_EQ(storeys[0].rooms, (Ids{1, 2}));
  EXPECT_NEAR(storeys[0].floor, 0, 1e-9);
  EXPECT_NEAR(storeys[0].ceiling, 3, 1e-9);
  EXPECT_EQ(storeys[1].number, 2u);
  EXPECT_EQ(storeys[1].name, "storey 2");
  EXPECT_EQ(storeys[1].rooms, Ids{3});
  EXPECT_NEAR(storeys[1].floor, 2.8, 1e-9);
  EXPECT_NEAR(storeys[1].ceiling, 5.3, 1e-9);
}

TEST(Storeys, AVaultBesideTheMiddleOfItsRoomIsNoHeightThere)
{
  PlanRoom room = roomOf(rectangle(0, 0, 4, 3), 2.5, 1);
  SlabCurve vault;
  vault.centre = {0.5, 1.5};
  vault.across = vault.up = 0.5;
  vault.base = 1;
  room.ceiling.curve = std::make_shared<SlabCurve>(vault);
  room.details = {detailOf(rectangle(1, 0, 4, 3), 3)};
  const auto storeys = storeysOf(Floorplan{{room}});
  ASSERT_EQ(storeys.size(), 1u);
  EXPECT_NEAR(storeys[0].ceiling, 3, 1e-9);
}

TEST(Storeys, ThoseOfThePlanStandWhateverTheHeightsOfTheirRooms)
{
  Floorplan plan = twoStoreys();
  plan.storeys = {{1, "cellar", 0, 0, {1}}, {2, "rest", 0, 0, {2, 3, 4}}};
  const auto storeys = storeysOf(plan);
  ASSERT_EQ(storeys.size(), 2u);
  EXPECT_EQ(storeys[0].name, "cellar");
  EXPECT_EQ(storeys[1].rooms, (Ids{2, 3, 4}));
  EXPECT_NEAR(storeys[1].floor, 0, 1e-9);
  EXPECT_NEAR(storeys[1].ceiling, 5.2, 1e-9);
}

TEST(Storeys, RoomsThatAreGoneAreLeftOutAndNewOnesGoToTheNearest)
{
  Floorplan plan = twoStoreys();
  plan.storeys = {{1, "one", 0, 2.5, {1, 2}},
                  {2, "two", 2.8, 5.2, {3}},
                  {3, "three", 5.5, 8, {9}}};
  plan.rooms.erase(plan.rooms.begin());
  const auto storeys = storeysOf(plan);
  ASSERT_EQ(storeys.size(), 2u);
  EXPECT_EQ(storeys[0].rooms, Ids{2});
  EXPECT_EQ(storeys[1].number, 2u);
  EXPECT_EQ(storeys[1].rooms, (Ids{3, 4}));
}

TEST(Storeys, APartHasTheRoomsOpeningsAndStairsOfItsStorey)
{
  Floorplan plan = twoStoreys();
  plan.openings.resize(3);
  plan.openings[0].rooms = {1, 2};
  plan.openings[1].rooms = {3, 4};
  plan.openings[2].rooms = {3, 0};
  plan.stairs.resize(1);
  plan.stairs[0].rooms = {2, 4};
  const auto storeys = storeysOf(plan);
  const Floorplan lower = partOf(plan, storeys[0]);
  const Floorplan upper = partOf(plan, storeys[1]);
  ASSERT_EQ(lower.rooms.size(), 2u);
  EXPECT_EQ(lower.rooms[1].id, 2u);
  EXPECT_EQ(lower.openings.size(), 1u);
  EXPECT_EQ(lower.stairs.size(), 1u);
  ASSERT_EQ(upper.storeys.size(), 1u);
  EXPECT_EQ(upper.storeys[0].name, "storey 2");
  EXPECT_EQ(upper.openings.size(), 2u);
  EXPECT_EQ(upper.stairs.size(), 1u);
}

TEST(Storeys, AWallIsNotAsThickAsItIsFarFromOneAboveIt)
{
  const Floorplan plan{{roomBetween(rectangle(0, 0, 4, 3), 0, 2.5, 1),
                        roomBetween(rectangle(4.3, 0, 8, 3), 0, 2.5, 2),
                        roomBetween(rectangle(4.1, 0, 8, 3), 2.8, 5.2, 3)}};
  EXPECT_NEAR(wallThicknesses(plan)[0][1], 0.3, 1e-9);
  EXPECT_EQ(wallThicknesses(plan)[2][3], 0);
}

TEST(StoreysInJson, StairsWithinARoomAreThoseWithFlights)
{
  Floorplan plan = twoStoreys();
  PlanFlight flight;
  flight.rise = 0.175;
  for (const double x : {5.0, 5.25, 5.5})
    flight.risers.push_back({Eigen::Vector2d(x, 1), Eigen::Vector2d(x, 0)});
  plan.stairs = {{{2, 2}, {5, 1.5}, 0, 2.8, {flight}}};
  std::string problem;
  EXPECT_EQ(floorplanFromJson(floorplanToJson(plan), problem).stairs.size(), 1u);
  plan.stairs[0].flights.clear();
  EXPECT_TRUE(floorplanFromJson(floorplanToJson(plan), problem).stairs.empty());
}

TEST(StoreysInJson, ARoomThatIsGoneIsOutside)
{
  Floorplan plan = twoStoreys();
  plan.storeys = {{1, "ground", 0, 2.5, {1, 2}}, {3, "attic", 2.8, 5.2, {3, 4}}};
  plan.stairs = {{{2, 4}, {5, 1.5}, 0, 2.8}};
  plan.rooms.erase(plan.rooms.begin(), plan.rooms.begin() + 2);
  std::string problem;
  const Floorplan read = floorplanFromJson(floorplanToJson(plan), problem);
  ASSERT_EQ(read.storeys.size(), 1u) << problem;
  EXPECT_EQ(read.storeys[0].name, "attic");
  ASSERT_EQ(read.stairs.size(), 1u);
  EXPECT_EQ(read.stairs[0].rooms, (std::array<std::uint32_t, 2>{0, 4}));
}

SlabCurve
barrel()
{
  SlabCurve curve;
  curve.centre = {1, 2};
  curve.base = 0.5;
  curve.setDirection(30 * M_PI / 180);
  curve.across = curve.up = 2;
  return curve;
}

SlabCurve
dome()
{
  SlabCurve curve = barrel();
  curve.kind = CurveKind::Ellipsoid;
  curve.along = 3;
  curve.up = 1;
  return curve;
}

SlabCurve
relief()
{
  SlabCurve curve;
  curve.kind = CurveKind::Relief;
  curve.centre = {1, 1};
  curve.spacing = 0.5;
  curve.columns = 3;
  curve.heights = {2, 2.5, 3, 2, 2.5, 3}; // a slope along x
  return curve;
}

/** Returns the direction to the left of a curve's axis. */
Eigen::Vector2d
asideOf(const SlabCurve& curve)
{
  return {-curve.axis.y(), curve.axis.x()};
}

TEST(SlabCurve, AReliefIsStraightBetweenItsHeightsAndLevelBesideThem)
{
  const SlabCurve curve = relief();
  EXPECT_NEAR(curve.heightAt({1.25, 1.1}), 2.25, 1e-12);
  EXPECT_NEAR(curve.heightAt({9, 9}), 3, 1e-12);
  EXPECT_NEAR(curve.gradientAt({1.6, 1.2}).x(), 1, 1e-12);
  EXPECT_NEAR(curve.gradientAt({1.6, 1.2}).y(), 0, 1e-12);
}

TEST(SlabCurve, DistancesFromRoundOnesAreExact)
{
  const SlabCurve curve = barrel();
  const Eigen::Vector2d place = curve.centre + 1.2 * asideOf(curve) + 4 * curve.axis;
  const Eigen::Vector3d p(place.x(), place.y(), 0.5 + 0.9); // 1.5 from the axis
  EXPECT_NEAR(curve.distanceAbove(p), -0.5, 1e-12);
  PlanSlab slab;
  slab.curve = std::make_shared<const SlabCurve>(curve);
  EXPECT_NEAR(distanceAbove(slab, p.cast<float>()), -0.5, 1e-6);
  EXPECT_NEAR((slab.normalAt(place) -
               Eigen::Vector3d(asideOf(curve).x() * 0.6, asideOf(curve).y() * 0.6, 0.8))
                  .norm(),
              0, 1e-9);
}

TEST(SlabCurve, MovesWithItsPlan)
{
  const SlabCurve curve = dome();
  const SlabCurve there = moved(curve, 0.7, {3, -1, 0.2});
  const Eigen::Vector2d p = curve.centre + Eigen::Vector2d(0.5, 0.3);
  const Eigen::Vector2d q = Eigen::Rotation2Dd(0.7) * p + Eigen::Vector2d(3, -1);
  EXPECT_NEAR(there.heightAt(q), curve.heightAt(p) + 0.2, 1e-12);
}

Floorplan
vaultedPlan()
{
  Floorplan plan;
  PlanRoom room = roomOf(rectangle(0, 0, 4, 4), 2.5);
  room.ceiling.curve = std::make_shared<const SlabCurve>(barrel());
  room.ceiling.inferred = 1.0 / 3;
  for (const SlabCurve& curve : {dome(), relief()}) {
    room.details.push_back(detailOf(rectangle(1, 1, 2, 2), 2.2));
    room.details.back().is_facet = true;
    room.details.back().slab.curve = std::make_shared<const SlabCurve>(curve);
  }
  room.details.push_back(detailOf(rectangle(3, 3, 3.5, 3.5), 2.2));
  plan.rooms.push_back(room);
  return plan;
}

TEST(SlabCurveJson, FacetsReadBackAsTheyWereWritten)
{
  const Floorplan plan = vaultedPlan();
  const std::string text = floorplanToJson(plan);
  std::string problem;
  const Floorplan read = floorplanFromJson(text, problem);
  ASSERT_EQ(problem, "");
  const PlanRoom& room = read.rooms[0];
  EXPECT_EQ(room.ceiling.inferred, 1.0 / 3);
  ASSERT_EQ(room.details.size(), 3U);
  EXPECT_TRUE(room.details[0].is_facet && room.details[1].is_facet);
  EXPECT_FALSE(room.details[2].is_facet);
  for (int d = -1; d < 3; ++d)
    for (const Eigen::Vector2d& p : {Eigen::Vector2d(1.3, 1.7), {0.1, 3.2}})
      EXPECT_EQ(room.ceilingSlab(d).heightAt(p),
                plan.rooms[0].ceilingSlab(d).heightAt(p));
  EXPECT_EQ(floorplanToJson(read), text);
}

} // namespace
