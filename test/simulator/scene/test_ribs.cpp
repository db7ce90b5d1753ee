// SPDX-License-Identifier: BSD-3-Clause
#include "scene_text.h"
#include "simulator/check/scene_check.h"
#include "simulator/scan/scan.h"
#include "simulator/scene/ribs.h"
#include "simulator/truth/room_truth.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace pcl::sedr::sim::test {
namespace {

double
areaOfAll(const std::vector<Loop>& loops)
{
  double area = 0.0;
  for (const Loop& loop : loops)
    area += areaOf(loop);
  return area;
}

TEST(Ribs, runFromWallToWall)
{
  const auto loops =
      ribLoops(rectangleLoop({0, 0}, {5, 4}), {{0.0, 1.0, 0.2, 0.3}}).at(0);
  ASSERT_EQ(loops.size(), 4U);
  for (const Loop& loop : loops)
    EXPECT_NEAR(areaOf(loop), 5.0 * 0.2, 1e-9);
  EXPECT_NEAR(boundsOf(loops[0]).min.y, 0.4, 1e-9);
  EXPECT_NEAR(boundsOf(loops[3]).max.y, 3.6, 1e-9);
}

TEST(Ribs, beginWhereTheyAreToldTo)
{
  const auto loops =
      ribLoops(rectangleLoop({0, 0}, {5, 4}), {{0.0, 1.0, 0.2, 0.3, 0.05}}).at(0);
  ASSERT_EQ(loops.size(), 3U); // the first would extend through the wall
  EXPECT_NEAR(boundsOf(loops[0]).min.y, 0.95, 1e-9);
}

TEST(Ribs, endAtBeams)
{
  const auto loops = ribLoops(rectangleLoop({0, 0}, {6, 4}),
                              {{0.0, 1.0, 0.2, 0.2}, {0.5 * pi, 3.0, 0.4, 0.4}});
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_EQ(loops[1].size(), 2U);
  EXPECT_EQ(loops[0].size(), 4U * 3U);
  EXPECT_NEAR(areaOfAll(loops[1]), 2 * 0.4 * 4.0, 1e-9);
  EXPECT_NEAR(areaOfAll(loops[0]), 4 * 0.2 * (6.0 - 0.8), 1e-9);
}

TEST(Ribs, areCutAtTheWallsOfAnL)
{
  const Loop outline{{{0, 0}}, {{6, 0}}, {{6, 2.05}}, {{3, 2.05}}, {{3, 4}}, {{0, 4}}};
  const auto loops = ribLoops(outline, {{0.0, 1.0, 0.2, 0.3, 1.0}}).at(0);
  // At 1: 6 m; at 2: 6 m up to the corner inside the rib, and 3 m beyond it.
  EXPECT_NEAR(areaOfAll(loops), 0.2 * 6.0 + 0.15 * 6.0 + 0.05 * 3.0 + 0.2 * 3.0, 1e-9);
}

TEST(Ribs, mayRunAskew)
{
  const Loop outline = rectangleLoop({0, 0}, {4, 4});
  const double side = 4.0;
  const auto loops = ribLoops(outline, {{0.25 * pi, 0.5, 0.1, 0.3}}).at(0);
  double length = 0.0; // of the middles of all ribs within the square
  for (double u = -side / std::sqrt(2.0) + 0.25; u < side / std::sqrt(2.0); u += 0.5)
    length += 2.0 * (side / std::sqrt(2.0) - std::abs(u));
  EXPECT_NEAR(areaOfAll(loops), 0.1 * length, 0.02);
}

json
ribbedFile()
{
  json file = minimalFile();
  file["rooms"][0]["ribs"] = json::parse(
      R"([{"direction": 0, "spacing": 0.5, "width": 0.1, "depth": 0.3},
          {"direction": 90, "spacing": 2.5, "width": 0.3, "depth": 0.5}])");
  return file;
}

TEST(Ribs, areDetailsOfTheTruthAndOfTheScan)
{
  json file = ribbedFile();
  file["scanners"][0]["rays"] = 20000;
  file["scanners"][0]["noise"] = 0;
  const Scene scene = read(file);
  const auto truth = roomTruths(scene).at(0);
  EXPECT_NEAR(truth.volume, 60.0 - 2 * 0.3 * 4 * 0.5 - 8 * 0.1 * (5 - 0.6) * 0.3, 1e-9);
  EXPECT_NEAR(truth.ceiling, 3.0, 1e-12);
  std::size_t undersides = 0;
  std::size_t between = 0;
  for (const ScanPoint& point : scan(scene, {}).points) {
    const auto label = static_cast<Label>(point.label);
    if (label == Label::Detail &&
        (std::abs(point.z - 2.7) < 1e-4 || std::abs(point.z - 2.5) < 1e-4))
      ++undersides;
    if (label == Label::Ceiling) {
      EXPECT_NEAR(point.z, 3.0, 1e-4);
      ++between;
      for (const SlabDetail& rib : scene.rooms[0].details)
        EXPECT_FALSE(contains(rib.loop, {point.x, point.y}));
    }
  }
  EXPECT_GT(undersides, 1000U);
  EXPECT_GT(between, 1000U);
}

TEST(Ribs, areRefusedWithASentence)
{
  const auto refusal = [](const char* pointer, const char* value) -> std::string {
    json file = ribbedFile();
    file[json::json_pointer(pointer)] = json::parse(value);
    try {
      read(file);
      return {};
    }
    catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  EXPECT_EQ(
      refusal("/rooms/0/ribs/0/width", "0.5"),
      "test.json: rooms[0].ribs[0].width is not less than the spacing of the ribs");
  EXPECT_EQ(refusal("/rooms/0/ribs/0/spacing", "0"),
            "test.json: rooms[0].ribs[0].spacing must be a number from 0.01 to 10000, "
            "not 0");
  EXPECT_EQ(refusal("/rooms/0/ribs/1/depth", "\"deep\""),
            "test.json: rooms[0].ribs[1].depth must be a number from 0.0001 to 10000, "
            "not \"deep\"");
  EXPECT_EQ(refusal("/rooms/0/ribs/0/drop", "1"),
            "test.json: rooms[0].ribs[0] has an unknown key \"drop\"; known are "
            "\"direction\", \"spacing\", \"width\", \"depth\", \"first\"");
  EXPECT_EQ(refusal("/rooms/0/outline/1", R"({"at": [5, 0], "radius": 6})"),
            "test.json: rooms[0].ribs[0] needs a room with straight walls");
  EXPECT_NE(refusal("/rooms/0/ribs/1/depth", "3.5").find("rooms[0] has no height"),
            std::string::npos);
}

} // namespace
} // namespace pcl::sedr::sim::test
