// SPDX-License-Identifier: BSD-3-Clause
// Scene files: what they mean, and which are refused, with the place of their fault.
#include "sample_scenes.h"
#include "says.h"
#include "simulator/temporary_folder.h"

#include <gtest/gtest.h>

namespace pcl::sedr::sim::test {
namespace {

/** @brief Returns a file with every kind of element. */
json
fullFile()
{
  return json::parse(R"({
    "format": "sedr-scene", "version": 1, "name": "full", "summary": "all there is",
    "rooms": [
      {"name": "left", "outline": [[0, 0], [5, 0], [5, 4], {"at": [0, 4], "radius": 3}],
       "floor": 0, "ceiling": {"height": 3, "slope": 1, "towards": 0, "at": [0, 0]},
       "floor_details": [{"loop": {"rectangle": [[4, 0], [5, 4]]}, "rise": 0.2}],
       "ceiling_details": [{"loop": {"rectangle": [[0, 3.5], [5, 4]]}, "drop": 0.3}],
       "columns": [{"circle": [1, 1], "radius": 0.2}],
       "niches": [{"wall": 0, "from": 0.5, "to": 1, "sill": 0.5, "head": 1, "depth": 0.2}],
       "openings": [
         {"wall": 0, "from": 2, "to": 3, "sill": 0.9, "head": 2, "depth": 0.3,
          "glazing": {"return_share": 0.1, "mirror_share": 0.1}},
         {"wall": 1, "from": 1, "to": 2, "sill": 0.2, "head": 2, "depth": 0.1,
          "leads_to": "right", "leaf": {"hinge": "from", "angle": 90}},
         {"wall": 2, "from": 1, "to": 2, "head": 2, "depth": 0.3,
          "lobby": {"depth": 1, "margin": 1, "height": 2.5}}],
       "furniture": [
         {"shelf": {"wall": 0, "s": 3.3, "row": {"count": 1, "gap": 0.1}, "size": [0.5, 0.3, 0.8]}},
         {"lamp": {"at": [2, 2], "drop": 0.5, "radius": 0.2}},
         {"door_leaf": {"hinge": [1, 3], "direction": 0, "width": 0.5, "height": 1}},
         {"group": {"places": [[2, 2], [3, 1, 10]], "objects": [{"chair": {"at": [0, 0]}}]}}]},
      {"name": "right", "outline": {"rectangle": [[5.1, 0], [9, 4]]}, "floor": 0.2, "ceiling": 3},
      {"name": "third", "outline": {"rectangle": [[30, 0], [32, 2]]}, "floor": 0, "ceiling": 3}],
    "outside": [
      {"tree": {"at": [12, 2], "floor": -1, "height": 5, "crown": 1}},
      {"object": {"name": "kiosk", "boxes": [{"center": [20, 2, 1], "size": [2, 2, 2]}],
                  "cylinders": [{"base": [20, 9, 0], "radius": 1, "height": 3}]}}],
    "scanners": [
      {"stations": [[2, 2.5, 1.5]], "rays": 100, "noise": 0.005},
      {"walk": {"path": [[6, 1], [8, 3]], "count": 3, "height": 1.5, "sway": 0.1},
       "rays": 100, "jitter": 0.1, "max_range": 30, "noise": 0.005}],
    "placement": {"yaw": 10, "shift": [1, 2, 3]}
  })");
}

/** @brief Returns the box that all parts of an object are in. */
Eigen::AlignedBox3d
boundsOf(const Object& object)
{
  Eigen::AlignedBox3d bounds;
  for (const Prism& part : object.parts)
    for (const Vec2& corner : part.corners)
      for (const double z : {part.low, part.high})
        bounds.extend(lifted(corner, z));
  return bounds;
}

TEST(SceneFile, placesObjectsByPointWallRowAndGroup)
{
  const Scene scene = read(with(boxFile(), R"({
      "/rooms/0/floor_details": [{"loop": {"rectangle": [[0, 3], [5, 4]]}, "rise": 0.2}],
      "/scanners/0/stations": [[4.5, 2, 1.5]],
      "/rooms/0/furniture": [
        {"block": {"at": [1, 1], "yaw": 90, "size": [1, 0.4, 0.8], "raise": 0.1}},
        {"block": {"wall": 2, "s": 1, "gap": 0.1, "size": [0.6, 0.4, 1],
                   "row": {"count": 2, "gap": 0.2}}},
        {"group": {"places": [[3, 1, 90]], "objects": [
          {"cylinder": {"at": [0.5, 0], "radius": 0.1, "height": 1}}]}},
        {"lamp": {"at": [2, 2], "drop": 1, "radius": 0.2}},
        {"stairs": {"at": [3.5, 0.5], "width": 0.8, "rise": 0.2, "going": 0.3, "steps": 3}}]
      })"));
  const auto expect = [&](std::size_t i, Vec3 low, Vec3 high) {
    const Eigen::AlignedBox3d bounds = boundsOf(scene.furniture.at(i));
    EXPECT_LT((bounds.min() - low).norm(), kCurveTolerance)
        << i << ": " << bounds.min().transpose();
    EXPECT_LT((bounds.max() - high).norm(), kCurveTolerance)
        << i << ": " << bounds.max().transpose();
  };
  expect(0, {0.8, 0.5, 0.1}, {1.2, 1.5, 0.9});
  // Wall 2 runs from (5, 4) to (0, 4); the platform before it is 0.2 m high.
  expect(1, {3.7, 3.5, 0.2}, {4.3, 3.9, 1.2});
  expect(2, {2.9, 3.5, 0.2}, {3.5, 3.9, 1.2});
  expect(3, {2.9, 1.4, 0}, {3.1, 1.6, 1});
  expect(4, {1.8, 1.8, 2}, {2.2, 2.2, 3});
  expect(5, {3.1, 0.5, 0}, {3.9, 1.4, 0.6});
}

TEST(SceneFile, openingsHaveArchesBlindsAndPairsOfLeaves)
{
  const Scene scene = read(with(boxFile(), R"({"/rooms/0/openings": [
      {"wall": 0, "from": 1, "to": 3, "sill": 0, "head": 2.2, "depth": 0.2, "rise": 0.5,
       "leaf": {"hinge": "both", "angle": 90}},
      {"wall": 2, "from": 1, "to": 2, "sill": 0.9, "head": 2.1, "depth": 0.2,
       "glazing": {}, "blind": 0.25}]})"));
  ASSERT_EQ(scene.furniture.size(), 2U);
  for (const Object& leaf : scene.furniture)
    EXPECT_NEAR(boundsOf(leaf).max().y(), 1.03, 1e-9); // half of 2 m, 3 cm off the wall
  EXPECT_NEAR(boundsOf(scene.furniture[0]).center().x(), 0.97, 1e-9);
  EXPECT_NEAR(boundsOf(scene.furniture[1]).center().x(), 3.03, 1e-9);
  Eigen::AlignedBox3d arch, blind;
  double above = 0; // the arch, square metres
  for (const Object& object : scene.outside) {
    const Eigen::AlignedBox3d bounds = boundsOf(object);
    (object.name == "arch" ? arch : blind).extend(bounds);
    if (object.name == "arch")
      above += bounds.sizes().x() * bounds.sizes().z();
  }
  EXPECT_LT((arch.min() - Vec3(1, -0.2, 1.7)).norm(), 0.1);
  EXPECT_LT((arch.max() - Vec3(3, 0, 2.2)).norm(), 1e-9);
  EXPECT_NEAR(above, (1 - pi / 4) * 2 * 0.5, 0.003);
  EXPECT_NEAR(blind.min().z(), 1.8, 1e-9);
  EXPECT_LT((blind.max() - Vec3(4, 4.07, 2.1)).norm(), 1e-9);
}

