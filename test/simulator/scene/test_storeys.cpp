// SPDX-License-Identifier: BSD-3-Clause
#include "simulator/check/scene_check.h"
#include "simulator/scan/scan.h"
#include "simulator/scan/scene_surfaces.h"
#include "simulator/scene/storeys.h"
#include "simulator/truth/mesh_measures.h"
#include "simulator/truth/room_links.h"
#include "simulator/truth/room_truth.h"
#include "simulator/two_storeys.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace pcl::sedr::sim::test {
namespace {

Scene
twoStoreys()
{
  return read(twoStoreyFile());
}

/** @brief Returns the error of the file after a value at a JSON pointer is changed. */
std::string
refusalOf(const std::string& pointer, const char* value)
{
  json file = twoStoreyFile();
  file[json::json_pointer(pointer)] = json::parse(value);
  try {
    read(file);
    return {};
  }
  catch (const std::invalid_argument& error) {
    return error.what();
  }
}

/** @brief Counts the points of a label of room @p room within a box. */
std::size_t
countWithin(const Scan& scan, std::uint32_t room, Label label, Vec3 low, Vec3 high)
{
  std::size_t count = 0;
  for (const ScanPoint& p : scan.points)
    count += p.room == room && p.label == static_cast<std::uint32_t>(label) &&
             p.x > low.x && p.x < high.x && p.y > low.y && p.y < high.y &&
             p.z > low.z && p.z < high.z;
  return count;
}

TEST(Storeys, areCountedByTheHeightsOfTheFloors)
{
  Scene scene = twoStoreys();
  EXPECT_EQ(storeysOf(scene), (std::vector<std::size_t>{1, 2, 1}));
  scene.rooms[2].floor.height = 1.6; // higher than a landing above the lowest
  EXPECT_EQ(storeysOf(scene), (std::vector<std::size_t>{1, 2, 2}));
  scene.rooms[2].storey = 1;
  scene.rooms[0].storey = 1;
  scene.rooms[1].storey = 3;
  EXPECT_EQ(storeysOf(scene), (std::vector<std::size_t>{1, 3, 1}));
  scene.rooms[0].storey.reset(); // takes the hall's, whose floor is 1.6 m higher
  EXPECT_EQ(storeysOf(scene), (std::vector<std::size_t>{1, 3, 1}));
}

TEST(Storeys, roomsMayLieAboveEachOtherButNotInEachOther)
{
  EXPECT_TRUE(problemsOf(twoStoreys()).empty());
  EXPECT_EQ(refusalOf("/rooms/1/floor", "2.6"), ""); // the slabs touch
  EXPECT_NE(refusalOf("/rooms/1/floor", "2.5").find("rooms[1] overlaps room 'below'"),
            std::string::npos);
  // A detail in the middle of a room is checked as its outline is.
  EXPECT_NE(refusalOf("/rooms/0/ceiling_details",
                      R"([{"loop": {"rectangle": [[2, 1], [3, 2]]}, "drop": -0.4}])")
                .find("rooms[1] overlaps room 'below'"),
            std::string::npos);
  EXPECT_NE(refusalOf("/rooms/0/plenum", "0.4").find("overlaps"), std::string::npos);
  EXPECT_EQ(refusalOf("/rooms/0/plenum", "0.2"), "");
}

TEST(Storeys, aRoomIsFoundByItsHeight)
{
  const Scene scene = twoStoreys();
  EXPECT_EQ(roomAt(scene, {3.0, 2.0, 1.0}), 1U);
  EXPECT_EQ(roomAt(scene, {3.0, 2.0, 4.0}), 2U);
  EXPECT_EQ(roomAt(scene, {3.0, 2.0, 2.7}), 1U); // in the slab: the nearer one
  EXPECT_EQ(roomAt(scene, {3.0, 2.0, 2.8}), 2U);
  EXPECT_EQ(roomAt(scene, {8.0, 2.0, 9.0}), 3U);
  EXPECT_EQ(roomAt(scene, {12.0, 2.0, 1.0}), 0U);
}

TEST(Storeys, aWalkTakesTheLowestFloorUnlessItSaysWhich)
{
  json file = twoStoreyFile();
  file["scanners"] = json::parse(R"([{"walk": {"path": [[1, 1], [4, 1]], "count": 2,
      "height": 1.5}, "rays": 100, "noise": 0}])");
  EXPECT_NEAR(read(file).scanners[0].stations[1].z, 1.5, 1e-12);
  file["scanners"][0]["walk"]["floor"] = 3;
  EXPECT_NEAR(read(file).scanners[0].stations[1].z, 4.4, 1e-12);
}

