// SPDX-License-Identifier: BSD-3-Clause
// truth.json against closed forms.
#include "sample_scenes.h"
#include "simulator/mesh/scene_mesh.h"
#include "simulator/truth/truth.h"

#include <gtest/gtest.h>

namespace pcl::sedr::sim::test {
namespace {

json
truthJsonOf(const json& file)
{
  const Scene scene = read(file);
  return json::parse(truthToJson(scene, truthOf(meshOf(scene))));
}

TEST(Truth, ofARoomHasItsMeasuresInTheFrameOfTheFiles)
{
  const json truth = truthJsonOf(with(boxFile(), R"({
      "/rooms/0/outline/1": {"at": [5, 0], "bulge": 1}, "/rooms/0/floor": 0.5,
      "/rooms/0/columns": [{"rectangle": [[1, 1], [1.5, 2]]}],
      "/rooms/0/ceiling_details": [{"loop": {"rectangle": [[2, 1], [4, 3]]}, "drop": 0.5}],
      "/scanners/0/stations": [[3, 3.5, 1.5]],
      "/placement": {"yaw": 90, "shift": [10, 20, -1]}})"));
  const json& room = truth["rooms"].at(0);
  EXPECT_EQ(truth["format"], "sedr-room-truth");
  EXPECT_EQ(room["id"], 1);
  EXPECT_EQ(room["name"], "box");
  EXPECT_NEAR(room["area"], 19.5 + 2 * pi, 1e-9);
  EXPECT_NEAR(room["perimeter"], 14 + 2 * pi, 1e-9);
  EXPECT_NEAR(room["column_perimeter"], 3, 1e-9);
  const double volume = (19.5 + 2 * pi) * 2.5 - 4 * 0.5;
  EXPECT_NEAR(room["volume"], volume, 2e-3);
  EXPECT_NEAR(room["height"], volume / (19.5 + 2 * pi), 1e-4);
  EXPECT_NEAR(room["floor"], -0.5, 1e-9);
  EXPECT_NEAR(room["ceiling"], 2, 1e-9);
  const json& arc = room["boundary"].at(1);
  EXPECT_EQ(arc["type"], "arc");
  EXPECT_NEAR(arc["centre"][0], 8, 1e-9);
  EXPECT_NEAR(arc["centre"][1], 25, 1e-9);
  EXPECT_NEAR(arc["radius"], 2, 1e-9);
  EXPECT_EQ(arc["counter_clockwise"], true);
}

TEST(Truth, ofTiltedWallsIsTheOutlineAtTheFloor)
{
  const json room = truthJsonOf(with(
      boxFile(), R"({"/rooms/0/tilts": [{"wall": 1, "tilt": -10}]})"))["rooms"]
                        .at(0);
  EXPECT_EQ(room["boundary"].size(), 4U);
  EXPECT_NEAR(room["area"], 20, 1e-9);
  EXPECT_NEAR(room["boundary"][1]["tilt"], -10, 1e-9);
  EXPECT_FALSE(room["boundary"][0].contains("tilt"));
}

TEST(Truth, countsStoreysByTheHeightsOfTheirFloors)
{
  const auto storeys = [](const std::string& changes) {
    std::vector<int> numbers;
    const json truth = truthJsonOf(with(twoStoreyFile(), changes));
    for (const json& room : truth["rooms"])
      numbers.push_back(room["storey"]);
    return numbers;
  };
  EXPECT_EQ(storeys("{}"), (std::vector<int>{1, 2, 1}));
  EXPECT_EQ(storeys(R"({"/rooms/0/storey": 1, "/rooms/1/storey": 3})"),
            (std::vector<int>{1, 3, 1}));
  const json truth = truthJsonOf(twoStoreyFile());
  ASSERT_EQ(truth["storeys"].size(), 2U);
  EXPECT_EQ(truth["storeys"][0]["rooms"], json::parse("[1, 3]"));
  EXPECT_NEAR(truth["storeys"][1]["floor"], 2.9, 1e-9);
  EXPECT_NEAR(truth["storeys"][1]["ceiling"], 5.4, 1e-9);
  EXPECT_EQ(truth["rooms"][0]["voids"].size(), 1U);
  EXPECT_EQ(truth["rooms"][1]["floor_voids"].at(0).size(), 4U);
}

TEST(Truth, linksSayWhatJoinsWhichRooms)
{
  const json links = truthJsonOf(with(
      twoStoreyFile(), R"({"/placement": {"yaw": 90, "shift": [0, 0, 10]}})"))["links"];
  ASSERT_EQ(links.size(), 3U);
  EXPECT_EQ(links[0]["kind"], "door");
  EXPECT_EQ(links[0]["rooms"], json::parse("[1, 3]"));
  EXPECT_NEAR(links[0]["lintel"], 0.5, 1e-9);
  EXPECT_NEAR(links[0]["bottom"], 10, 1e-9);
  EXPECT_NEAR(links[0]["top"], 12.1, 1e-9);
  EXPECT_NEAR(links[0]["start"][1], 6, 1e-9);
  EXPECT_EQ(links[0]["shut"], false);
  EXPECT_EQ(links[1]["kind"], "stairs");
  EXPECT_EQ(links[1]["rooms"], json::parse("[1, 2]"));
  EXPECT_NEAR(links[1]["bottom"], 12.6, 1e-9);
  EXPECT_NEAR(links[1]["top"], 12.9, 1e-9);
  EXPECT_EQ(links[1]["loop"].size(), 4U);
  EXPECT_EQ(links[2]["kind"], "window"); // a gallery's parapet
  const json changed = truthJsonOf(with(twoStoreyFile(), R"({"/rooms/0/furniture": [],
                                "/rooms/0/openings/0/to": 3})"))["links"];
  EXPECT_EQ(changed[0]["kind"], "passage");
  EXPECT_EQ(changed[1]["kind"], "void");
}

TEST(Truth, openingsHaveTheirPlaceAndTheirLeaf)
{
  const auto opening = [](const std::string& changes) -> json {
    const json file =
        with(with(boxFile(), R"({"/rooms/0/openings": [{"wall": 1, "from": 1, "to": 1.9,
                             "head": 2.05, "depth": 0.15}]})"),
             changes);
    return truthJsonOf(file)["openings"].at(0);
  };
  const json door =
      opening(R"({"/rooms/0/openings/0/leaf": {"hinge": "from", "angle": 90}})");
  EXPECT_EQ(door["kind"], "door");
  EXPECT_EQ(door["rooms"], json::parse("[1, 0]"));
  EXPECT_NEAR(door["start"][1], 1, 1e-9);
  EXPECT_NEAR(door["end"][1], 1.9, 1e-9);
  EXPECT_NEAR(door["depth"], 0.15, 1e-9);
  EXPECT_EQ(door["leaf"]["hinge"], "start");
  EXPECT_EQ(door["leaf"]["swing"], 1);
  EXPECT_NEAR(door["leaf"]["angle"], 90, 1e-9);
  EXPECT_EQ(door["leaf"]["state"], "open");
  const json ajar =
      opening(R"({"/rooms/0/openings/0/leaf": {"hinge": "to", "angle": 20}})");
  EXPECT_EQ(ajar["leaf"]["state"], "ajar");
  EXPECT_EQ(ajar["leaf"]["hinge"], "end");
  const json shut =
      opening(R"({"/rooms/0/openings/0/leaf": {"hinge": "to", "angle": 0}})");
  EXPECT_EQ(shut["leaf"]["state"], "closed");
  EXPECT_EQ(shut["shut"], true);
  const json window = opening(
      R"({"/rooms/0/openings/0/sill": 0.9, "/rooms/0/openings/0/glazing": {}})");
  EXPECT_EQ(window["kind"], "window");
  EXPECT_EQ(window["glazed"], true);
  EXPECT_FALSE(window.contains("leaf"));
  const json wide = opening(R"({"/rooms/0/openings/0/to": 2.6,
      "/rooms/0/openings/0/rise": 0.4, "/rooms/0/openings/0/blind": 0.5,
      "/rooms/0/openings/0/leaf": {"hinge": "both", "angle": 45}})");
  EXPECT_EQ(wide["kind"], "door") << "what has leaves is no passage";
  EXPECT_EQ(wide["leaf"]["hinge"], "both");
  EXPECT_NEAR(wide["rise"], 0.4, 1e-9);
  EXPECT_NEAR(wide["blind"], 0.5, 1e-9);
}

} // namespace
} // namespace pcl::sedr::sim::test
