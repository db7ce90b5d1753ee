// SPDX-License-Identifier: BSD-3-Clause
#include "solid_checks.h"

#include <memory>
#include <random>
#include <utility>

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

constexpr double degree = M_PI / 180;
constexpr double height = 2.5;

PlanRoom
tilted(PlanRoom room, const std::vector<std::pair<std::size_t, double>>& tilts)
{
  for (const auto& [wall, tilt] : tilts)
    room.boundary.elements[wall].tilt = tilt;
  return room;
}

TEST(TiltedWallSolid, OneIntoTheRoomTakesATriangleOfEverySection)
{
  const Solid solid(
      tilted(roomOf(rectangle(0, 0, 6, 4), height, 3), {{1, 12 * degree}}));
  const double run = std::tan(12 * degree);
  expectPiece(solid, 4 * (6 * height - run * height * height / 2));
  EXPECT_TRUE(solid.hasVertex(6, 0, 0));
  EXPECT_TRUE(solid.hasVertex(6 - run * height, 4, height));
  EXPECT_NEAR(solid.areaOf("room_3_wall_2"), 4 * height / std::cos(12 * degree), 1e-5);
  EXPECT_NEAR(solid.areaOf("room_3_ceiling"), 4 * (6 - run * height), 1e-5);
}

TEST(TiltedWallSolid, AtAnObliqueCornerStayInTheirPlanes)
{
  // A triangle in plan: its sections are similar triangles.
  const PlanLoop loop = polygon({{0, 0}, {8, 0}, {2, 5}});
  const Solid solid(tilted(roomOf(loop, height),
                           {{0, 10 * degree}, {1, 10 * degree}, {2, 10 * degree}}));
  const double radius = 2 * loop.area() / loop.length(); // of the inscribed circle
  const double top = (radius - std::tan(10 * degree) * height) / radius;
  expectPiece(solid, loop.area() * height * (1 + top + top * top) / 3);
}

TEST(TiltedWallSolid, ARoundOneIsACone)
{
  const Solid solid(tilted(roomOf(circle({1, 2}, 3), height), {{0, -8 * degree}}));
  expectSound(solid);
  const double top = 3 + std::tan(8 * degree) * height;
  EXPECT_NEAR(solid.report.volume, M_PI * height / 3 * (9 + 3 * top + top * top), 0.03);
  for (const auto& v : solid.mesh.vertices)
    EXPECT_NEAR((v.head<2>() - Eigen::Vector2d(1, 2)).norm(), v.z() > 1 ? top : 3,
                1e-6);
}

TEST(TiltedWallSolid, AFloorThatTheyReachOverIsTriangulatedAnew)
{
  // An L whose notch almost vanishes below the wall that tilts outwards.
  const PlanLoop l = polygon({{0, 0}, {6, 0}, {6, 3}, {5.2, 3}, {5.2, 4}, {0, 4}});
  const double run = std::tan(15 * degree);
  const Solid solid(tilted(roomOf(l, height), {{1, 15 * degree}}));
  expectPiece(solid, (6 * 3 + 5.2) * height - 3 * run * height * height / 2);
}

TEST(TiltedWallSolid, BelowARoofEndWhereItIs)
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 4), height);
  const Eigen::Vector3d normal = Eigen::Vector3d(0.2, 0, 1).normalized();
  room.ceiling.plane << normal, -normal.dot(Eigen::Vector3d(6, 0, height));
  const Solid solid(tilted(room, {{1, 15 * degree}}));
  const double run = std::tan(15 * degree);
  const double z = height / (1 - 0.2 * run);
  expectPiece(solid, 4 * (6 * z + (6 - run * z) * (height + 0.2 * 6)) / 2);
}

TEST(TiltedWallSolid, StandVerticalWithAWarningWhereTheyWouldFoldAPlatform)
{
  PlanRoom room = roomOf(rectangle(0, 0, 6, 4), height);
  room.floor_details = {detailOf(rectangle(3, 0, 6, 1), 0.3)};
  const Solid solid(tilted(room, {{1, -10 * degree}}));
  expectSound(solid);
  if (solid.report.warnings.empty())
    EXPECT_GT(solid.report.volume, 24 * height - 3 * 0.3 + 0.1) << "it is tilted out";
  else
    EXPECT_NEAR(solid.report.volume, 24 * height - 3 * 0.3, 1e-6);
}

/** Returns a room with the faults of a bad fit: all parts cross each other. */
PlanRoom
randomRoom(std::mt19937& random)
{
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto loop = [&](double size, const Eigen::Vector2d& place) {
    // Often slightly off a round number, so that many positions nearly coincide.
    const auto step = [&](double v) {
      return between(0, 1) < 0.6 ? std::round(2 * v) / 2 + between(-0.003, 0.003) : v;
    };
    const double w = step(between(0.3, size));
    const double h = step(between(0.3, size)) + 0.02;
    PlanLoop l = random() % 4 == 0   ? circle({0, 0}, w / 2)
                 : random() % 4 == 0 ? roundedRectangle(w, h, std::min(w, h) / 2.5)
                                     : rectangle(0, 0, w, h);
    return sedr_test::placed(l, random() % 3 == 0 ? between(0, 360) : 0,
                             {step(place.x()), step(place.y())});
  };
  PlanRoom room = roomOf(loop(8, {0, 0}), between(2.2, 3));
  room.ceiling = slabAt(between(2.2, 3), between(-0.05, 0.05), 0);
  for (unsigned i = random() % 6; i > 0; --i) {
    room.details.push_back(detailOf(loop(4, {between(-1, 5), between(-1, 5)}), 0));
    room.details.back().slab = random() % 2 == 0
                                   ? slabAt(std::round(between(20, 30)) / 10)
                                   : slabAt(between(2, 3), between(-0.1, 0.1), 0.02);
    if (random() % 3 == 0)
      room.details.back().holes.push_back(
          reversed(loop(2, {between(0, 4), between(0, 4)})));
  }
  for (unsigned i = random() % 3; i > 0; --i) {
    const double height = random() % 2 == 0 ? 0.4 : between(-0.2, 2.4);
    room.floor_details.push_back(
        detailOf(loop(3, {between(-1, 5), between(-1, 5)}), height));
  }
  for (unsigned i = random() % 3; i > 0; --i)
    room.niches.push_back({loop(2, {between(-1, 7), between(-1, 7)}),
                           slabAt(std::round(between(0, 20)) / 10),
                           slabAt(between(1, 2.6))});
  for (unsigned i = random() % 4; i > 0; --i)
    room.columns.push_back(reversed(loop(1.2, {between(-1, 5), between(-1, 5)})));
  return room;
}

TEST(RoomSolidRandom, AnyPlanGivesASoundSolid)
{
  std::mt19937 random(7);
  for (int trial = 0; trial < 200; ++trial) {
    const Solid solid(randomRoom(random));
    if (solid.report.problem == "its plan encloses no room")
      continue;
    SCOPED_TRACE("trial " + std::to_string(trial));
    expectSound(solid);
  }
}

} // namespace
