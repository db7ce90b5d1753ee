// SPDX-License-Identifier: BSD-3-Clause
// The mesh of a scene against closed forms: volumes and areas of its parts.
#include "sample_scenes.h"
#include "simulator/mesh/scene_mesh.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

namespace pcl::sedr::sim::test {
namespace {

double
areaOf(const TriangleMesh& mesh, Label label)
{
  double area = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (mesh.labels[t] == static_cast<std::uint32_t>(label))
      area += mesh.scaledNormal(t).norm() / 2;
  return area;
}

double
areaOfObjects(const SceneMesh& scene)
{
  double area = 0;
  for (std::size_t t = 0; t < scene.mesh.triangles.size(); ++t)
    if (scene.surfaces[t] == Surface::Object)
      area += scene.mesh.scaledNormal(t).norm() / 2;
  return area;
}

/** @brief A room, and what its truth measures. */
struct Expected {
  std::string name;
  std::string changes; ///< of boxFile()
  double volume;
  double ceiling;
  double floor;
  double wall;
  double detail;
  double column = 0;
  double tolerance = 1e-8; ///< relative to the size of the room
};

std::ostream&
operator<<(std::ostream& stream, const Expected& e)
{
  return stream << e.name;
}

class RoomMesh : public testing::TestWithParam<Expected> {};

TEST_P(RoomMesh, isClosedAndHasTheVolumeAndAreasOfItsParts)
{
  const Expected& e = GetParam();
  const TriangleMesh mesh = truthOf(meshOf(read(with(boxFile(), e.changes))));
  EXPECT_TRUE(checkTopology(mesh).isClosedManifold());
  EXPECT_NEAR(mesh.signedVolume(), e.volume, 60 * e.tolerance);
  EXPECT_NEAR(areaOf(mesh, Label::Ceiling), e.ceiling, 60 * e.tolerance);
  EXPECT_NEAR(areaOf(mesh, Label::Floor), e.floor, 60 * e.tolerance);
  EXPECT_NEAR(areaOf(mesh, Label::Wall), e.wall, 60 * e.tolerance);
  EXPECT_NEAR(areaOf(mesh, Label::Detail), e.detail, 60 * e.tolerance);
  EXPECT_NEAR(areaOf(mesh, Label::Column), e.column, 60 * e.tolerance);
}

const double kTilt10 = std::tan(10 * pi / 180);

const std::vector<Expected>&
rooms()
{
  const double r = 2.5; // of a barrel vault over the width of 5 m
  static const std::vector<Expected> rooms{
      {"box", "{}", 60, 20, 20, 54, 0},
      {"soffit_on_two_walls_and_recess", R"({"/rooms/0/ceiling_details": [
          {"loop": [[0, 0], [1, 0], [1, 3], [5, 3], [5, 4], [0, 4]], "drop": 0.5},
          {"loop": {"rectangle": [[2, 1], [3, 2]]}, "drop": -0.25}]})",
       60 - 8 * 0.5 + 0.25, 20 - 8 - 1, 20, 7 * 3 + 11 * 2.5, 9 + 3.5 + 1},
      {"details_that_share_edges_and_lie_in_one_another",
       R"({"/rooms/0/ceiling_details": [
          {"loop": {"rectangle": [[1, 1], [3, 3]]}, "height": 2.8},
          {"loop": {"rectangle": [[3, 1], [4, 2]]}, "height": 3.2},
          {"loop": {"rectangle": [[1.5, 1.5], [2.5, 2.5]]}, "height": 3.0}]})",
       60 - 3 * 0.2 + 0.2, 15, 20, 54, 5 + 0.2 * 7 + 0.4 + 0.2 * 3 + 0.2 * 4},
      {"details_that_cross", R"({"/rooms/0/ceiling_details": [
          {"loop": {"rectangle": [[1, 1], [3, 3]]}, "height": 2.5},
          {"loop": {"rectangle": [[2, 2], [4, 3]]}, "height": 2.7}]})",
       60 - 3 * 0.5 - 2 * 0.3, 15, 20, 54, 5 + 0.5 * 6 + 0.2 * 2 + 0.3 * 4},
      {"platform_and_pit", R"({"/rooms/0/floor_details": [
          {"loop": {"rectangle": [[0, 0], [2, 4]]}, "rise": 0.2},
          {"loop": {"rectangle": [[3, 1], [4, 2]]}, "rise": -0.5}]})",
       60 - 8 * 0.2 + 0.5, 20, 11, 54 - 8 * 0.2, 9 + 0.8 + 2},
      {"ramp", R"({"/rooms/0/floor_details": [
          {"loop": {"rectangle": [[1, 1], [3, 2]]},
           "height": {"height": 0, "slope": 11.309932474020213, "towards": 0, "at": [1, 0]}},
          {"loop": {"rectangle": [[3, 1], [4, 2]]}, "rise": 0.4}]})",
       60 - 0.4 - 0.4, 20, 17, 54, std::hypot(2, 0.4) + 2 * 0.4 + 1 + 3 * 0.4},
      {"square_columns", R"({"/rooms/0/columns": [
          {"rectangle": [[1, 1], [1.6, 1.6]]}, {"rectangle": [[3, 2], [3.6, 2.6]]}]})",
       60 - 3 * 0.72, 20 - 0.72, 20 - 0.72, 54, 0, 2 * 4 * 0.6 * 3},
      {"round_column", R"({"/rooms/0/columns": [{"circle": [3, 2], "radius": 0.4}]})",
       60 - 3 * pi * 0.16, 20 - pi * 0.16, 20 - pi * 0.16, 54, 0, 0.8 * pi * 3, 1e-4},
      {"half_round_wall", R"({"/rooms/0/outline/1": {"at": [5, 0], "bulge": 1}})",
       60 + 3 * 2 * pi, 20 + 2 * pi, 20 + 2 * pi, 14 * 3 + 6 * pi, 0, 0, 1e-4},
      {"niche", R"({"/rooms/0/niches": [
          {"wall": 0, "from": 1, "to": 2.5, "sill": 0.8, "head": 2, "depth": 0.4}]})",
       60 + 1.8 * 0.4, 20, 20, 54 - 1.8, 1.8 + 0.8 * 2.7},
      {"niches_from_the_floor_and_above_each_other", R"({"/rooms/0/niches": [
          {"wall": 1, "from": 0, "to": 4, "sill": 0, "head": 3, "depth": 0.5},
          {"wall": 0, "from": 1, "to": 2.5, "sill": 0.3, "head": 1, "depth": 0.2},
          {"wall": 0, "from": 1.2, "to": 2.2, "sill": 1.2, "head": 2.1, "depth": 0.3}]})",
       60 + 6 + 1.05 * 0.2 + 0.9 * 0.3, 20, 20, 54 - 12 - 1.05 - 0.9,
       12 + 14 * 0.5 + 1.05 + 4.4 * 0.2 + 0.9 + 3.8 * 0.3},
      {"sloped_ceiling", R"({"/rooms/0/ceiling":
          {"height": 2.5, "slope": 5.710593137499642, "towards": 0}})",
       20 * 2.75, 20 * std::hypot(1, 0.1), 20, 2 * 5 * 2.75 + 4 * 5.5, 0},
      {"gable", R"({"/rooms/0/ceiling": {"height": 2, "slope": 45, "towards": 90},
          "/rooms/0/facets": [{"loop": {"rectangle": [[0, 2], [5, 4]]},
             "height": {"height": 2, "slope": 45, "towards": 270, "at": [0, 4]}}]})",
       20 * 3, 20 * std::sqrt(2), 20, 2 * 5 * 2 + 2 * 4 * 3, 0},
      {"barrel_vault", R"({"/rooms/0/facets": [
          {"loop": {"rectangle": [[0, 0], [5, 4]]},
           "vault": {"at": [2.5, 0], "direction": 90, "height": 1, "radius": 2.5}}]})",
       20 + 4 * pi * r * r / 2, 4 * pi * r, 20, 2 * 4 + 2 * (5 + pi * r * r / 2), 0, 0,
       3e-3},
      {"cap_of_a_sphere", R"({"/rooms/0/facets": [
          {"dome": {"at": [2.5, 2], "height": 0, "radius": 3.25, "rim": 1.25}}]})",
       60 + pi * 0.0625 * (3.25 - 0.25 / 3), 20 - pi * 1.5625 + 2 * pi * 3.25 * 0.25,
       20, 54, 0, 0, 1e-4},
      {"ribs_that_end_at_a_beam", R"({"/rooms/0/ribs": [
          {"direction": 0, "spacing": 1, "width": 0.2, "depth": 0.3},
          {"direction": 90, "spacing": 2.5, "first": 2.5, "width": 0.4, "depth": 0.5}]})",
       60 - 0.4 * 4 * 0.5 - 4 * 0.2 * 4.6 * 0.3, 20 - 1.6 - 3.68, 20,
       54 - 0.8 * 0.5 - 1.6 * 0.3,
       1.6 + 3.68 + 8 * 4.6 * 0.3 + 2 * 4 * 0.5 - 8 * 0.2 * 0.3},
      {"walls_tilted_in_and_out", R"({"/rooms/0/tilts": [
          {"wall": 1, "tilt": 10}, {"wall": 0, "tilt": -10}]})",
       20 * 3 + (5 - 4) * kTilt10 * 4.5 - kTilt10 * kTilt10 * 9,
       (5 - 3 * kTilt10) * (4 + 3 * kTilt10), 20,
       // each tilted wall: mean length times the height along its slope
       3 * (4 + 1.5 * kTilt10) + 3 * (5 - 1.5 * kTilt10) +
           3 * std::hypot(1, kTilt10) * (9 + 3 * kTilt10 / 2 - 3 * kTilt10 / 2),
       0},
      {"cone", R"({"/rooms/0/outline": {"circle": [2, 1.5], "radius": 2},
          "/rooms/0/tilts": [{"wall": 0, "tilt": 10}, {"wall": 1, "tilt": 10}]})",
       pi * (4 + 2 * (2 - 3 * kTilt10) + std::pow(2 - 3 * kTilt10, 2)),
       pi * std::pow(2 - 3 * kTilt10, 2), 4 * pi,
       pi * (4 - 3 * kTilt10) * 3 * std::hypot(1, kTilt10), 0, 0, 2e-4}};
  return rooms;
}

