// SPDX-License-Identifier: BSD-3-Clause
#include "room_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

/** @file The truth of rooms with steps, niches and tilted slabs. */

namespace pcl::sedr::sim::test {
namespace {

TEST(TruthMesh, platformAndPitHaveRisersAndDivideTheWalls)
{
  Room room = makeBoxRoom(5.0, 4.0, 3.0);
  room.floor_details.push_back({rectangleLoop({0.0, 0.0}, {2.0, 4.0}), {0.2}});
  room.floor_details.push_back({rectangleLoop({3.0, 1.0}, {4.0, 2.0}), {-0.5}});
  const Mesh mesh = meshOf(room);
  expectClosed(mesh, 2);
  EXPECT_NEAR(signedVolume(mesh), 60.0 - 8.0 * 0.2 + 0.5, 1e-12);
  EXPECT_NEAR(areaOf(mesh, Label::Floor), 20.0 - 8.0 - 1.0, 1e-12);
  // Tops 8 and 1, risers 4 * 0.2 and 4 * 0.5.
  EXPECT_NEAR(areaOf(mesh, Label::Detail), 9.0 + 0.8 + 2.0, 1e-12);
  EXPECT_NEAR(areaOf(mesh, Label::Wall), 54.0 - (2.0 + 4.0 + 2.0) * 0.2, 1e-12);
}

TEST(TruthMesh, stepsMayLieOnEachOther)
{
  Room room = makeBoxRoom(5.0, 4.0, 3.0);
  for (int step = 1; step <= 3; ++step)
    room.floor_details.push_back(
        {rectangleLoop({2.0 + 0.3 * step, 0.0}, {5.0, 1.2}), {0.17 * step}});
  const Mesh mesh = meshOf(room);
  expectClosed(mesh, 2);
  EXPECT_NEAR(signedVolume(mesh), 60.0 - 1.2 * 0.17 * (2.7 + 2.4 + 2.1), 1e-12);
}

TEST(TruthMesh, outlinesOfFloorAndCeilingMayCross)
{
  Room room = makeBoxRoom(5.0, 4.0, 3.0);
  room.floor_details.push_back({rectangleLoop({1.0, 1.0}, {3.0, 3.0}), {0.3}});
  room.details.push_back({rectangleLoop({2.0, 2.0}, {4.0, 3.5}), {2.6}});
  const Mesh mesh = meshOf(room);
  expectClosed(mesh, 2);
  EXPECT_NEAR(signedVolume(mesh), 60.0 - 4.0 * 0.3 - 3.0 * 0.4, 1e-12);
  EXPECT_NEAR(areaOf(mesh, Label::Detail), 4.0 + 8.0 * 0.3 + 3.0 + 7.0 * 0.4, 1e-12);
}

TEST(TruthMesh, columnOnAPlatformBeginsThere)
{
  Room room = makeBoxRoom(5.0, 4.0, 3.0);
  room.floor_details.push_back({rectangleLoop({1.0, 1.0}, {3.0, 3.0}), {0.3}});
  room.columns.push_back(rectangleLoop({1.5, 1.5}, {2.0, 2.0}));
  const Mesh mesh = meshOf(room);
  expectClosed(mesh, 0);
  EXPECT_NEAR(areaOf(mesh, Label::Column), 2.0 * 2.7, 1e-12);
  EXPECT_NEAR(signedVolume(mesh), 60.0 - 0.25 * 3.0 - 3.75 * 0.3, 1e-12);
}

TEST(TruthMesh, nicheAddsItsVolumeAndFiveFaces)
{
  Room room = makeBoxRoom(5.0, 4.0, 3.0);
  room.niches.push_back({0, 1.0, 2.5, 0.8, 2.0, 0.4});
  const Mesh mesh = meshOf(room);
  expectClosed(mesh, 2);
  EXPECT_NEAR(signedVolume(mesh), 60.0 + 1.5 * 1.2 * 0.4, 1e-12);
  EXPECT_NEAR(areaOf(mesh, Label::Wall), 54.0 - 1.5 * 1.2, 1e-12);
  EXPECT_NEAR(areaOf(mesh, Label::Detail), 1.5 * 1.2 + 2.0 * 0.4 * (1.5 + 1.2), 1e-12);
}

TEST(TruthMesh, nichesMayReachFloorCeilingAndCorners)
{
  const double full[4] = {0.0, 4.0, 0.0, 3.0};   // the whole wall: the room is longer
  const double alcove[4] = {1.0, 2.0, 0.0, 2.2}; // from the floor
  const double high[4] = {0.0, 1.0, 2.0, 3.0};   // in the upper corner
  for (const auto& extent : {full, alcove, high}) {
    Room room = makeBoxRoom(5.0, 4.0, 3.0);
    room.niches.push_back({1, extent[0], extent[1], extent[2], extent[3], 0.5});
    const Mesh mesh = meshOf(room);
    expectClosed(mesh, 2);
    const double face = (extent[1] - extent[0]) * (extent[3] - extent[2]);
    EXPECT_NEAR(signedVolume(mesh), 60.0 + face * 0.5, 1e-12);
    EXPECT_NEAR(areaOf(mesh, Label::Wall), 54.0 - face, 1e-12);
  }
}

TEST(TruthMesh, nichesMayStandAboveEachOtherAndBesideASoffit)
{
  Room room = makeBoxRoom(5.0, 4.0, 3.0);
  room.details.push_back({rectangleLoop({1.5, 0.0}, {2.0, 1.0}), {2.5}});
  room.niches.push_back({0, 1.0, 2.5, 0.3, 1.0, 0.2});
  room.niches.push_back({0, 1.2, 2.2, 1.2, 2.1, 0.3});
  const Mesh mesh = meshOf(room);
  expectClosed(mesh, 2);
  EXPECT_NEAR(signedVolume(mesh), 60.0 - 0.25 + 1.05 * 0.2 + 0.9 * 0.3, 1e-12);
}

TEST(TruthMesh, nicheInACurvedWallConvergesToTheTrueVolume)
{
  Room room = makeBoxRoom(4.0, 4.0, 3.0);
  for (const double bulge : {0.4, -0.2}) {
    room.outline[1].bulge = bulge;
    room.niches = {{1, 1.0, 3.0, 0.5, 1.5, 0.3}};
    const Mesh mesh = meshOf(room, 1e-6);
    expectClosed(mesh, 2);
    // A strip of 0.3 m along an arc: its middle line is 0.15 m further out.
    const double radius = arcOf(elementOf(room.outline, 1)).radius;
    const double grow = bulge > 0.0 ? 1.0 : -1.0;
    const double strip = 2.0 * 0.3 * (1.0 + grow * 0.15 / radius);
    EXPECT_NEAR(signedVolume(mesh), areaOf(room.outline) * 3.0 + strip, 1e-4) << bulge;
  }
}

TEST(TruthMesh, tiltedCeilingEndsTheWalls)
{
  // 2.5 m high at x = 0, rises by 0.1 m per metre: 2.75 m on average, 3 m at x = 5.
  Room room = makeBoxRoom(5.0, 4.0, 0.0);
  room.ceiling = {2.5, {0.1, 0.0}};
  const Mesh mesh = meshOf(room);
  expectClosed(mesh, 2);
  EXPECT_EQ(mesh.faces.size(), 12U);
  EXPECT_NEAR(signedVolume(mesh), 20.0 * 2.75, 1e-12);
  EXPECT_NEAR(areaOf(mesh, Label::Wall), 2.0 * 5.0 * 2.75 + 4.0 * (2.5 + 3.0), 1e-12);
  EXPECT_NEAR(areaOf(mesh, Label::Ceiling), 20.0 * std::hypot(1.0, 0.1), 1e-12);
}

TEST(TruthMesh, detailsAndColumnsUnderATiltedCeiling)
{
  Room room = makeBoxRoom(5.0, 4.0, 0.0);
  room.ceiling = {2.5, {0.1, 0.05}, {1.0, 1.0}};
  Slab beam = room.ceiling;
  beam.height -= 0.3;
  room.details.push_back({rectangleLoop({2.0, 0.0}, {2.5, 4.0}), beam});  // parallel
  room.details.push_back({rectangleLoop({3.0, 1.0}, {4.0, 2.0}), {2.4}}); // level
  room.columns.push_back(rectangleLoop({0.5, 1.0}, {1.0, 1.5}));
  const Mesh mesh = meshOf(room);
  expectClosed(mesh, 0);
  // Mean heights are those at the middles of the rectangles.
  const auto height = [&](double x, double y) {
    return heightAt(room.ceiling, {x, y});
  };
  EXPECT_NEAR(signedVolume(mesh),
              20.0 * height(2.5, 2.0) - 2.0 * 0.3 - (height(3.5, 1.5) - 2.4) -
                  0.25 * height(0.75, 1.25),
              1e-9);
  EXPECT_NEAR(areaOf(mesh, Label::Column), 2.0 * height(0.75, 1.25), 1e-9);
}

TEST(TruthMesh, rampRisesFromTheFloor)
{
  // From z = 0 at x = 1 to z = 0.4 at x = 3, where a platform follows.
  Room room = makeBoxRoom(5.0, 4.0, 3.0);
  room.floor_details.push_back(
      {rectangleLoop({1.0, 1.0}, {3.0, 2.0}), {0.0, {0.2, 0.0}, {1.0, 0.0}}});
  room.floor_details.push_back({rectangleLoop({3.0, 1.0}, {4.0, 2.0}), {0.4}});
  const Mesh mesh = meshOf(room);
  expectClosed(mesh, 2);
  EXPECT_NEAR(signedVolume(mesh), 60.0 - 0.5 * 2.0 * 0.4 - 0.4, 1e-9);
  EXPECT_NEAR(areaOf(mesh, Label::Detail),
              std::hypot(2.0, 0.4) + 2.0 * 0.4 + 1.0 + 3.0 * 0.4, 1e-9);
}

TEST(TruthMesh, tiltedCeilingOverACurvedWallConverges)
{
  Room room = makeBoxRoom(4.0, 4.0, 0.0);
  room.outline = circleLoop({2.0, 1.0}, 1.5);
  room.ceiling = {2.5, {0.2, -0.1}};
  const Mesh mesh = meshOf(room, 1e-6);
  expectClosed(mesh, 2);
  const double middle = heightAt(room.ceiling, {2.0, 1.0});
  EXPECT_NEAR(signedVolume(mesh), 2.25 * pi * middle, 1e-3);
  EXPECT_NEAR(areaOf(mesh, Label::Wall), 3.0 * pi * middle, 1e-3);
}

TEST(TruthMesh, rejectsCeilingsThatCross)
{
  Room room = makeBoxRoom(5.0, 4.0, 3.0);
  room.details.push_back(
      {rectangleLoop({1.0, 1.0}, {3.0, 3.0}), {3.0, {0.1, 0.0}, {2.0, 0.0}}});
  EXPECT_THROW(meshOf(room), std::invalid_argument);
}

TEST(TruthMesh, rejectsNichesThatLieOnNoWall)
{
  Room room = makeBoxRoom(5.0, 4.0, 3.0);
  room.niches = {{7, 1.0, 2.0, 0.5, 1.5, 0.3}};
  EXPECT_THROW(meshOf(room), std::invalid_argument);
  room.niches = {{0, 4.0, 6.0, 0.5, 1.5, 0.3}};
  EXPECT_THROW(meshOf(room), std::invalid_argument);
}

} // namespace
} // namespace pcl::sedr::sim::test
