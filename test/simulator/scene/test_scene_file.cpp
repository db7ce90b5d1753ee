// SPDX-License-Identifier: BSD-3-Clause
#include "scene_text.h"
#include "simulator/scan/walk.h"
#include "simulator/scene/scenes.h"
#include "simulator/temporary_folder.h"
#include "simulator/truth/truth_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace pcl::sedr::sim::test {
namespace {

void
expectNear(Vec2 actual, Vec2 expected)
{
  EXPECT_NEAR(actual.x, expected.x, 1e-12);
  EXPECT_NEAR(actual.y, expected.y, 1e-12);
}

void
expectNear(Vec3 actual, Vec3 expected)
{
  expectNear(plan(actual), plan(expected));
  EXPECT_NEAR(actual.z, expected.z, 1e-12);
}

Loop
readOutline(const std::string& text)
{
  json file = minimalFile();
  file["rooms"][0]["outline"] = json::parse(text);
  return read(file).rooms.at(0).outline;
}

TEST(SceneFile, minimalSceneIsWhatItSays)
{
  const Scene scene = read(minimalFile());
  EXPECT_EQ(scene.name, "minimal");
  EXPECT_EQ(scene.summary, "a box");
  ASSERT_EQ(scene.rooms.size(), 1U);
  const Room& room = scene.rooms.front();
  EXPECT_EQ(room.name, "box");
  ASSERT_EQ(room.outline.size(), 4U);
  expectNear(room.outline[2].position, {5.0, 4.0});
  EXPECT_EQ(room.outline[2].bulge, 0.0);
  EXPECT_EQ(room.floor.height, 0.0);
  EXPECT_EQ(room.ceiling.height, 3.0);
  EXPECT_EQ(length(room.ceiling.gradient), 0.0);
  EXPECT_TRUE(room.details.empty() && room.floor_details.empty());
  EXPECT_TRUE(room.columns.empty() && room.openings.empty() && room.niches.empty());
  EXPECT_TRUE(scene.furniture.empty() && scene.outside.empty());
  EXPECT_EQ(scene.placement.yaw, 0.0);
  ASSERT_EQ(scene.scanners.size(), 1U);
  const Scanner& scanner = scene.scanners.front();
  ASSERT_EQ(scanner.stations.size(), 1U);
  expectNear(scanner.stations[0], {2.0, 2.0, 1.5});
  EXPECT_EQ(scanner.rays_per_station, 100U);
  EXPECT_EQ(scanner.noise, 0.005);
  // Values that are not given are those of Scanner.
  EXPECT_EQ(scanner.min_elevation, Scanner{}.min_elevation);
  EXPECT_EQ(scanner.jitter, Scanner{}.jitter);
  EXPECT_EQ(scanner.max_range, Scanner{}.max_range);
}

TEST(SceneFile, outlinesAreCornersArcsRectanglesAndCircles)
{
  const Loop rectangle = readOutline(R"({"rectangle": [[0, 0], [5, 4]]})");
  ASSERT_EQ(rectangle.size(), 4U);
  EXPECT_NEAR(areaOf(rectangle), 20.0, 1e-12);
  const Loop circle = readOutline(R"({"circle": [2, 2], "radius": 1.5})");
  EXPECT_NEAR(areaOf(circle), 2.25 * pi, 1e-12);

  const Loop outwards =
      readOutline(R"([[0, 0], {"at": [5, 0], "radius": 2.5}, [5, 4], [0, 4]])");
  EXPECT_NEAR(arcOf(elementOf(outwards, 1)).radius, 2.5, 1e-12);
  EXPECT_TRUE(contains(outwards, {5.5, 2.0}));
  const Loop inwards =
      readOutline(R"([[0, 0], {"at": [5, 0], "radius": -2.5}, [5, 4], [0, 4]])");
  EXPECT_FALSE(contains(inwards, {4.5, 2.0}));
  const Loop half =
      readOutline(R"([[0, 0], {"at": [5, 0], "bulge": 1}, [5, 4], [0, 4]])");
  EXPECT_NEAR(areaOf(half), 20.0 + 2.0 * pi, 1e-12);
}

TEST(SceneFile, slabsAreHeightsOrPlanes)
{
  const Scene scene =
      readWith("/rooms/0/ceiling", {{"height", 2.5}, {"slope", 45}, {"towards", 90}});
  const Slab& ceiling = scene.rooms[0].ceiling;
  EXPECT_NEAR(heightAt(ceiling, {0.0, 0.0}), 2.5, 1e-12); // at the first corner
  EXPECT_NEAR(heightAt(ceiling, {3.0, 0.0}), 2.5, 1e-12);
  EXPECT_NEAR(heightAt(ceiling, {3.0, 1.5}), 4.0, 1e-12);
  const Scene other =
      readWith("/rooms/0/floor",
               {{"height", 0.3}, {"slope", 2}, {"towards", 0}, {"at", {2.0, 1.0}}});
  EXPECT_NEAR(heightAt(other.rooms[0].floor, {3.0, 1.7}), 0.3 + std::tan(pi / 90.0),
              1e-12);
}

TEST(SceneFile, detailsHaveTheirOwnPlaneOrFollowTheRoom)
{
  json file = minimalFile();
  json& room = file["rooms"][0];
  room["ceiling"] = {{"height", 3.0}, {"slope", 1.0}, {"towards", 0.0}};
  room["ceiling_details"] = json::parse(R"([
    {"loop": {"rectangle": [[0, 0], [1, 4]]}, "height": 2.4},
    {"loop": {"rectangle": [[2, 1], [3, 2]]}, "drop": -0.2}])");
  room["floor_details"] = json::parse(R"([
    {"loop": {"rectangle": [[4, 0], [5, 4]]}, "rise": 0.17},
    {"loop": {"rectangle": [[2, 3], [3, 4]]}, "height": -0.4}])");
  file["scanners"][0]["stations"] = {{2.0, 2.5, 1.5}};
  const Room read_room = read(file).rooms.at(0);
  ASSERT_EQ(read_room.details.size(), 2U);
  EXPECT_EQ(heightAt(read_room.details[0].slab, {0.5, 1.0}), 2.4);
  for (const Vec2 point : {Vec2{2.1, 1.2}, Vec2{2.9, 1.8}})
    EXPECT_NEAR(heightAt(read_room.details[1].slab, point),
                heightAt(read_room.ceiling, point) + 0.2, 1e-12);
  ASSERT_EQ(read_room.floor_details.size(), 2U);
  EXPECT_NEAR(read_room.floor_details[0].slab.height, 0.17, 1e-12);
  EXPECT_EQ(read_room.floor_details[1].slab.height, -0.4);
}