TEST(SceneFile, walksFollowTheFloorBelowThem)
{
  json file = with(twoStoreyFile(), R"({"/scanners": [{"walk":
      {"path": [[1, 1], [4, 1]], "count": 2, "height": 1.5}, "rays": 9, "noise": 0}]})");
  EXPECT_LT((read(file).scanners[0].stations[1] - Vec3(4, 1, 1.5)).norm(), 1e-9);
  file["scanners"][0]["walk"]["floor"] = 3;
  EXPECT_LT((read(file).scanners[0].stations[1] - Vec3(4, 1, 4.4)).norm(), 1e-9);
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
  EXPECT_EQ(scene.furniture.size(), 1U + 2U + 4U + 1U);
}

/** @brief A change of a scene, and how the sentence that refuses it begins. */
struct Refusal {
  const char* pointer;
  const char* value;
  const char* place;
};

TEST(SceneFile, isRefusedWithThePlaceOfItsFault)
{
  const Refusal refusals[] = {
      {"/format", R"("obj")", "format must be"},
      {"/version", "2", "version must be a whole number from 1 to 1, not 2"},
      {"/roms", "[]", "the scene has a key that is unknown here: \"roms\""},
      {"/rooms", "[]", "rooms must have at least 1"},
      {"/rooms/0/floor", R"("0")", "rooms[0].floor must be a number"},
      {"/rooms/0/floor", "1e300", "rooms[0].floor must be a number"},
      {"/rooms/0/outline/1", "[5]", "rooms[0].outline[1] must be a list of 2 numbers"},
      {"/rooms/0/outline", R"({"square": 1})", "rooms[0].outline must be a list"},
      {"/rooms/0/outline", "[[0, 0], [0, 4], [5, 4], [5, 0]]",
       "rooms[0].outline does not run counter-clockwise"},
      {"/rooms/0/outline/3/radius", "1", "rooms[0].outline[3].radius is 1, too small"},
      {"/rooms/0/outline/1", "[0, 0]", "rooms[0].outline[0] is the same point"},
      {"/rooms/0/ceiling_details/0/height", "2",
       "rooms[0].ceiling_details[0] must have"},
      {"/rooms/0/columns/0/yaw", "1", "rooms[0].columns[0] has a key"},
      {"/rooms/0/openings/0/wall", "4",
       "rooms[0].openings[0].wall must be a whole number from 0 to 3, not 4"},
      {"/rooms/0/openings/0/depth", "0", "rooms[0].openings[0].depth must be"},
      {"/rooms/0/openings/1/leads_to", R"("attic")",
       "rooms[0].openings[1].leads_to is"},
      {"/rooms/0/openings/1/leaf/hinge", R"("left")",
       "rooms[0].openings[1].leaf.hinge"},
      {"/rooms/0/openings/0/glazing/mirror_share", "0.95",
       "rooms[0].openings[0].glazing"},
      {"/rooms/0/furniture/0", R"({"sofa": {}})",
       "rooms[0].furniture[0] is of unknown"},
      {"/rooms/0/furniture/0", R"({"chair": {"at": [7, 2]}})",
       "rooms[0].furniture[0].chair is not within its room"},
      {"/rooms/0/furniture/0", R"({"object": {"name": "a"}})",
       "rooms[0].furniture[0].object has neither boxes nor cylinders"},
      {"/outside/0", R"({"lamp": {}})", "outside[0] is of unknown kind"},
      {"/rooms/1/name", R"("left")", "rooms[1].name is that of another room"},
      {"/scanners/0/rays", "0.5", "scanners[0].rays must be a whole number"},
      {"/scanners/0/walk", "{}", "scanners[0] must have either"},
      // What is no fault of the text, but of the scene:
      {"/rooms/0/ceiling", "0.1", "rooms[0] cannot be built: the ceiling is not above"},
      {"/rooms/2/outline/rectangle", "[[4.9, 1], [5.05, 2]]",
       "rooms[0] cannot be built: it overlaps room 'third'"},
      {"/rooms/2/outline/rectangle", "[[1.4, 1.4], [2, 2]]",
       "rooms[0] cannot be built: it overlaps room 'third'"},
      {"/rooms/0/niches/0/to", "9", "rooms[0].niches[0] does not lie within its wall"},
      {"/rooms/0/niches/0/head", "0.2", "rooms[0].niches[0] has no height"},
      {"/rooms/0/niches/0/head", "3.5", "rooms[0] cannot be built"},
      {"/rooms/0/openings/0/to", "5.5", "rooms[0].openings[0] does not lie within"},
      {"/rooms/0/openings/0/from", "0.7", "rooms[0]"},
      {"/rooms/0/openings/1/sill", "0.1", "rooms[0] cannot be built: an opening"},
      {"/rooms/1/floor", "0.3", "rooms[1] cannot be built: an opening"},
      {"/rooms/0/openings/1/depth", "0.2",
       "rooms[0] cannot be built: opening 2 leads to room 'right'"},
      {"/rooms/0/openings/3",
       R"({"wall": 1, "from": 2.5, "to": 3.5, "sill": 1, "head": 2, "depth": 0.3})",
       "rooms[0] cannot be built: an opening, niche, void or plenum reaches into room "
       "'right'"},
      {"/rooms/0/furniture/0", R"({"block": {"at": [2, 2.5], "size": [1, 0.8, 2]}})",
       "scanners[0]: station 0 at (2, 2.5) is in the block"},
      {"/scanners/0/stations/0", "[20, 2, 1.5]",
       "scanners[0]: station 0 at (20, 2) is in no room"}};
  EXPECT_EQ(refusalOf(fullFile()), "");
  for (const Refusal& r : refusals) {
    json file = fullFile();
    file[json::json_pointer(r.pointer)] = json::parse(r.value);
    const std::string refusal = refusalOf(file);
    EXPECT_EQ(refusal.rfind(std::string("test.json: ") + r.place, 0), 0U)
        << r.pointer << ": " << refusal;
  }
}

