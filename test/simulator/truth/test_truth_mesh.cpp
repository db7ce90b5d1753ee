// SPDX-License-Identifier: BSD-3-Clause
#include "room_mesh.h"
#include "simulator/scene/scenes.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace pcl::sedr::sim::test {
namespace {

TEST(TruthMesh, boxRoomHasTwelveTriangles)
{
  const Mesh mesh = meshOf(makeBoxRoom(5.0, 4.0, 3.0));
  expectClosed(mesh, 2);
  EXPECT_EQ(mesh.faces.size(), 12U);
  EXPECT_NEAR(signedVolume(mesh), 60.0, 1e-12);
  EXPECT_NEAR(areaOf(mesh, Label::Floor), 20.0, 1e-12);
  EXPECT_NEAR(areaOf(mesh, Label::Ceiling), 20.0, 1e-12);
  EXPECT_NEAR(areaOf(mesh, Label::Wall), 54.0, 1e-12);
}

TEST(TruthMesh, soffitOnTwoWallsAndRecessAreConforming)
{
  Room room = makeBoxRoom(5.0, 4.0, 3.0);
  const Loop soffit{{{0, 0}}, {{1, 0}}, {{1, 3}}, {{5, 3}}, {{5, 4}}, {{0, 4}}};
  room.details.push_back({soffit, {2.5}});
  room.details.push_back({rectangleLoop({2.0, 1.0}, {3.0, 2.0}), {3.25}});
  const Mesh mesh = meshOf(room);
  expectClosed(mesh, 2);
  EXPECT_NEAR(signedVolume(mesh), 60.0 - 8.0 * 0.5 + 0.25, 1e-12);
  EXPECT_NEAR(areaOf(mesh, Label::Ceiling), 20.0 - 8.0 - 1.0, 1e-12);
  // Undersides 8 and 1, risers (3 + 4) * 0.5 and 4 * 0.25.
  EXPECT_NEAR(areaOf(mesh, Label::Detail), 9.0 + 3.5 + 1.0, 1e-12);
  // 9 m of the outline are below the soffit, another 2 m are its end walls.
  EXPECT_NEAR(areaOf(mesh, Label::Wall), (3.0 + 4.0) * 3.0 + 11.0 * 2.5, 1e-12);
}

TEST(TruthMesh, detailsMayShareEdgesAndLieInOneAnother)
{
  Room room = makeBoxRoom(6.0, 4.0, 3.0);
  room.details.push_back({rectangleLoop({1, 1}, {3, 3}), {2.8}});
  room.details.push_back({rectangleLoop({3, 1}, {5, 2}), {3.2}}); // shares half an edge
  room.details.push_back(
      {rectangleLoop({1.5, 1.5}, {2.5, 2.5}), {3.0}}); // in the first
  const Mesh mesh = meshOf(room);
  expectClosed(mesh, 2);
  EXPECT_NEAR(signedVolume(mesh), 72.0 - 3.0 * 0.2 + 2.0 * 0.2, 1e-12);
  const double risers = 0.2 * 7.0 + 0.4 * 1.0 + 0.2 * 5.0 + 0.2 * 4.0;
  EXPECT_NEAR(areaOf(mesh, Label::Detail), 4.0 + 2.0 + risers, 1e-12);
}

TEST(TruthMesh, recessAtAWallContinuesTheWall)
{
  Room room = makeBoxRoom(5.0, 4.0, 3.0);
  room.details.push_back({rectangleLoop({2.0, 0.0}, {3.0, 1.0}), {3.5}});
  const Mesh mesh = meshOf(room);
  expectClosed(mesh, 2);
  EXPECT_NEAR(areaOf(mesh, Label::Wall), 54.0 + 0.5, 1e-12);
  EXPECT_NEAR(areaOf(mesh, Label::Detail), 1.0 + 3.0 * 0.5, 1e-12);
}

TEST(TruthMesh, eachColumnIsAHandle)
{
  Room room = makeBoxRoom(8.0, 6.0, 3.0);
  room.columns.push_back(rectangleLoop({2.0, 2.0}, {2.6, 2.6}));
  room.columns.push_back(rectangleLoop({5.0, 3.0}, {5.6, 3.6}));
  const Mesh mesh = meshOf(room);
  expectClosed(mesh, 2 - 2 * 2);
  EXPECT_NEAR(signedVolume(mesh), 3.0 * (48.0 - 2.0 * 0.36), 1e-12);
  EXPECT_NEAR(areaOf(mesh, Label::Column), 2.0 * 4.0 * 0.6 * 3.0, 1e-12);
  EXPECT_NEAR(areaOf(mesh, Label::Floor), 48.0 - 2.0 * 0.36, 1e-12);
}

/** @brief Returns the area of a regular polygon inscribed in a circle. */
double
inscribedArea(double radius, int corners)
{
  return 0.5 * corners * radius * radius * std::sin(2.0 * pi / corners);
}

TEST(TruthMesh, roundColumnIsARegularPrismWithinTheChordTolerance)
{
  Room room = makeBoxRoom(4.0, 4.0, 3.0);
  room.columns.push_back(circleLoop({2.0, 2.0}, 0.35));
  const Mesh mesh = meshOf(room);
  expectClosed(mesh, 0);
  // Half a circle needs pi / (2 acos (1 - 0.0005 / 0.35)) = 29.4 chords, so 30.
  EXPECT_NEAR(signedVolume(mesh), 3.0 * (16.0 - inscribedArea(0.35, 60)), 1e-12);
  const double chord = 0.7 * std::sin(pi / 60.0);
  EXPECT_NEAR(areaOf(mesh, Label::Column), 60.0 * chord * 3.0, 1e-12);
}

TEST(TruthMesh, curvedWallConvergesToTheTrueArea)
{
  Room room = makeBoxRoom(4.0, 4.0, 3.0);
  room.outline[1].bulge = 0.4;
  // A detail with an arc that coincides with a part of the curved wall.
  const Element wall = elementOf(room.outline, 1);
  const Element part = pieceOf(wall, 1.0, 3.0);
  room.details.push_back({{{part.start, part.bulge}, {part.end}, {{3.0, 2.0}}}, {2.6}});
  const Mesh mesh = meshOf(room, 1e-6);
  expectClosed(mesh, 2);
  const double soffit = areaOf(room.details.front().loop);
  EXPECT_NEAR(signedVolume(mesh), areaOf(room.outline) * 3.0 - soffit * 0.4, 1e-4);
  EXPECT_NEAR(areaOf(mesh, Label::Wall),
              perimeterOf(room.outline) * 3.0 - lengthOf(part) * 0.4, 1e-4);
}

TEST(TruthMesh, rejectsRegionsThatTouchInAPoint)
{
  Room room = makeBoxRoom(5.0, 4.0, 3.0);
  room.details.push_back({rectangleLoop({1, 1}, {2, 2}), {2.5}});
  room.details.push_back({rectangleLoop({2, 2}, {3, 3}), {2.5}});
  EXPECT_THROW(meshOf(room), std::invalid_argument);
}

TEST(TruthMesh, rejectsOutlinesThatCross)
{
  Room room = makeBoxRoom(5.0, 4.0, 3.0);
  room.details.push_back({rectangleLoop({1, 1}, {3, 3}), {2.5}});
  room.details.push_back({rectangleLoop({2, 2}, {4, 3.5}), {2.7}});
  EXPECT_THROW(meshOf(room), std::invalid_argument);
}

TEST(TruthMesh, scenesAreClosedWithOneComponentARoom)
{
  for (const Scene& scene : allScenes()) {
    const Mesh mesh = truthMesh(scene);
    EXPECT_TRUE(isClosedManifold(mesh)) << scene.name;
    EXPECT_EQ(componentCount(mesh), scene.rooms.size()) << scene.name;
    for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
      const auto columns = static_cast<long>(scene.rooms[i].columns.size());
      EXPECT_EQ(eulerCharacteristic(mesh, i + 1), 2 - 2 * columns) << scene.name;
    }
  }
}