TEST(SceneFile, columnsAndNiches)
{
  json file = minimalFile();
  file["rooms"][0]["columns"] = json::parse(
      R"([{"circle": [1, 1], "radius": 0.25}, {"rectangle": [[3, 3], [3.4, 3.4]]}])");
  file["rooms"][0]["niches"] = json::parse(
      R"([{"wall": 2, "from": 1, "to": 2, "sill": 0.5, "head": 1.5, "depth": 0.3}])");
  const Room room = read(file).rooms.at(0);
  ASSERT_EQ(room.columns.size(), 2U);
  EXPECT_NEAR(areaOf(room.columns[0]), pi / 16.0, 1e-12);
  EXPECT_NEAR(areaOf(room.columns[1]), 0.16, 1e-12);
  ASSERT_EQ(room.niches.size(), 1U);
  const Niche& niche = room.niches[0];
  EXPECT_EQ(niche.wall, 2U);
  EXPECT_EQ(niche.from, 1.0);
  EXPECT_EQ(niche.to, 2.0);
  EXPECT_EQ(niche.sill, 0.5);
  EXPECT_EQ(niche.head, 1.5);
  EXPECT_EQ(niche.depth, 0.3);
}

json
fileOfTwoRooms()
{
  json file = minimalFile();
  file["rooms"].push_back(json::parse(
      R"({"name": "annex", "outline": {"rectangle": [[5.1, 0], [8, 4]]},
          "floor": 0.2, "ceiling": 3})"));
  return file;
}

TEST(SceneFile, openingsStandOnTheFloorUnlessTheyHaveASill)
{
  json file = fileOfTwoRooms();
  file["rooms"][0]["openings"] = json::parse(R"([
    {"wall": 0, "from": 1, "to": 2, "sill": 0.9, "head": 2.1, "depth": 0.3,
     "glazing": {"return_share": 0.2}}])");
  file["rooms"][1]["openings"] = json::parse(R"([
    {"wall": 3, "from": 1, "to": 2, "head": 2.2, "depth": 0.1, "leads_to": "box"}])");
  const Scene scene = read(file);
  const Opening& window = scene.rooms[0].openings.at(0);
  EXPECT_EQ(window.wall, 0U);
  EXPECT_EQ(window.from, 1.0);
  EXPECT_EQ(window.to, 2.0);
  EXPECT_EQ(window.sill, 0.9);
  EXPECT_EQ(window.head, 2.1);
  EXPECT_EQ(window.depth, 0.3);
  EXPECT_FALSE(window.leads_to.has_value());
  ASSERT_TRUE(window.glazing.has_value());
  EXPECT_EQ(window.glazing->return_share, 0.2);
  EXPECT_EQ(window.glazing->mirror_share, Glazing{}.mirror_share);
  const Opening& door = scene.rooms[1].openings.at(0);
  EXPECT_EQ(door.sill, 0.2);
  EXPECT_EQ(door.leads_to, std::size_t{0});
  EXPECT_FALSE(door.glazing.has_value());
}

