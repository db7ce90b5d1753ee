// SPDX-License-Identifier: BSD-3-Clause
#include "scene_text.h"
#include "simulator/scene/scenes.h"
#include "simulator/temporary_folder.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace pcl::sedr::sim::test {
namespace {

/** @brief Returns the error of reading a text; empty if there is none. */
std::string
messageOf(const std::string& text)
{
  try {
    parseScene(text, "test.json");
    return {};
  }
  catch (const std::invalid_argument& error) {
    return error.what();
  }
}

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
         {"fixture": {"at": [2, 1], "size": [0.2, 0.2, 0.1], "drop": 0.1}},
         {"duct": {"from": [1, 3], "to": [3, 3], "radius": 0.1, "drop": 0.1}},
         {"group": {"places": [[2, 2], [3, 1, 10]], "objects": [{"chair": {"at": [0, 0]}}]}}]},
      {"name": "right", "outline": {"rectangle": [[5.1, 0], [9, 4]]}, "floor": 0.2, "ceiling": 3}],
    "outside": [
      {"tree": {"at": [12, 2], "floor": -1, "height": 5, "crown": 1}},
      {"object": {"name": "kiosk", "boxes": [{"center": [20, 2, 1], "size": [2, 2, 2]}],
                  "cylinders": [{"base": [20, 9, 0], "radius": 1, "height": 3}]}}],
    "scanners": [
      {"stations": [[2, 2.5, 1.5]], "rays": 100, "noise": 0.005},
      {"walk": {"path": [[6, 1], [8, 3]], "count": 3, "height": 1.5, "sway": 0.1},
       "rays": 100, "min_elevation": -60, "jitter": 0.1, "max_range": 30, "noise": 0.005}],
    "placement": {"yaw": 10, "shift": [1, 2, 3]}
  })");
}

/** @brief Expects that the file, changed at a JSON pointer, is rejected with
 * @p sentence after its name. */
void
expectRefused(const std::string& pointer,
              const char* value,
              const std::string& sentence)
{
  json file = fullFile();
  file[json::json_pointer(pointer)] = json::parse(value);
  EXPECT_EQ(messageOf(file.dump()), "test.json: " + sentence) << pointer;
}

TEST(SceneFileErrors, theFullFileHasNone)
{
  EXPECT_EQ(messageOf(fullFile().dump()), "");
}

