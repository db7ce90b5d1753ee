// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/floorplan.h>

#include "plan_loops.h"

#include "sedr_filters/src/base/plane_fit.h"
#include <pcl/sedr_filters/floorplan_io.h>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

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
