// SPDX-License-Identifier: BSD-3-Clause
#include "solid_checks.h"

#include <cmath>
#include <utility>
#include <vector>

namespace {

using namespace pcl::sedr;
using namespace sedr_test;

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

} // namespace