TEST(SceneFileErrors, textsThatAreNoJson)
{
  for (const char* text : {"", "{", "[1, 2", "{\"a\": 1,}", "{\"a\": nan}", "\x01"}) {
    const std::string message = messageOf(text);
    EXPECT_EQ(message.rfind("test.json: no JSON: ", 0), 0U) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
  EXPECT_NE(messageOf("{\"a\": 1e999}").find("no JSON: number overflow"),
            std::string::npos);
  EXPECT_EQ(messageOf(R"({"name": "a", "rooms": [{"x": 1, "x": 2}]})"),
            "test.json: the key \"x\" is given twice in one object");
}

TEST(SceneFileErrors, documentsThatAreNoScene)
{
  EXPECT_EQ(messageOf("7"), "test.json: the scene must be an object, not 7");
  EXPECT_EQ(messageOf("[]"), "test.json: the scene must be an object, not a list");
  expectRefused("/format", "\"obj\"", "format must be \"sedr-scene\"");
  expectRefused("/version", "2", "version must be a whole number from 1 to 1, not 2");
  expectRefused("/roms", "[]",
                "the scene has an unknown key \"roms\"; known are \"format\", "
                "\"version\", \"name\", \"summary\", \"rooms\", \"outside\", "
                "\"scanners\", \"placement\"");
}

TEST(SceneFileErrors, missingKeysAreNamedWithTheirPlace)
{
  const std::pair<const char*, const char*> missing[] = {
      {"/name", "the scene lacks \"name\""},
      {"/rooms/0/outline", "rooms[0] lacks \"outline\""},
      {"/rooms/1/ceiling", "rooms[1] lacks \"ceiling\""},
      {"/rooms/0/ceiling/slope", "rooms[0].ceiling lacks \"slope\""},
      {"/rooms/0/niches/0/depth", "rooms[0].niches[0] lacks \"depth\""},
      {"/rooms/0/openings/1/head", "rooms[0].openings[1] lacks \"head\""},
      {"/rooms/0/openings/1/leaf/angle", "rooms[0].openings[1].leaf lacks \"angle\""},
      {"/rooms/0/furniture/0/shelf/size", "rooms[0].furniture[0].shelf lacks \"size\""},
      {"/scanners/0/rays", "scanners[0] lacks \"rays\""},
      {"/scanners/0/noise", "scanners[0] lacks \"noise\""},
      {"/scanners/1/walk/count", "scanners[1].walk lacks \"count\""}};
  for (const auto& [pointer, sentence] : missing) {
    const json::json_pointer place(pointer);
    json file = fullFile();
    file[place.parent_pointer()].erase(place.back());
    EXPECT_EQ(messageOf(file.dump()), std::string("test.json: ") + sentence);
  }
}

TEST(SceneFileErrors, valuesOfTheWrongKind)
{
  expectRefused("/name", "\"\"", "name must be a text, not \"\"");
  expectRefused("/rooms", "{}", "rooms must be a list, not an object");
  expectRefused("/rooms", "[]", "rooms must have at least 1 elements, not 0");
  expectRefused("/rooms/0/floor", "\"0\"",
                "rooms[0].floor must be a number from -10000 to 10000, not \"0\"");
  expectRefused("/rooms/0/floor", "1e300",
                "rooms[0].floor must be a number from -10000 to 10000, not 1e+300");
  expectRefused("/rooms/0/outline/1", "[5]",
                "rooms[0].outline[1] must be a list of 2 numbers");
  expectRefused(
      "/rooms/0/outline/1/1", "null",
      "rooms[0].outline[1][1] must be a number from -10000 to 10000, not null");
  expectRefused("/rooms/0/outline", "{\"square\": 1}",
                "rooms[0].outline must be a list of corners, a \"rectangle\" or a "
                "\"circle\"");
  expectRefused("/rooms/0/openings/0/wall", "4",
                "rooms[0].openings[0].wall must be a whole number from 0 to 3, not 4");
  expectRefused("/rooms/0/openings/0/wall", "-1",
                "rooms[0].openings[0].wall must be a whole number from 0 to 3, not -1");
  expectRefused("/rooms/0/openings/0/depth", "0",
                "rooms[0].openings[0].depth must be a number from 0.0001 to 10000, "
                "not 0");
  expectRefused(
      "/rooms/0/openings/1/leaf/hinge", "\"left\"",
      "rooms[0].openings[1].leaf.hinge must be \"from\" or \"to\", the end of "
      "the opening it hangs at");
  expectRefused("/rooms/0/openings/0/glazing/mirror_share", "0.95",
                "rooms[0].openings[0].glazing has shares of more than 1 together");
  expectRefused("/scanners/0/rays", "0.5",
                "scanners[0].rays must be a whole number from 1 to 100000000, not 0.5");
  expectRefused("/scanners/0/noise", "-1",
                "scanners[0].noise must be a number from 0 to 1, not -1");
}

TEST(SceneFileErrors, loopsThatAreNone)
{
  expectRefused("/rooms/0/outline/3/radius", "1",
                "rooms[0].outline[3].radius is 1, too small for an arc to a corner 4 m "
                "away");
  expectRefused("/rooms/0/outline/1", "[0, 0]",
                "rooms[0].outline[0] is the same point as the corner after it");
  expectRefused("/rooms/1/outline/rectangle", "[[9, 4], [5.1, 0]]",
                "rooms[1].outline.rectangle must give the corner of smaller x and y "
                "first");
  expectRefused("/rooms/0/outline", "[[0, 0], [0, 4], [5, 4], [5, 0]]",
                "rooms[0].outline does not run counter-clockwise");
}

TEST(SceneFileErrors, namesThatLeadNowhere)
{
  expectRefused("/rooms/1/name", "\"left\"",
                "rooms[1].name is that of another room, too");
  expectRefused("/rooms/0/openings/1/leads_to", "\"attic\"",
                "rooms[0].openings[1].leads_to is \"attic\", which is no room of the "
                "scene");
}

TEST(SceneFileErrors, detailsWithTwoHeightsOrNone)
{
  expectRefused("/rooms/0/ceiling_details/0/height", "2.5",
                "rooms[0].ceiling_details[0] must have either \"height\" or \"drop\"");
  expectRefused("/rooms/0/floor_details/0", "{\"loop\": [[0, 0], [1, 0], [1, 1]]}",
                "rooms[0].floor_details[0] must have either \"height\" or \"rise\"");
}

TEST(SceneFileErrors, objectsThatCannotBe)
{
  const auto refused = [](const char* object, const std::string& sentence) {
    expectRefused("/rooms/0/furniture/0", object, "rooms[0].furniture[0]" + sentence);
  };
  refused(R"({"sofa": {"at": [1, 1]}})",
          " is of unknown kind \"sofa\"; known are block, car, chair, cylinder, "
          "door_leaf, duct, fixture, group, lamp, object, shelf, stairs, table, "
          "tree");
  refused(R"({"stairs": {"at": [1, 1], "width": 1, "rise": 0.2, "going": 0.25}})",
          ".stairs lacks \"steps\"");
  refused(R"({"stairs": {"at": [1, 1], "width": 1, "rise": 0.2, "going": 0.25,
                         "steps": 5, "solid": 1}})",
          ".stairs.solid must be true or false, not 1");
  refused(R"({"stairs": {"at": [1, 1], "width": 1, "rise": 0.2, "going": 0.25,
                         "steps": 0}})",
          ".stairs.steps must be a whole number from 1 to 200, not 0");
  refused(R"({"chair": {}, "table": {}})",
          " must be an object with one key, the kind of thing it is");
  refused(R"({"chair": {"at": [1, 2], "colour": "red"}})",
          ".chair has an unknown key \"colour\"; known are \"at\", \"yaw\", \"raise\", "
          "\"wall\", \"s\", \"gap\", \"row\"");
  refused(R"({"chair": {"at": [1, 2], "wall": 1, "s": 1}})",
          ".chair has both \"wall\" and \"at\"");
  refused(R"({"chair": {"at": [1, 2], "row": {"count": 2, "gap": 0}}})",
          ".chair has \"row\" but no \"wall\"");
  refused(R"({"chair": {"at": [7, 2]}})", ".chair is not within its room");
  refused(R"({"lamp": {"at": [1, 1], "drop": 1, "radius": 0.1}})",
          ".lamp is not within its room"); // in a column
  refused(R"({"duct": {"from": [2, 1], "to": [2, 1], "radius": 0.1, "drop": 0}})",
          ".duct begins where it ends");
  refused(R"({"object": {"name": "nothing"}})",
          ".object has neither boxes nor cylinders");
  refused(R"({"block": {"at": [2, 2], "size": [1, 1, 9]}})",
          ".block: the block is above the ceiling at (1.5, 1.5)");
  refused(R"({"group": {"places": [[1, 1]], "objects": [{"chair": {"wall": 0}}]}})",
          ".group.objects[0].chair has an unknown key \"wall\"; known are \"at\", "
          "\"yaw\", \"raise\"");
  expectRefused("/outside/0/tree/raise", "1",
                "outside[0].tree has an unknown key \"raise\"; known are \"at\", "
                "\"yaw\", \"floor\", \"height\", \"crown\"");
  expectRefused("/outside/0", R"({"lamp": {}})",
                "outside[0] is of unknown kind \"lamp\"; known are block, car, chair, "
                "cylinder, group, object, shelf, table, tree");
}