TEST(SceneFile, doorsHaveLeavesAndLobbies)
{
  json file = minimalFile();
  file["rooms"][0]["openings"] = json::parse(R"([
    {"wall": 0, "from": 1, "to": 2, "head": 2, "depth": 0.2,
     "leaf": {"hinge": "from", "angle": 90},
     "lobby": {"depth": 2, "margin": 1, "height": 2.5}},
    {"wall": 2, "from": 1, "to": 2, "head": 2, "depth": 0.2,
     "leaf": {"hinge": "to", "angle": 0}}])");
  const Scene scene = read(file);
  // An open leaf stands in the room, perpendicular to the wall beside the opening.
  ASSERT_EQ(scene.furniture.size(), 1U);
  const Box& open = scene.furniture[0].boxes.at(0);
  expectNear(plan(open.center), {0.97, 0.03 + 0.5});
  expectNear(rotated({1.0, 0.0}, open.yaw), {0.0, 1.0});
  EXPECT_EQ(scene.furniture[0].place, "rooms[0].openings[0].leaf");
  // The lobby: floor, ceiling and three walls, from the outer face of the wall.
  ASSERT_EQ(scene.outside.size(), 2U);
  ASSERT_EQ(scene.outside[0].boxes.size(), 5U);
  expectNear(scene.outside[0].boxes[0].center, {1.5, -0.2 - 1.0, -0.05});
  expectNear(scene.outside[0].boxes[0].size, {3.0, 2.0, 0.1});
  expectNear(scene.outside[0].boxes[1].center, {1.5, -1.2, 2.55});
  expectNear(scene.outside[0].boxes[4].center, {1.5, -2.25, 1.25});
  // A shut leaf fills the opening in the middle of the wall.
  const Box& shut = scene.outside[1].boxes.at(0);
  expectNear(shut.center, {3.5, 4.1, 1.0});
  expectNear(shut.size, {1.0, 0.04, 2.0});
}

TEST(SceneFile, stationsAreListedOrWalked)
{
  json file = fileOfTwoRooms();
  file["scanners"] = json::parse(R"([
    {"stations": [[1, 1, 1.5], [2, 3, 1.6]], "rays": 500, "noise": 0,
     "min_elevation": -45, "jitter": 0.5, "max_range": 12},
    {"walk": {"path": [[1, 1], [4, 1], [4, 3]], "count": 6, "height": 1.5, "sway": 0.1},
     "rays": 50, "noise": 0.01},
    {"walk": {"path": [[6, 1], [7, 1]], "count": 2, "height": 1.5},
     "rays": 50, "noise": 0.01}])");
  const Scene scene = read(file);
  ASSERT_EQ(scene.scanners.size(), 3U);
  EXPECT_EQ(scene.scanners[0].stations.size(), 2U);
  expectNear(scene.scanners[0].stations[1], {2.0, 3.0, 1.6});
  EXPECT_EQ(scene.scanners[0].min_elevation, -45.0);
  EXPECT_EQ(scene.scanners[0].jitter, 0.5);
  EXPECT_EQ(scene.scanners[0].max_range, 12.0);
  const auto walk = walkAlong({{1.0, 1.0}, {4.0, 1.0}, {4.0, 3.0}}, 6, 1.5, 0.1);
  ASSERT_EQ(scene.scanners[1].stations.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i)
    expectNear(scene.scanners[1].stations[i], walk[i]);
  // The floor of the second room is at 0.2 m.
  expectNear(scene.scanners[2].stations.at(1), {7.0, 1.0, 1.7});
}

TEST(SceneFile, placementTurnsAndShifts)
{
  const Scene scene = readWith("/placement", {{"yaw", 30}, {"shift", {1, 2, 3}}});
  EXPECT_EQ(scene.placement.yaw, 30.0);
  expectNear(scene.placement.shift, {1.0, 2.0, 3.0});
}

TEST(SceneFile, builtInScenesAreNamedAsTheirFiles)
{
  ASSERT_GE(builtInScenes().size(), 15U);
  for (const BuiltInScene& scene : builtInScenes()) {
    EXPECT_EQ(sceneNamed(scene.name).name, scene.name);
    EXPECT_EQ(sceneText(scene.name), scene.text);
  }
}

TEST(SceneFile, theExampleOfThePageIsAScene)
{
  const std::string page = bytesOf(SIMULATOR_PAGE);
  const std::string fence = "```json\n";
  const std::size_t start = page.find(fence) + fence.size();
  ASSERT_LT(start, page.size());
  const Scene scene =
      parseScene(page.substr(start, page.find("```", start) - start), "page");
  EXPECT_EQ(scene.rooms.size(), 2U);
  EXPECT_EQ(scene.rooms[0].niches.size(), 1U);
  EXPECT_EQ(scene.furniture.size(), 1U + 2U + 4U + 1U);
}

TEST(SceneFile, filesOnDiskAreReadByTheirPath)
{
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "my scene.json").string();
  std::ofstream(path) << minimalFile().dump(2);
  EXPECT_EQ(sceneNamed(path).name, "minimal");
  EXPECT_EQ(sceneText(path), minimalFile().dump(2));
}

} // namespace
} // namespace pcl::sedr::sim::test