TEST(Storeys, furnitureStandsOnTheFloorOfItsOwnRoom)
{
  json file = twoStoreyFile();
  file["rooms"][1]["furniture"] =
      json::parse(R"([{"block": {"at": [2, 2], "size": [1, 1, 1]}}])");
  const Scene scene = read(file);
  EXPECT_NEAR(scene.furniture.back().boxes[0].center.z, 3.4, 1e-12);
  file["rooms"][1]["furniture"][0]["block"]["size"][2] = 2.7;
  EXPECT_THROW(read(file), std::invalid_argument);
}

TEST(Voids, showTheRoomAbove)
{
  const Scan seen = scan(twoStoreys(), {});
  const Vec3 low{1.0, 3.6, 2.55};
  const Vec3 high{4.5, 4.8, 2.65};
  EXPECT_EQ(countWithin(seen, 1, Label::Ceiling, low, high), 0U);
  EXPECT_GT(countWithin(seen, 2, Label::Wall, {0, 4.9, 2.9}, {6, 5.1, 5.4}), 50U);
  EXPECT_GT(countWithin(seen, 0, Label::Other, {0.99, 3.5, 2.6}, {4.6, 4.9, 2.9}), 20U);
  json closed = twoStoreyFile();
  closed["rooms"][0].erase("voids");
  closed["rooms"][0].erase("furniture");
  const Scan shut = scan(read(closed), {});
  EXPECT_GT(countWithin(shut, 1, Label::Ceiling, low, high), 100U);
  EXPECT_EQ(countWithin(shut, 2, Label::Wall, {0, 4.9, 2.9}, {6, 5.1, 5.4}), 0U);
}

TEST(Voids, cutTheFloorAbove)
{
  json file = twoStoreyFile();
  file["rooms"][0].erase("furniture");
  file["scanners"][0]["stations"] = json::parse("[[3, 2, 4.4]]");
  const Scan seen = scan(read(file), {});
  EXPECT_EQ(countWithin(seen, 2, Label::Floor, {1.0, 3.6, 2.85}, {4.5, 4.8, 2.95}), 0U);
  EXPECT_GT(countWithin(seen, 2, Label::Floor, {0, 0, 2.85}, {6, 3.5, 2.95}), 500U);
  EXPECT_GT(countWithin(seen, 1, Label::Wall, {0, 4.9, 0}, {6, 5.1, 2.6}), 20U);
}

TEST(Voids, leaveTheTruthOfTheirRoomsClosed)
{
  const Scene scene = twoStoreys();
  const Mesh mesh = truthMesh(scene);
  EXPECT_TRUE(isClosedManifold(mesh));
  const auto rooms = roomTruths(scene, mesh);
  EXPECT_NEAR(rooms[0].volume, 78.0, 1e-9);
  EXPECT_NEAR(rooms[1].volume, 75.0, 1e-9);
}