INSTANTIATE_TEST_SUITE_P(All,
                         RoomMesh,
                         testing::ValuesIn(rooms()),
                         [](const auto& room) { return room.param.name; });

TEST(SceneMesh, ofEveryBuiltInSceneIsOneClosedComponentARoom)
{
  for (const Scene& scene : allScenes()) {
    const TriangleMesh mesh = truthOf(meshOf(scene));
    EXPECT_TRUE(checkTopology(mesh).isClosedManifold()) << scene.name;
    std::set<std::uint32_t> numbers(mesh.rooms.begin(), mesh.rooms.end());
    EXPECT_EQ(numbers.size(), scene.rooms.size()) << scene.name;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      ASSERT_GT(mesh.scaledNormal(t).norm(), 0) << scene.name;
  }
}

TEST(SceneMesh, closesOpeningsWithFacesOfTheirNumberOnBothSides)
{
  const json file = with(boxFile(), R"({
      "/rooms/1": {"name": "other", "outline": {"rectangle": [[5.1, 0], [8, 4]]},
                   "floor": 0, "ceiling": 3,
                   "openings": [{"wall": 1, "from": 1, "to": 3, "sill": 1, "head": 2,
                                 "depth": 0.3, "glazing": {}}]},
      "/rooms/0/openings": [{"wall": 1, "from": 1, "to": 2, "head": 2, "depth": 0.1,
                             "leads_to": "other"}]})");
  const SceneMesh scene = meshOf(read(file));
  std::map<std::pair<Surface, std::uint32_t>, double> areas;
  for (std::size_t t = 0; t < scene.mesh.triangles.size(); ++t)
    areas[{scene.surfaces[t], scene.mesh.elements[t]}] +=
        scene.mesh.scaledNormal(t).norm() / 2;
  EXPECT_NEAR((areas[{Surface::Gap, 1}]), 2 * 2, 1e-9); // one in each room
  EXPECT_NEAR((areas[{Surface::Gap, 2}]), 2, 1e-9);
  EXPECT_NEAR((areas[{Surface::Pane, 2}]), 2, 1e-9);
  EXPECT_NEAR((areas[{Surface::Object, 1}]), 2 * 2 * 0.1, 1e-9); // jambs
  EXPECT_TRUE(checkTopology(truthOf(scene)).isClosedManifold());
}

