// SPDX-License-Identifier: BSD-3-Clause
#include "solid_checks.h"

#include <cmath>
#include <memory>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

PlanSlab
curved(const SlabCurve& curve)
{
  PlanSlab slab = slabAt(curve.highest());
  slab.curve = std::make_shared<const SlabCurve>(curve);
  return slab;
}

SlabCurve
barrel(const Eigen::Vector2d& at, double degrees, double base, double radius)
{
  SlabCurve curve;
  curve.centre = at;
  curve.setDirection(degrees * M_PI / 180);
  curve.base = base;
  curve.across = curve.up = radius;
  return curve;
}

/** Returns the maximum distance of the ceiling's vertices and edges from a curve. */
double
farthestFrom(const SlabCurve& curve, const Solid& solid)
{
  double farthest = 0;
  for (std::size_t t = 0; t < solid.mesh.triangles.size(); ++t)
    if (solid.mesh.labels[t] == 1)
      for (std::size_t k = 0; k < 3; ++k)
        for (const double share : {0.0, 0.5}) {
          const Eigen::Vector3d p = (1 - share) * solid.mesh.corner(t, k) +
                                    share * solid.mesh.corner(t, (k + 1) % 3);
          farthest = std::max(farthest, std::abs(curve.distanceAbove(p)));
        }
  return farthest;
}

TEST(RoomSolidCurves, AGableIsAPrism)
{
  PlanRoom room = roomOf(rectangle(0, 0, 7, 5), 2.5);
  room.ceiling = slabAt(1, 0, 0.8); // rises by 0.8 along y
  PlanDetail other = detailOf(rectangle(0, 2.5, 7, 5), 0);
  other.slab = slabAt(5, 0, -0.8);
  other.is_facet = true;
  room.details.push_back(other);
  const Solid solid(room);
  expectPiece(solid, 7 * (5 * 1 + 2.5 * 2));
  EXPECT_EQ(solid.mesh.vertices.size(), 12U); // two below the ends of the ridge
  EXPECT_NEAR(solid.report.riser_area, 0, 1e-9);
  EXPECT_TRUE(solid.hasVertex(7, 2.5, 3));
}

TEST(RoomSolidCurves, ABarrelKeepsTheChordToleranceWithFewTriangles)
{
  PlanRoom room = roomOf(rectangle(0, 0, 8, 5), 2.5);
  const SlabCurve curve = barrel({0, 2.5}, 0, 1.2, 2.5);
  room.ceiling = curved(curve);
  SolidParameters parameters;
  parameters.chord_tolerance = 0.001;
  const Solid solid(room, parameters);
  expectSound(solid);
  EXPECT_NEAR(solid.report.volume, 8 * (5 * 1.2 + M_PI * 2.5 * 2.5 / 2),
              0.001 * 8 * M_PI * 2.5); // chords lie within
  EXPECT_LE(farthestFrom(curve, solid), 0.0011);
  EXPECT_LT(solid.mesh.triangles.size(), 500U);
}

TEST(RoomSolidCurves, ADomeInALevelCeilingMeetsItInItsRim)
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 5), 2.5);
  SlabCurve cap = barrel({3, 2.5}, 0, 2.5 - std::sqrt(9.0 - 4.0), 3);
  cap.kind = CurveKind::Ellipsoid;
  cap.along = 3;
  PlanDetail dome;
  dome.boundary = circle({3, 2.5}, 2);
  dome.slab = curved(cap);
  dome.is_facet = true;
  room.details.push_back(dome);
  const Solid solid(room);
  expectSound(solid);
  const double h = 3 - std::sqrt(5.0);
  EXPECT_NEAR(solid.report.volume, 6 * 5 * 2.5 + M_PI * h * h * (3 - h / 3), 0.02);
  EXPECT_NEAR(solid.report.riser_area, 0, 1e-6);
}

TEST(RoomSolidCurves, GroinVaultsMeetInTheirDiagonals)
{
  PlanRoom room = roomOf(rectangle(0, 0, 4, 4), 2.5);
  room.ceiling = curved(barrel({2, 2}, 0, 1, 2.2));
  for (const auto& corners : {std::vector<Eigen::Vector2d>{{0, 0}, {2, 2}, {0, 4}},
                              std::vector<Eigen::Vector2d>{{4, 0}, {4, 4}, {2, 2}}}) {
    PlanDetail lunette;
    lunette.boundary = polygon(corners);
    lunette.slab = curved(barrel({2, 2}, 90, 1, 2.2));
    lunette.is_facet = true;
    room.details.push_back(lunette);
  }
  const Solid solid(room);
  expectSound(solid);
  EXPECT_NEAR(solid.report.riser_area, 0, 1e-4);
}

TEST(RoomSolidCurves, AReliefIsBuiltOnItsGrid)
{
  PlanRoom room = roomOf(rectangle(0, 0, 4, 3), 2.5);
  SlabCurve relief;
  relief.kind = CurveKind::Relief;
  relief.centre = {-0.1, -0.1};
  relief.spacing = 0.25;
  relief.columns = 18;
  for (int y = 0; y < 14; ++y)
    for (int x = 0; x < 18; ++x)
      relief.heights.push_back(2.5 + 0.1 * std::sin(0.7 * x) * std::cos(0.5 * y));
  room.ceiling = curved(relief);
  const Solid solid(room);
  expectSound(solid);
}

TEST(RoomSolidCurves, AStepBetweenTwoVaultsHasARiser)
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 4), 2.5);
  room.ceiling = curved(barrel({0, 2}, 0, 0.5, 2.5));
  PlanDetail lower = detailOf(rectangle(3, 0, 6, 4), 0);
  lower.slab = curved(barrel({0, 2}, 0, 0.2, 2.5));
  lower.is_facet = true;
  room.details.push_back(lower);
  const Solid solid(room);
  expectSound(solid);
  EXPECT_NEAR(solid.report.riser_area, 4 * 0.3, 0.001);
}

} // namespace