TEST(SceneFile, isRefusedWithVoidsThatCannotBe)
{
  const Refusal refusals[] = {
      {"/rooms/0/voids/0/loop", R"({"rectangle": [[4, 3.6], [7, 4.8]]})",
       "rooms[0] cannot be built: a void reaches out of the room"},
      {"/rooms/1/outline", R"({"rectangle": [[2, 0], [6, 5]]})",
       "rooms[1] cannot be built: a void reaches out of the room"},
      {"/rooms/0/voids/0/leads_to", R"("below")",
       "rooms[0] cannot be built: an opening, niche, void or plenum has no height"},
      {"/rooms/0/voids/0", R"({"loop": {"rectangle": [[1, 1], [2, 2]]}})",
       "rooms[0] cannot be built: a void leads to no room, and there is no plenum"}};
  EXPECT_EQ(refusalOf(twoStoreyFile()), "");
  for (const Refusal& r : refusals) {
    json file = twoStoreyFile();
    file["rooms"][0].erase("furniture");
    file["rooms"][0].erase("openings");
    file[json::json_pointer(r.pointer)] = json::parse(r.value);
    const std::string refusal = refusalOf(file);
    EXPECT_EQ(refusal.rfind(std::string("test.json: ") + r.place, 0), 0U) << refusal;
  }
}

