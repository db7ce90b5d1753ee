// SPDX-License-Identifier: BSD-3-Clause
#include "simulator/scan/scene_surfaces.h"
#include "simulator/scene/tilted_walls.h"
#include "simulator/truth/mesh_measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace pcl::sedr::sim::test {
namespace {

constexpr double degree = pi / 180.0;
constexpr double kHeight = 2.5;

Room
boxRoom()
{
  Room room;
  room.name = "room";
  room.outline = rectangleLoop({0, 0}, {6, 4});
  room.floor.height = 1.0;
  room.ceiling.height = 1.0 + kHeight;
  return room;
}

Mesh
truthOfRoom(const Room& room)
{
  Scene scene;
  scene.rooms.push_back(room);
  return truthMesh(scene);
}

TEST(TiltedWalls, oneIntoTheRoomTakesATriangleOfEverySection)
{
  Room room = boxRoom();
  tiltWalls(room, {{1, 12 * degree}});
  const Mesh mesh = truthOfRoom(room);
  EXPECT_TRUE(isClosedManifold(mesh));
  const double run = std::tan(12 * degree);
  EXPECT_NEAR(signedVolume(mesh), 4 * (6 * kHeight - run * kHeight * kHeight / 2),
              1e-9);
  EXPECT_NEAR(areaOf(mesh, Label::Ceiling), 4 * (6 - run * kHeight), 1e-9);
  EXPECT_NEAR(areaOf(mesh, Label::Floor), 24, 1e-9);
  EXPECT_EQ(areaOf(mesh, Label::Detail), 0.0);
}

TEST(TiltedWalls, besideEachOtherTheyMeetInACornerTiltedBothWays)
{
  for (const double second : {20.0, -25.0}) {
    Room room = boxRoom();
    tiltWalls(room, {{0, -10 * degree}, {1, second * degree}});
    const Mesh mesh = truthOfRoom(room);
    EXPECT_TRUE(isClosedManifold(mesh)) << second;
    // The sections are (6 - a z) (4 - b z).
    const double a = std::tan(second * degree);
    const double b = std::tan(-10 * degree);
    const double h = kHeight;
    EXPECT_NEAR(signedVolume(mesh),
                24 * h - (6 * b + 4 * a) * h * h / 2 + a * b * h * h * h / 3, 1e-9)
        << second;
    EXPECT_NEAR(areaOf(mesh, Label::Ceiling), (6 - a * h) * (4 - b * h), 1e-9);
  }
}

TEST(TiltedWalls, ofARoundRoomTheyAreACone)
{
  Room room = boxRoom();
  room.outline = circleLoop({0, 0}, 3);
  tiltWalls(room, {{0, 8 * degree}, {1, 8 * degree}});
  const double top = 3 - std::tan(8 * degree) * kHeight;
  const Mesh mesh = truthOfRoom(room);
  EXPECT_TRUE(isClosedManifold(mesh));
  EXPECT_NEAR(signedVolume(mesh), pi * kHeight / 3 * (9 + 3 * top + top * top), 0.01);
}

TEST(TiltedWalls, aRoofAboveCutsThemOff)
{
  Room room = boxRoom();
  room.ceiling = {1.0 + kHeight, {-0.2, 0}, {6, 0}}; // falls to wall 1
  tiltWalls(room, {{1, 15 * degree}});
  const Mesh mesh = truthOfRoom(room);
  EXPECT_TRUE(isClosedManifold(mesh));
  // The section has the corners (0, 0) (6, 0) (x, z) (0, top).
  const double run = std::tan(15 * degree);
  const double z = kHeight / (1 - 0.2 * run); // z = height + 0.2 run z
  const double x = 6 - run * z;
  const double top = kHeight + 0.2 * 6;
  EXPECT_NEAR(signedVolume(mesh), 4 * (6 * z + x * top) / 2, 1e-9);
}

TEST(TiltedWalls, openingsKeepTheirWalls)
{
  Room room = boxRoom();
  room.openings.push_back({2, 1, 2, 1.0, 3.0});
  tiltWalls(room, {{1, -12 * degree}});
  const Element wall = elementOf(room.outline, room.openings.front().wall);
  EXPECT_NEAR(wall.start.x, 6, 1e-12);
  EXPECT_NEAR(wall.end.x, 0, 1e-12);
  room = boxRoom();
  room.openings.push_back({1, 1, 2, 1.0, 3.0});
  EXPECT_THROW(tiltWalls(room, {{1, 5 * degree}}), std::invalid_argument);
}

} // namespace
} // namespace pcl::sedr::sim::test