TEST(TruthMesh, studyHasTheVolumeOfItsParts)
{
  const Mesh mesh = truthMesh(sceneNamed("bls_room"));
  const double soffit = 0.6 * 4.8 + 0.6 * 5.6;
  const double volume = 6.2 * 4.8 * 2.8 - soffit * 0.35 + 1.6 * 1.2 * 0.15;
  EXPECT_NEAR(signedVolume(mesh), volume, 1e-9);
  EXPECT_NEAR(areaOf(mesh, Label::Floor), 6.2 * 4.8, 1e-9);
}

TEST(TruthMesh, flatHasTheVolumesOfItsRooms)
{
  const Mesh mesh = truthMesh(sceneNamed("syn_flat"));
  const double rooms[] = {5.7 * 3.7, 5.7 * 3.7, 1.5 * 9.0 + 5.8 * 1.4,
                          7.3 * 4.9 - 0.5 * 1.2 * 1.2};
  for (std::uint32_t i = 0; i < 4; ++i)
    EXPECT_NEAR(signedVolume(mesh, i + 1), rooms[i] * 2.5, 1e-9) << i;
}

TEST(TruthMesh, hallConvergesToTheTrueVolume)
{
  const Scene scene = sceneNamed("hls_hall");
  const double sector = 64.0 * std::asin(5.5 / 8.0);
  const double floor = 14.0 * 11.0 + sector - 5.5 * std::sqrt(64.0 - 30.25) -
                       3.0 * pi * 0.35 * 0.35 - 2.0 * 0.36;
  EXPECT_NEAR(signedVolume(truthMesh(scene, 1e-6)), floor * 3.6, 1e-3);
  EXPECT_NEAR(signedVolume(truthMesh(scene)), floor * 3.6, 0.03);
}

} // namespace
} // namespace pcl::sedr::sim::test