TEST(SceneFile, isRefusedIfItsTextIsNoJson)
{
  for (const char* text : {"", "{", "[1, 2", "{\"a\": 1,}", "{\"a\": nan}", "\x01"})
    EXPECT_THROW(parseScene(text, "test.json"), std::invalid_argument) << text;
  EXPECT_THROW(parseScene(R"({"rooms": [{"x": 1, "x": 2}]})", "test.json"),
               std::invalid_argument);
}

/** @brief Collects the pointers to all values of a document. */
void
collectPointers(const json& value,
                const json::json_pointer& here,
                std::vector<json::json_pointer>& pointers)
{
  pointers.push_back(here);
  if (value.is_object())
    for (const auto& entry : value.items())
      collectPointers(entry.value(), here / entry.key(), pointers);
  if (value.is_array())
    for (std::size_t i = 0; i < value.size(); ++i)
      collectPointers(value[i], here / i, pointers);
}

TEST(SceneFile, withAnyValueAnywhereGivesASceneOrOneSentence)
{
  std::vector<json::json_pointer> pointers;
  collectPointers(fullFile(), json::json_pointer(), pointers);
  ASSERT_GT(pointers.size(), 150U);
  const json odd[] = {nullptr, -1, 0.37, 1e300, "x", json::array(), json::object()};
  for (const auto& pointer : pointers)
    for (const json& value : odd) {
      json file = fullFile();
      file[pointer] = value;
      const std::string message = refusalOf(file);
      if (!message.empty()) {
        EXPECT_EQ(message.rfind("test.json: ", 0), 0U) << message;
        EXPECT_FALSE(says(message, "\n"));
      }
    }
}

} // namespace
} // namespace pcl::sedr::sim::test