TEST(SceneMesh, leavesWindowsAboveNichesOpen)
{
  const SceneMesh scene = meshOf(read(with(boxFile(), R"({
      "/rooms/0/niches": [{"wall": 0, "from": 1, "to": 3, "sill": 0, "head": 0.9, "depth": 0.2}],
      "/rooms/0/openings": [
        {"wall": 0, "from": 1, "to": 3, "sill": 0.9, "head": 2, "depth": 0.3}]})")));
  EXPECT_NEAR(areaOfObjects(scene), 2 * (1.1 + 2) * 0.3, 1e-9); // nothing across it
  EXPECT_TRUE(checkTopology(truthOf(scene)).isClosedManifold());
}

TEST(SceneMesh, hasShaftsFromCeilingsOfTwoHeights)
{
  const SceneMesh scene = meshOf(read(with(twoStoreyFile(), R"({
      "/rooms/0/furniture": [], "/rooms/0/openings": [], "/rooms/1/openings": [],
      "/rooms/0/ceiling_details": [
        {"loop": {"rectangle": [[0, 0], [2, 5]]}, "drop": 0.3}]})")));
  EXPECT_NEAR(areaOfObjects(scene), 0.6 * (1.2 + 2 * 1) + 0.3 * (1.2 + 2 * 2.5), 1e-9);
  EXPECT_TRUE(checkTopology(truthOf(scene)).isClosedManifold());
}

} // namespace
} // namespace pcl::sedr::sim::test
