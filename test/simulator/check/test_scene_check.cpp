// SPDX-License-Identifier: BSD-3-Clause
#include "simulator/check/scene_check.h"
#include "simulator/sample_rooms.h"
#include "simulator/scene/furniture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace pcl::sedr::sim::test {
namespace {

Scene
saneScene()
{
  Room room = makeBoxRoom(5.0, 4.0, 3.0);
  room.columns.push_back(circleLoop({1.0, 1.0}, 0.3));
  return makeScene(room, {2.0, 2.0, 1.5}, 100);
}

TEST(SceneCheck, hasNothingToSayAboutASaneScene)
{
  EXPECT_TRUE(problemsOf(saneScene()).empty());
}

TEST(SceneCheck, findsFurnitureWhereItCannotBe)
{
  const Extent cube{0.5, 0.5, 0.5};
  const Spot spots[] = {{{4.9, 2.0}, 0.0, 0.0},   // through the wall
                        {{1.4, 1.0}, 0.0, 0.0},   // through the column
                        {{1.0, 1.0}, 0.0, 0.0},   // around the column
                        {{9.0, 9.0}, 0.0, 0.0},   // outside
                        {{3.0, 3.0}, 0.0, -0.1},  // sunk into the floor
                        {{3.0, 3.0}, 0.0, 2.6},   // through the ceiling
                        {{2.0, 2.0}, 0.0, 1.25}}; // around the scanner
  for (const Spot& spot : spots) {
    Scene scene = saneScene();
    scene.furniture.push_back(makeBlock("cube", spot, cube));
    EXPECT_FALSE(problemsOf(scene).empty()) << spot.center.x << ' ' << spot.floor;
  }
}

TEST(SceneCheck, findsFaultyRooms)
{
  Scene scene = saneScene();
  std::reverse(scene.rooms[0].outline.begin(), scene.rooms[0].outline.end());
  EXPECT_FALSE(problemsOf(scene).empty());
  scene = saneScene();
  scene.rooms[0].ceiling.height = 0.0;
  EXPECT_FALSE(problemsOf(scene).empty());
  scene = saneScene();
  scene.rooms[0].columns.front() = circleLoop({0.2, 1.0}, 0.3);
  EXPECT_FALSE(problemsOf(scene).empty());
  scene = saneScene();
  scene.rooms[0].details.push_back({rectangleLoop({4.0, 1.0}, {5.5, 2.0}), {2.5}});
  EXPECT_FALSE(problemsOf(scene).empty());
  scene = saneScene();
  scene.rooms[0].openings.push_back({0, 1.0, 2.0, 0.0, 3.2, 0.1});
  EXPECT_FALSE(problemsOf(scene).empty());
  scene = saneScene();
  scene.rooms[0].openings.push_back({0, 1.0, 2.0, -0.2, 2.0, 0.1});
  EXPECT_FALSE(problemsOf(scene).empty());
}

/** @brief Expects that the first problem begins with @p place and contains @p part. */
void
expectProblem(const Scene& scene, const std::string& place, const std::string& part)
{
  const auto problems = problemsOf(scene);
  ASSERT_FALSE(problems.empty()) << place << ' ' << part;
  EXPECT_EQ(problems.front().rfind(place, 0), 0U) << problems.front();
  EXPECT_NE(problems.front().find(part), std::string::npos) << problems.front();
}

/** @brief Returns two rooms of 5 x 4 m with a door in the 0.1 m between them. */
Scene
pairOfRooms()
{
  Scene scene = saneScene();
  Room right = makeBoxRoom(5.0, 4.0, 3.0);
  right.name = "right";
  right.outline = rectangleLoop({5.1, 0.0}, {10.1, 4.0});
  scene.rooms.push_back(right);
  Opening door{1, 1.0, 2.0, 0.0, 2.0, 0.1};
  door.leads_to = 1;
  scene.rooms[0].openings.push_back(door);
  return scene;
}

TEST(SceneCheck, findsRoomsThatOverlap)
{
  EXPECT_TRUE(problemsOf(pairOfRooms()).empty());
  const Loop outlines[] = {rectangleLoop({4.9, 0.0}, {10.0, 4.0}),  // across its wall
                           rectangleLoop({2.0, 2.0}, {3.0, 3.0}),   // within it
                           rectangleLoop({-1.0, -1.0}, {6.0, 6.0}), // around it
                           rectangleLoop({2.0, -1.0}, {3.0, 5.0}),  // a cross
                           rectangleLoop({0.0, 0.0}, {5.0, 4.0})};  // identical
  for (const Loop& outline : outlines) {
    Scene scene = saneScene();
    scene.rooms.push_back(makeBoxRoom(5.0, 4.0, 3.0));
    scene.rooms[1].outline = outline;
    expectProblem(scene, "rooms[1]", "overlaps room 'box'");
  }
  Scene scene = saneScene(); // adjacent rooms do not overlap
  scene.rooms.push_back(makeBoxRoom(5.0, 4.0, 3.0));
  scene.rooms[1].outline = rectangleLoop({5.0, 0.0}, {10.0, 4.0});
  EXPECT_TRUE(problemsOf(scene).empty());
}

TEST(SceneCheck, findsDoorsBelowTheFloorBehindThem)
{
  Scene scene = pairOfRooms();
  scene.rooms[1].floor.height = 0.17;
  expectProblem(scene, "rooms[0].openings[0].sill",
                "below the floor of room 'right' at 0.17");
  scene.rooms[0].openings[0].sill = 0.17;
  EXPECT_TRUE(problemsOf(scene).empty());
  // A platform behind the door is checked, too.
  scene.rooms[1].floor_details.push_back(
      {rectangleLoop({5.1, 0.0}, {6.1, 4.0}), {0.3}});
  expectProblem(scene, "rooms[0].openings[0].sill", "0.3");
  scene = pairOfRooms();
  scene.rooms[1].ceiling.height = 1.9;
  expectProblem(scene, "rooms[0].openings[0].head", "above the ceiling");
}

TEST(SceneCheck, findsOpeningsAndNichesThatOverlap)
{
  Scene scene = pairOfRooms();
  scene.rooms[0].openings.push_back({1, 1.5, 2.5, 1.0, 2.2, 0.05});
  expectProblem(scene, "rooms[0].openings[1]", "overlaps rooms[0].openings[0]");
  scene.rooms[0].openings.back().from = 2.0; // side by side
  scene.rooms[0].openings.back().depth = 0.05;
  EXPECT_TRUE(problemsOf(scene).empty());
  // The door is also an opening of the other room.
  scene = pairOfRooms();
  scene.rooms[1].niches.push_back({3, 2.5, 3.5, 0.5, 1.5, 0.05});
  expectProblem(scene, "rooms[1].niches[0]", "overlaps rooms[0].openings[0]");
  scene = pairOfRooms();
  scene.rooms[0].niches.push_back({0, 1.0, 2.0, 0.5, 1.5, 0.2});
  scene.rooms[0].niches.push_back({0, 1.5, 2.5, 1.4, 2.0, 0.2});
  expectProblem(scene, "rooms[0].niches[1]", "overlaps rooms[0].niches[0]");
  scene.rooms[0].niches[1].sill = 1.6; // one above the other
  EXPECT_TRUE(problemsOf(scene).empty());
}

TEST(SceneCheck, findsNichesThatFitNowhere)
{
  const Niche faulty[] = {{9, 1.0, 2.0, 0.5, 1.5, 0.2},  // on no wall
                          {0, 4.5, 5.5, 0.5, 1.5, 0.2},  // beyond its end
                          {0, 1.0, 2.0, 1.5, 0.5, 0.2},  // upside down
                          {0, 1.0, 2.0, 0.5, 1.5, 0.0},  // without depth
                          {0, 1.0, 2.0, -0.5, 1.5, 0.2}, // below the floor
                          {0, 1.0, 2.0, 0.5, 3.1, 0.2},  // above the ceiling
                          {1, 2.5, 3.5, 0.5, 1.5, 0.3}}; // into the other room
  for (const Niche& niche : faulty) {
    Scene scene = pairOfRooms();
    scene.rooms[0].niches.push_back(niche);
    expectProblem(scene, "rooms[0].niches[0]", "");
  }
}

TEST(SceneCheck, findsNichesThatMeetWithinAPartition)
{
  // 0.1 m between the rooms: two niches of 6 cm, back to back or one above the other.
  Scene scene = pairOfRooms();
  scene.rooms[0].niches.push_back({1, 2.5, 3.5, 0.5, 1.5, 0.06});
  scene.rooms[1].niches.push_back({3, 0.2, 1.0, 0.8, 1.2, 0.06});
  expectProblem(scene, "rooms[1].niches[0]", "overlaps rooms[0].niches[0]");
  scene.rooms[1].niches[0].sill = 1.5;
  scene.rooms[1].niches[0].head = 2.5;
  EXPECT_TRUE(problemsOf(scene).empty());
}

TEST(SceneCheck, findsWindowsIntoOtherRooms)
{
  Scene scene = pairOfRooms();
  scene.rooms[0].openings.push_back({1, 2.5, 3.5, 1.0, 2.0, 0.3});
  expectProblem(scene, "rooms[0].openings[1]", "reaches into room 'right'");
}

TEST(SceneCheck, findsFaultyFloorsAndCeilings)
{
  Scene scene = saneScene();
  scene.rooms[0].floor_details.push_back(
      {rectangleLoop({4.0, 1.0}, {5.5, 2.0}), {0.2}});
  expectProblem(scene, "rooms[0].floor_details[0]", "reaches out");
  scene = saneScene();
  scene.rooms[0].floor_details.push_back(
      {rectangleLoop({3.0, 1.0}, {4.0, 2.0}), {2.7}});
  scene.rooms[0].details.push_back({rectangleLoop({3.5, 1.5}, {4.5, 2.5}), {2.6}});
  expectProblem(scene, "rooms[0]", "has no height");
  scene = saneScene();
  scene.rooms[0].ceiling.gradient = {-1.0, 0.0}; // meets the floor 3 m from the corner
  expectProblem(scene, "rooms[0]", "has no height");
}

TEST(SceneCheck, knowsPlatformsSlopesAndSoffitsAboveFurniture)
{
  const Extent tall{0.5, 0.5, 2.8};
  Scene scene = saneScene();
  scene.rooms[0].floor_details.push_back(
      {rectangleLoop({3.0, 0.0}, {5.0, 4.0}), {0.3}});
  scene.furniture.push_back(makeBlock("cube", {{4.0, 1.0}, 0.0, 0.0}, {0.5, 0.5, 0.5}));
  expectProblem(scene, "the cube", "below the floor");
  scene.furniture.back() = makeBlock("cube", {{4.0, 1.0}, 0.0, 0.3}, {0.5, 0.5, 0.5});
  EXPECT_TRUE(problemsOf(scene).empty());
  scene.furniture.back() = makeBlock("pole", {{4.0, 1.0}, 0.0, 0.3}, tall);
  expectProblem(scene, "the pole", "above the ceiling");
  // A soffit too small to reach the edge of the object below it.
  scene = saneScene();
  scene.rooms[0].details.push_back({rectangleLoop({3.9, 0.9}, {4.1, 1.1}), {2.4}});
  scene.furniture.push_back(makeBlock("pole", {{4.0, 1.0}, 0.0, 0.0}, tall));
  expectProblem(scene, "the pole", "above the ceiling");
  // On a slope of 0.5 degrees a cupboard touches the floor at its middle.
  scene = saneScene();
  scene.rooms[0].floor.gradient = {std::tan(0.5 * pi / 180.0), 0.0};
  const double floor = heightAt(scene.rooms[0].floor, {4.0, 1.0});
  scene.furniture.push_back(makeBlock("pole", {{4.0, 1.0}, 0.0, floor}, tall));
  EXPECT_TRUE(problemsOf(scene).empty());
}

TEST(SceneCheck, findsScannersWhereTheyCannotBe)
{
  for (const Vec3 station :
       {Vec3{1.0, 1.0, 1.5}, Vec3{7.0, 1.0, 1.5}, Vec3{2.0, 2.0, 3.5}}) {
    Scene scene = saneScene();
    scene.scanners.front().stations.push_back(station);
    EXPECT_FALSE(problemsOf(scene).empty()) << station.x << ' ' << station.z;
  }
}

} // namespace
} // namespace pcl::sedr::sim::test
