// SPDX-License-Identifier: BSD-3-Clause
#include "scene_text.h"
#include "simulator/scene/furniture.h"

#include <gtest/gtest.h>

namespace pcl::sedr::sim::test {
namespace {

/** @brief Returns the furniture of the minimal room, given as JSON. */
std::vector<Object>
readFurniture(const std::string& text)
{
  return readWith("/rooms/0/furniture", json::parse(text)).furniture;
}

Object
readOne(const std::string& text)
{
  const auto objects = readFurniture('[' + text + ']');
  EXPECT_EQ(objects.size(), 1U) << text;
  return objects.at(0);
}

void
expectSame(Vec3 a, Vec3 b)
{
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
  EXPECT_NEAR(a.z, b.z, 1e-12);
}

/** @brief Expects the same name and parts; the place in the file may differ. */
void
expectSame(const Object& a, const Object& b)
{
  EXPECT_EQ(a.name, b.name);
  ASSERT_EQ(a.boxes.size(), b.boxes.size()) << a.name;
  for (std::size_t i = 0; i < a.boxes.size(); ++i) {
    expectSame(a.boxes[i].center, b.boxes[i].center);
    expectSame(a.boxes[i].size, b.boxes[i].size);
    EXPECT_NEAR(a.boxes[i].yaw, b.boxes[i].yaw, 1e-12);
  }
  ASSERT_EQ(a.cylinders.size(), b.cylinders.size()) << a.name;
  for (std::size_t i = 0; i < a.cylinders.size(); ++i) {
    expectSame(a.cylinders[i].base, b.cylinders[i].base);
    EXPECT_NEAR(a.cylinders[i].radius, b.cylinders[i].radius, 1e-12);
    EXPECT_NEAR(a.cylinders[i].height, b.cylinders[i].height, 1e-12);
  }
}

TEST(SceneFileObjects, stairsClimbAwayFromTheirFoot)
{
  const Object open = readOne(R"({"stairs": {"at": [1, 1], "yaw": -90, "width": 0.9,
      "rise": 0.2, "going": 0.25, "steps": 4}})");
  EXPECT_EQ(open.name, "stairs");
  ASSERT_EQ(open.boxes.size(), 4U);
  expectSame(open.boxes[0].center, {1.125, 1.0, 0.1});
  expectSame(open.boxes[3].size, {0.9, 0.25, 0.35}); // a step and 0.15 m below it
  EXPECT_NEAR(open.boxes[3].center.x, 1.875, 1e-12);
  EXPECT_NEAR(open.boxes[3].center.z + 0.5 * open.boxes[3].size.z, 0.8, 1e-12);
  const Object solid = readOne(R"({"stairs": {"at": [1, 1], "width": 0.9, "rise": 0.2,
      "going": 0.25, "steps": 4, "solid": true}})");
  expectSame(solid.boxes[3].center, {1.0, 1.875, 0.4});
  expectSame(solid.boxes[3].size, {0.9, 0.25, 0.8});
}

TEST(SceneFileObjects, furnitureStandsWhereItIsPut)
{
  const Spot spot{{2.0, 1.0}, 0.5 * pi, 0.0};
  expectSame(
      readOne(
          R"({"block": {"name": "bed", "at": [2, 1], "yaw": 90, "size": [1, 2, 0.5]}})"),
      makeBlock("bed", spot, {1.0, 2.0, 0.5}));
  expectSame(
      readOne(R"({"table": {"at": [2, 1], "yaw": 90, "size": [1.2, 0.6, 0.7]}})"),
      makeTable(spot, {1.2, 0.6, 0.7}));
  expectSame(readOne(R"({"chair": {"at": [2, 1], "yaw": 90}})"), makeChair(spot));
  expectSame(readOne(R"({"shelf": {"at": [2, 1], "yaw": 90, "size": [1.2, 0.3, 2]}})"),
             makeShelf(spot, {1.2, 0.3, 2.0}));
  Object tank;
  tank.name = "tank";
  tank.cylinders.push_back({{2.0, 1.0, 0.0}, 0.3, 2.5});
  expectSame(
      readOne(
          R"({"cylinder": {"name": "tank", "at": [2, 1], "radius": 0.3, "height": 2.5}})"),
      tank);
  expectSame(
      readOne(
          R"({"door_leaf": {"hinge": [2, 1], "direction": 45, "width": 0.9, "height": 2}})"),
      makeDoorLeaf({2.0, 1.0}, 0.25 * pi, 0.9, 2.0));
}

TEST(SceneFileObjects, furnitureStandsAtWallsOneByOneOrInARow)
{
  const Element wall{{5.0, 0.0}, {5.0, 4.0}, 0.0};
  expectSame(readOne(R"({"shelf": {"wall": 1, "s": 1, "size": [1, 0.3, 2]}})"),
             makeShelf(spotAtWall(wall, 1.0, 0.3, 0.02), {1.0, 0.3, 2.0}));
  const auto row = readFurniture(
      R"([{"block": {"wall": 1, "s": 1, "gap": 0.1, "row": {"count": 3, "gap": 0.05},
                     "size": [0.8, 0.4, 2]}}])");
  ASSERT_EQ(row.size(), 3U);
  for (int i = 0; i < 3; ++i)
    expectSame(row[i], makeBlock("block", spotAtWall(wall, 1.0 + 0.85 * i, 0.4, 0.1),
                                 {0.8, 0.4, 2.0}));
  EXPECT_EQ(row[1].place, "rooms[0].furniture[0].block");
}