TEST(Voids, areRefusedWhereTheyCannotBe)
{
  const std::string loop = "/rooms/0/voids/0/loop";
  EXPECT_EQ(refusalOf(loop, R"({"rectangle": [[4, 3.6], [7, 4.8]]})")
                .rfind("test.json: rooms[0].voids[0] reaches out of room 'below'", 0),
            0U);
  EXPECT_EQ(refusalOf("/rooms/1/outline", R"({"rectangle": [[2, 0], [6, 5]]})")
                .rfind("test.json: rooms[0].voids[0] reaches out of room 'above'", 0),
            0U);
  EXPECT_EQ(refusalOf("/rooms/0/ceiling_details",
                      R"([{"loop": {"rectangle": [[0, 0], [2, 5]]}, "drop": 0.3}])")
                .rfind("test.json: rooms[0].voids[0] reaches over a detail's edge", 0),
            0U);
  EXPECT_EQ(refusalOf("/rooms/0/columns", R"([{"circle": [2, 4.2], "radius": 0.2}])")
                .rfind("test.json: rooms[0].voids[0] holds a column", 0),
            0U);
  EXPECT_NE(refusalOf("/rooms/0/voids/0/leads_to", "\"hall\"")
                .find("reaches out of room 'hall'"),
            std::string::npos);
  EXPECT_NE(refusalOf("/rooms/0/voids/0/leads_to", "\"below\"")
                .find("leads to room 'below', which is not above it"),
            std::string::npos);
  EXPECT_EQ(refusalOf("/rooms/0/voids/0/leads_to", "\"attic\""),
            "test.json: rooms[0].voids[0].leads_to is \"attic\", which is no room of "
            "the scene");
  EXPECT_EQ(
      refusalOf("/rooms/0/voids/0", R"({"loop": {"rectangle": [[1, 1], [2, 2]]}})")
          .rfind("test.json: rooms[0].voids[0] leads to no room, and its room has "
                 "no plenum",
                 0),
      0U);
  EXPECT_EQ(
      refusalOf("/rooms/0/voids/1",
                R"({"loop": {"rectangle": [[0.5, 3], [2, 4]]}, "leads_to": "above"})")
          .rfind("test.json: rooms[0].voids[1] overlaps rooms[0].voids[0]", 0),
      0U);
}

TEST(Plenums, areSeenThroughMissingTilesOnly)
{
  json file = minimalFile();
  file["rooms"][0]["plenum"] = 0.4;
  file["rooms"][0]["voids"] =
      json::parse(R"([{"loop": {"rectangle": [[2, 2.6], [2.6, 3.2]]}}])");
  file["scanners"][0]["rays"] = 50000;
  file["scanners"][0]["noise"] = 0;
  const Scan seen = scan(read(file), {});
  EXPECT_EQ(countWithin(seen, 1, Label::Ceiling, {2, 2.6, 2.9}, {2.6, 3.2, 3.1}), 0U);
  EXPECT_GT(countWithin(seen, 0, Label::Other, {0, 0, 3.39}, {5, 4, 3.41}), 100U);
  for (const ScanPoint& point : seen.points)
    EXPECT_LT(point.z, 3.4001F);
  const auto rooms = roomTruths(read(file));
  EXPECT_NEAR(rooms[0].volume, 60.0, 1e-9);
  EXPECT_TRUE(rooms[0].voids.empty()); // the void leads to no room
}

TEST(RoomLinks, sayWhatJoinsWhich)
{
  json file = twoStoreyFile();
  file["placement"] = json::parse(R"({"yaw": 90, "shift": [0, 0, 10]})");
  const auto links = roomLinks(read(file));
  ASSERT_EQ(links.size(), 3U);
  EXPECT_EQ(links[0].kind, "door");
  EXPECT_EQ(links[0].from, 1U);
  EXPECT_EQ(links[0].to, 3U);
  EXPECT_NEAR(links[0].lintel, 0.5, 1e-12);
  EXPECT_NEAR(links[0].width, 0.9, 1e-12);
  EXPECT_NEAR(links[0].bottom, 10.0, 1e-12);
  EXPECT_NEAR(links[0].start.y, 6.0, 1e-12);
  EXPECT_EQ(links[1].kind, "stairs");
  EXPECT_EQ(links[1].to, 2U);
  EXPECT_NEAR(links[1].bottom, 12.6, 1e-12);
  EXPECT_NEAR(links[1].top, 12.9, 1e-12);
  EXPECT_EQ(links[2].kind, "window"); // a gallery's parapet
  EXPECT_EQ(links[2].from, 2U);
  file["rooms"][0].erase("furniture");
  EXPECT_EQ(roomLinks(read(file))[1].kind, "void");
  file["rooms"][0]["openings"][0]["to"] = 3;
  EXPECT_EQ(roomLinks(read(file))[0].kind, "passage");
}