TEST(SceneFileErrors, groupsThatGrowWithoutEnd)
{
  json objects = json::parse(R"([{"chair": {"at": [0, 0]}}])");
  json places = json::array();
  for (int i = 0; i < 60; ++i)
    places.push_back({0.4, 0.6});
  for (int depth = 0; depth < 3; ++depth)
    objects = {{{"group", {{"places", places}, {"objects", objects}}}}};
  json file = fullFile();
  file["rooms"][0]["furniture"] = objects;
  EXPECT_NE(messageOf(file.dump()).find("makes more than 200000 parts"),
            std::string::npos)
      << messageOf(file.dump());
  places = {{0.4, 0.6}};
  for (int depth = 0; depth < 3; ++depth)
    objects = {{{"group", {{"places", places}, {"objects", objects}}}}};
  file["rooms"][0]["furniture"] = objects;
  EXPECT_NE(messageOf(file.dump()).find("is a group too deep within groups"),
            std::string::npos);
}

TEST(SceneFileErrors, scenesThatCannotBeNameTheirPlace)
{
  expectRefused("/rooms/1/outline/rectangle", "[[4, 0], [9, 4]]",
                "rooms[1] overlaps room 'left' at (4, 0.001)");
  expectRefused("/rooms/0/openings/0/from", "0.7",
                "rooms[0].niches[0] overlaps rooms[0].openings[0]");
  expectRefused("/rooms/0/openings/1/sill", "0.1",
                "rooms[0].openings[1].sill is 0.1, below the floor of room 'left' at "
                "0.2");
  expectRefused("/rooms/1/floor", "0.3",
                "rooms[0].openings[1].sill is 0.2, below the floor of room 'right' at "
                "0.3");
  expectRefused("/rooms/0/openings/1/depth", "0.2",
                "rooms[0].openings[1] leads to room 'right', which has no wall there, "
                "0.2 m behind this one");
  expectRefused("/rooms/0/openings/0/to", "5.5",
                "rooms[0].openings[0] does not lie within its wall");
  expectRefused("/scanners/0/stations/0", "[20, 2, 1.5]",
                "scanners[0]: station 0 at (20, 2, 1.5) is in no room");
  expectRefused("/scanners/0/walk", "{}",
                "scanners[0] must have either \"stations\" or a \"walk\"");
}

TEST(SceneFileErrors, filesThatCannotBeRead)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "folder.json");
  for (const char* name : {"none.json", "folder.json"}) {
    const std::string path = (folder.path() / name).string();
    try {
      sceneNamed(path);
      ADD_FAILURE() << path;
    }
    catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()), "Cannot read the scene file " + path);
    }
  }
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

TEST(SceneFileErrors, anyValueAnywhereGivesASceneOrOneSentence)
{
  std::vector<json::json_pointer> pointers;
  collectPointers(fullFile(), json::json_pointer(), pointers);
  ASSERT_GT(pointers.size(), 150U);
  const json odd[] = {nullptr, -1, 0.37, 1e300, "x", json::array(), json::object()};
  for (const auto& pointer : pointers)
    for (const json& value : odd) {
      json file = fullFile();
      file[pointer] = value;
      const std::string message = messageOf(file.dump());
      if (!message.empty()) {
        EXPECT_EQ(message.rfind("test.json: ", 0), 0U) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      }
    }
}

} // namespace
} // namespace pcl::sedr::sim::test