TEST(SceneFileObjects, furnitureStandsOnPlatformsAndHangsFromSoffits)
{
  json file = minimalFile();
  file["rooms"][0]["floor_details"] =
      json::parse(R"([{"loop": {"rectangle": [[0, 0], [2, 4]]}, "rise": 0.3}])");
  file["rooms"][0]["ceiling_details"] =
      json::parse(R"([{"loop": {"rectangle": [[0, 0], [2, 4]]}, "drop": 0.5}])");
  file["rooms"][0]["furniture"] = json::parse(R"([
    {"chair": {"at": [1, 1]}}, {"chair": {"at": [1, 2], "raise": 0.1}},
    {"lamp": {"at": [1, 3], "drop": 0.6, "radius": 0.2}},
    {"lamp": {"at": [4, 3], "drop": 0.6, "radius": 0.2}},
    {"fixture": {"name": "vent", "at": [4, 1], "size": [0.4, 0.3, 0.1]}},
    {"fixture": {"at": [1, 0.5], "yaw": 90, "size": [0.4, 0.3, 0.1], "drop": 0.2}},
    {"duct": {"from": [2.5, 1], "to": [2.5, 3], "radius": 0.15, "drop": 0.1}}])");
  file["scanners"][0]["stations"] = {{3.0, 2.0, 1.5}};
  const auto objects = read(file).furniture;
  ASSERT_EQ(objects.size(), 7U);
  expectSame(objects[0], makeChair({{1.0, 1.0}, 0.0, 0.3}));
  expectSame(objects[1], makeChair({{1.0, 2.0}, 0.0, 0.4}));
  expectSame(objects[2], makeLamp({1.0, 3.0}, 2.5, 0.6, 0.2));
  expectSame(objects[3], makeLamp({4.0, 3.0}, 3.0, 0.6, 0.2));
  expectSame(objects[4],
             makeFixture("vent", {4.0, 1.0}, 0.0, {0.4, 0.3, 0.1}, 3.0, 0.0));
  ASSERT_EQ(objects[4].boxes.size(), 1U);
  EXPECT_NEAR(objects[4].boxes[0].center.z, 2.95, 1e-12);
  EXPECT_TRUE(objects[4].cylinders.empty());
  expectSame(objects[5],
             makeFixture("fixture", {1.0, 0.5}, 0.5 * pi, {0.4, 0.3, 0.1}, 2.5, 0.2));
  ASSERT_EQ(objects[5].cylinders.size(), 4U); // hangs on rods
  expectSame(objects[6], makeDuct({2.5, 1.0}, {2.5, 3.0}, 0.15, 2.9));
}

TEST(Furniture, ductIsRound)
{
  const Object duct = makeDuct({1.0, 1.0}, {3.0, 1.0}, 0.2, 2.5);
  double area = 0.0; // of its section
  for (const Box& box : duct.boxes) {
    EXPECT_EQ(box.size.x, 2.0);
    const double z = box.center.z - 2.3;
    EXPECT_NEAR(0.5 * box.size.y, std::sqrt(0.04 - z * z), 0.03 * 0.2);
    area += box.size.y * box.size.z;
  }
  EXPECT_NEAR(area, 0.04 * pi, 0.001 * pi * 0.04 + 1e-4);
}

TEST(SceneFileObjects, objectsAreBoxesAndCylindersOfTheScene)
{
  const Object object = readOne(R"({"object": {"name": "thing",
    "boxes": [{"center": [1, 1, 0.5], "size": [0.5, 0.4, 1], "yaw": 30}],
    "cylinders": [{"base": [3, 3, 0.2], "radius": 0.1, "height": 0.7}]}})");
  EXPECT_EQ(object.name, "thing");
  ASSERT_EQ(object.boxes.size(), 1U);
  expectSame(object.boxes[0].center, {1.0, 1.0, 0.5});
  expectSame(object.boxes[0].size, {0.5, 0.4, 1.0});
  EXPECT_NEAR(object.boxes[0].yaw, pi / 6.0, 1e-12);
  ASSERT_EQ(object.cylinders.size(), 1U);
  expectSame(object.cylinders[0].base, {3.0, 3.0, 0.2});
}

TEST(SceneFileObjects, groupsRepeatTheirObjectsTurned)
{
  const auto objects = readFurniture(R"([{"group": {
    "places": [[1, 1], [3, 2, 90]],
    "objects": [{"chair": {"at": [0.5, 0]}},
                {"group": {"places": [[0, 0.5]], "objects": [{"chair": {"at": [0, 0], "yaw": 10}}]}}]
  }}])");
  ASSERT_EQ(objects.size(), 4U);
  expectSame(objects[0], makeChair({{1.5, 1.0}, 0.0, 0.0}));
  expectSame(objects[1], makeChair({{1.0, 1.5}, pi / 18.0, 0.0}));
  expectSame(objects[2], makeChair({{3.0, 2.5}, 0.5 * pi, 0.0}));
  expectSame(objects[3], makeChair({{2.5, 2.0}, 0.5 * pi + pi / 18.0, 0.0}));
}

TEST(SceneFileObjects, theOutsideHasAFloorOfItsOwn)
{
  const auto outside = readWith("/outside", json::parse(R"([
    {"tree": {"at": [9, 2], "floor": -3, "height": 6, "crown": 1.5}},
    {"car": {"at": [12, 2], "yaw": 90, "floor": -3}},
    {"block": {"name": "facade", "at": [20, 2], "size": [1, 20, 9]}}])"))
                           .outside;
  ASSERT_EQ(outside.size(), 3U);
  expectSame(outside[0], makeTree({{9.0, 2.0}, 0.0, -3.0}, 6.0, 1.5));
  expectSame(outside[1], makeCar({{12.0, 2.0}, 0.5 * pi, -3.0}));
  expectSame(outside[2], makeBlock("facade", {{20.0, 2.0}}, {1.0, 20.0, 9.0}));
}

} // namespace
} // namespace pcl::sedr::sim::test
