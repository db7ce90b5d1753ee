// SPDX-License-Identifier: BSD-3-Clause
#include "labelling_tools.h"
#include "rooms/building_file.h"
#include "tool_error.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace {

using namespace programs;
using pcl::sedr::tools::buildingToJson;
using pcl::sedr::tools::loadBuilding;
using pcl::sedr::tools::loadCloud;
using pcl::sedr::tools::ToolCloud;
using pcl::sedr::tools::ToolError;

INSTANTIATE_TEST_SUITE_P(RoomSegmentation,
                         ToolContract,
                         ::testing::Values(Tool(ROOM_SEGMENTATION)));

using RoomSegmentationTool = LabellingTools;

/** A room of 12 m2, and one of 9 m2 above it. */
RoomScan
twoStoreys()
{
  RoomScan scan = scanOf();
  BoxRoom upper;
  upper.width = 3;
  scan.addRaised(scanOf(upper), 2.8, 1);
  return scan;
}

TEST_F(RoomSegmentationTool, WritesTheBuildingAndLabelsCeilingsAndFloorsByRoom)
{
  const RoomScan scan = twoStoreys();
  const ProgramRun result = runOn(ROOM_SEGMENTATION, scan.pcd(false), "output.pcd",
                                  {"--building", in("building.json")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const ToolCloud cloud = loadCloud(in("output.pcd"));
  expectIntensity(cloud);
  EXPECT_GT(share(scan, cloud, Label::Ceiling, Label::Ceiling), 0.9);
  EXPECT_GT(share(scan, cloud, Label::Floor, Label::Floor), 0.85);
  // Where an upper floor was hidden, its air may end at the ceiling below.
  EXPECT_LT(share(scan, cloud, Label::Ceiling, Label::Floor), 0.02);
  std::size_t labelled = 0;
  std::size_t elsewhere = 0; // where an upper floor was hidden
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    ASSERT_EQ(cloud.room[i] != 0, cloud.label[i] != 0);
    labelled += cloud.label[i] != 0 ? 1 : 0;
    elsewhere +=
        cloud.label[i] != 0 && cloud.room[i] != (scan.points[i].z > 2.65 ? 2u : 1u) ? 1
                                                                                    : 0;
  }
  EXPECT_LT(elsewhere, labelled / 20) << "rooms by their storeys";

  const auto json = nlohmann::json::parse(bytesOf(in("building.json")));
  EXPECT_EQ(json.at("format"), "sedr-building");
  ASSERT_EQ(json.at("storeys").size(), 2u);
  const pcl::sedr::Building building = loadBuilding(in("building.json"));
  ASSERT_EQ(building.rooms.size(), 2u);
  EXPECT_NEAR(building.rooms[1].floor, 2.8, 0.1);
  EXPECT_NEAR(building.rooms[1].ceiling, 5.3, 0.1);
  EXPECT_GE(std::count(result.out.begin(), result.out.end(), '\n'), 3)
      << "a heading and a line a room:\n"
      << result.out;
}

TEST_F(RoomSegmentationTool, TakesItsOptions)
{
  const std::string scan = scanOf().pcd(false);
  const auto segment = [&](const Strings& options) {
    std::filesystem::remove(in("output.pcd"));
    return runOn(ROOM_SEGMENTATION, scan, "output.pcd", options);
  };
  expectNothingFound(segment({"--min-area", "50"}), "50.0 square metres");
  EXPECT_EQ(segment({"--building", in("building.txt")}).exit_code, 1);
}

TEST_F(RoomSegmentationTool, ABuildingReadsBackWithItsLinks)
{
  pcl::sedr::Building building;
  building.links = {{{1, 2}, {4.1, 1.0 / 3}, {4.1, 1.2}, 0.01, 2.05}};
  const std::string text = buildingToJson(building);
  writeFile(in("building.json"), text);
  const pcl::sedr::Building read = loadBuilding(in("building.json"));
  ASSERT_EQ(read.links.size(), 1u);
  EXPECT_EQ(read.links[0].rooms, building.links[0].rooms);
  EXPECT_EQ(buildingToJson(read), text);
}

TEST_F(RoomSegmentationTool, OnlyABuildingIsReadAsOne)
{
  for (const char* text : {"", "{}", "[1]", R"({"format": "sedr-planes"})",
                           R"({"format": "sedr-building", "version": 3})"}) {
    writeFile(in("building.json"), text);
    EXPECT_THROW(loadBuilding(in("building.json")), ToolError) << text;
  }
  EXPECT_THROW(loadBuilding(in("missing.json")), ToolError);
}

} // namespace