TEST(RoomLinks, doorsAreShutByALeafOrAPane)
{
  json file = twoStoreyFile();
  EXPECT_FALSE(roomLinks(read(file))[0].is_shut);
  auto& door = file["rooms"][0]["openings"][0];
  door["leaf"] = json::parse(R"({"hinge": "from", "angle": 90})");
  EXPECT_FALSE(roomLinks(read(file))[0].is_shut);
  door["leaf"]["angle"] = 0;
  EXPECT_TRUE(roomLinks(read(file))[0].is_shut);
  door.erase("leaf");
  door["glazing"] = json::object();
  EXPECT_TRUE(roomLinks(read(file))[0].is_shut);
}

TEST(RoomTruth, knowsHeightsAndStoreys)
{
  json file = twoStoreyFile();
  file["placement"] = json::parse(R"({"shift": [0, 0, 10]})");
  // 45 degrees over a depth of 6 m: 3 m at the middle above the wall's 5.4.
  file["rooms"][2]["ceiling"] =
      json::parse(R"({"height": 5.4, "slope": 45, "towards": 0, "at": [6.2, 0]})");
  const Scene scene = read(file);
  const auto written =
      json::parse(roomTruthsToJson("stacked", roomTruths(scene), roomLinks(scene)));
  const auto& rooms = written["rooms"];
  EXPECT_NEAR(rooms[1]["floor"].get<double>(), 12.9, 1e-9);
  EXPECT_NEAR(rooms[1]["ceiling"].get<double>(), 15.4, 1e-9);
  EXPECT_NEAR(rooms[2]["ceiling"].get<double>(), 17.4, 1e-9);
  EXPECT_EQ(rooms[1]["storey"], 2);
  EXPECT_EQ(rooms[0]["voids"].size(), 1U);
  EXPECT_EQ(rooms[0]["floor_voids"].size(), 0U);
  EXPECT_EQ(rooms[1]["floor_voids"].at(0).size(), 4U);
  ASSERT_EQ(written["storeys"].size(), 2U);
  EXPECT_EQ(written["storeys"][0]["number"], 1);
  EXPECT_EQ(written["storeys"][0]["rooms"], json::parse("[1, 3]"));
  EXPECT_NEAR(written["storeys"][1]["floor"].get<double>(), 12.9, 1e-9);
  EXPECT_NEAR(written["storeys"][1]["ceiling"].get<double>(), 15.4, 1e-9);
  ASSERT_EQ(written["links"].size(), 3U);
  EXPECT_EQ(written["links"][0]["kind"], "door");
  EXPECT_EQ(written["links"][0]["rooms"], json::parse("[1, 3]"));
  EXPECT_EQ(written["links"][0]["shut"], false);
  EXPECT_NEAR(written["links"][0]["top"].get<double>(), 12.1, 1e-9);
  EXPECT_NEAR(written["links"][0]["lintel"].get<double>(), 0.5, 1e-9);
  EXPECT_EQ(written["links"][0]["start"].size(), 2U);
  EXPECT_EQ(written["links"][1]["loop"].size(), 4U);
}

TEST(Storeys, numbersAreWholeAndFromOne)
{
  EXPECT_EQ(refusalOf("/rooms/0/storey", "0"),
            "test.json: rooms[0].storey must be a whole number from 1 to 200, not 0");
  EXPECT_EQ(refusalOf("/rooms/0/storey", "2"), "");
  EXPECT_EQ(refusalOf("/rooms/0/plenum", "0"),
            "test.json: rooms[0].plenum must be a number from 0.0001 to 10000, not 0");
}

} // namespace
} // namespace pcl::sedr::sim::test
