// SPDX-License-Identifier: BSD-3-Clause
#include "tool_cloud.h"
#include "tools/tool_contract.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace {

using namespace programs;
using pcl::sedr::tools::floatField;
using pcl::sedr::tools::loadCloud;
using pcl::sedr::tools::ToolCloud;
using Strings = std::vector<std::string>;

INSTANTIATE_TEST_SUITE_P(SegmentationTools,
                         ToolContract,
                         ::testing::Values(Tool(HORIZONTAL_PLANE_DETECTION),
                                           Tool(GRID_SLICE_DETAIL),
                                           Tool(FLOORPLAN_FITTING, "output.json")));

class SegmentationTools : public ::testing::Test {
protected:
  std::string in(const std::string& name) const
  {
    return (folder_.path() / name).string();
  }

  ProgramRun runOn(const std::string& tool,
                   const std::string& bytes,
                   const std::string& output,
                   const Strings& options = {})
  {
    writeFile(in("input.pcd"), bytes);
    Strings arguments{in("input.pcd"), in(output)};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run(tool, arguments);
  }

  /** Exit code 2, one sentence that holds `words`, and no output. */
  void expectNothingFound(const ProgramRun& result, const std::string& words) const
  {
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_TRUE(result.failsInOneSentence()) << result.out << result.err;
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(in("output.pcd")));
    EXPECT_FALSE(std::filesystem::exists(in("output.json")));
  }

  /** Share of the points that were `truth` and are `found` now. */
  static double
  share(const RoomScan& scan, const ToolCloud& cloud, Label truth, Label found)
  {
    std::size_t all = 0;
    std::size_t right = 0;
    for (std::size_t i = 0; i < scan.points.size(); ++i)
      if (scan.points[i].label == truth) {
        ++all;
        right += cloud.label[i] == static_cast<std::uint32_t>(found) ? 1 : 0;
      }
    return static_cast<double>(right) / static_cast<double>(all);
  }

  static void expectIntensity(const ToolCloud& cloud)
  {
    const auto intensity = floatField(cloud.blob, "intensity");
    ASSERT_EQ(intensity.size(), cloud.size());
    for (std::size_t i = 0; i < intensity.size(); ++i)
      ASSERT_EQ(intensity[i], static_cast<float>(i));
  }

  pcl::sedr::Floorplan plan() const
  {
    std::string problem;
    auto result = pcl::sedr::floorplanFromJson(bytesOf(in("output.json")), problem);
    EXPECT_EQ(problem, "");
    return result;
  }

  TemporaryFolder folder_;
};

TEST_F(SegmentationTools, PlaneDetectionLabelsCeilingAndFloorAndKeepsAllFields)
{
  const RoomScan scan = scanOf();
  const ProgramRun result =
      runOn(HORIZONTAL_PLANE_DETECTION, scan.pcd(false), "output.pcd");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const ToolCloud cloud = loadCloud(in("output.pcd"));
  expectIntensity(cloud);
  // Columns of walls are neither, so one row of points along each wall is lost.
  EXPECT_GT(share(scan, cloud, Label::Ceiling, Label::Ceiling), 0.93);
  EXPECT_GT(share(scan, cloud, Label::Floor, Label::Floor), 0.9);
  EXPECT_EQ(share(scan, cloud, Label::Floor, Label::Ceiling), 0);
  EXPECT_LT(share(scan, cloud, Label::Other, Label::Ceiling), 0.001);
  EXPECT_LT(share(scan, cloud, Label::Other, Label::Floor), 0.05) << "no table top";
}

TEST_F(SegmentationTools, PlaneDetectionListsThePlanes)
{
  const ProgramRun result = runOn(HORIZONTAL_PLANE_DETECTION, scanOf().pcd(false),
                                  "output.pcd", {"--planes", in("planes.json")});
  const auto json = nlohmann::json::parse(bytesOf(in("planes.json")));
  EXPECT_EQ(json.at("format"), "sedr-planes");
  std::size_t ceilings = 0;
  for (const auto& plane : json.at("planes")) {
    if (plane.at("kind") != "ceiling")
      continue;
    ++ceilings;
    EXPECT_NEAR(plane.at("height").get<double>(), 2.5, 0.002);
    EXPECT_NEAR(plane.at("coefficients").at(3).get<double>(), -2.5, 0.002);
    EXPECT_NEAR(plane.at("area").get<double>(), 12, 1);
    EXPECT_LT(plane.at("residual").get<double>(), 0.002);
    EXPECT_GT(plane.at("inliers").get<std::size_t>(), 4000u);
  }
  EXPECT_EQ(ceilings, 1u);
  EXPECT_EQ(
      static_cast<std::size_t>(std::count(result.out.begin(), result.out.end(), '\n')),
      json.at("planes").size() + 1)
      << "a heading and a line a plane:\n"
      << result.out;
  EXPECT_NE(result.out.find("ceiling     2.500"), std::string::npos) << result.out;
}

TEST_F(SegmentationTools, PlaneDetectionForgetsRoomsUnlessTheyAreToStay)
{
  const std::string bytes = scanOf().pcd(true);
  EXPECT_EQ(runOn(HORIZONTAL_PLANE_DETECTION, bytes, "output.pcd").exit_code, 0);
  EXPECT_EQ(loadCloud(in("output.pcd")).room[0], 0u);
  EXPECT_EQ(runOn(HORIZONTAL_PLANE_DETECTION, bytes, "output.pcd", {"--keep-rooms"})
                .exit_code,
            0);
  EXPECT_EQ(loadCloud(in("output.pcd")).room[0], 1u);
}

TEST_F(SegmentationTools, PlaneDetectionSaysWhatIsMissing)
{
  const RoomScan scan = scanOf();
  const auto detect = [&](const RoomScan& part, const Strings& options = {}) {
    return runOn(HORIZONTAL_PLANE_DETECTION, part.pcd(false), "output.pcd", options);
  };
  expectNothingFound(detect(scan.withoutLabel(Label::Ceiling)), "0 are ceilings");
  expectNothingFound(detect(scan.withoutLabel(Label::Floor)), "0 floors");
  expectNothingFound(
      detect(scan.without([](const auto& p) { return p.label != Label::Floor; })),
      "of 1 horizontal planes 0 are ceilings and 0 floors");
  expectNothingFound(
      detect(scan.without([](const auto& p) { return p.label != Label::Wall; })),
      "horizontal plane");
  expectNothingFound(detect(scan, {"--min-height", "2.6"}), "2.60 m below");
  expectNothingFound(detect(scan, {"--min-area", "50"}), "50");
}

TEST_F(SegmentationTools, PlaneDetectionKnowsScansThatCannotBeRoomsInMetres)
{
  BoxRoom large;
  large.width = 6;
  large.depth = 5;
  RoomScan scan = scanOf(large);
  const auto detect = [&](const Strings& options = {}) {
    return runOn(HORIZONTAL_PLANE_DETECTION, scan.pcd(false), "output.pcd", options);
  };
  for (auto& p : scan.points)
    std::swap(p.y, p.z);
  expectNothingFound(detect(), "y seems to be up");
  EXPECT_EQ(detect({"--z-up"}).err.find("y seems to be up"), std::string::npos);
  std::filesystem::remove(in("output.pcd"));

  for (auto& p : scan.points) {
    std::swap(p.y, p.z);
    p.x *= 1000;
    p.y *= 1000;
    p.z *= 1000;
  }
  expectNothingFound(detect(), "millimetre");
  scan.points.resize(900);
  expectNothingFound(detect(), "900");
}

TEST_F(SegmentationTools, SliceDetailFindsTheSoffitOfEveryRoom)
{
  RoomScan scan;
  for (const std::uint32_t id : {7u, 4u}) {
    BoxRoom room;
    room.id = id;
    room.x += id == 7 ? 4.1 : 0; // a partition of 10 cm
    room.has_soffit = true;
    scan.addRoom(room);
  }
  RoomScan undersides = scan;
  for (auto& p : undersides.points)
    if (p.z > 2.11f)
      p.label = Label::Other;
  RoomScan input = scan;
  for (auto& p : input.points) // as plane detection leaves it: the soffit is a ceiling
    if (p.label == Label::Detail)
      p.label = p.z < 2.11f ? Label::Ceiling : Label::Other;
    else if (p.label == Label::Other && p.z < 0.76f && p.z > 0.74f)
      p.label = Label::Floor; // a table that was taken for a floor
    else if (p.label != Label::Ceiling && p.label != Label::Floor)
      p.label = Label::Other;
  const ProgramRun result = runOn(GRID_SLICE_DETAIL, input.pcd(true), "output.pcd");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out + result.err, "") << "quiet when piped";
  const ToolCloud cloud = loadCloud(in("output.pcd"));
  expectIntensity(cloud);
  EXPECT_GT(share(undersides, cloud, Label::Detail, Label::Detail), 0.85)
      << "all but the rows along the walls";
  EXPECT_GT(share(scan, cloud, Label::Ceiling, Label::Ceiling), 0.999);
  EXPECT_GT(share(scan, cloud, Label::Floor, Label::Floor), 0.999);
  EXPECT_EQ(share(scan, cloud, Label::Other, Label::Detail), 0);
  EXPECT_EQ(share(scan, cloud, Label::Other, Label::Floor), 0) << "no table top";
  for (std::size_t i = 0; i < cloud.size(); ++i)
    ASSERT_TRUE(cloud.label[i] != 4 || cloud.room[i] == scan.points[i].room);
}

TEST_F(SegmentationTools, SliceDetailFindsNoneUnderAPlainCeiling)
{
  const RoomScan scan = scanOf();
  EXPECT_EQ(runOn(GRID_SLICE_DETAIL, scan.pcd(true), "output.pcd").exit_code, 0);
  const ToolCloud cloud = loadCloud(in("output.pcd"));
  for (std::size_t i = 0; i < cloud.size(); ++i)
    ASSERT_EQ(cloud.label[i], static_cast<std::uint32_t>(scan.points[i].label));
}

TEST_F(SegmentationTools, SliceDetailSaysWhatIsMissing)
{
  const auto analyse = [&](Label left_out, const Strings& options = {}) {
    return runOn(GRID_SLICE_DETAIL, scanOf().withoutLabel(left_out).pcd(true),
                 "output.pcd", options);
  };
  expectNothingFound(analyse(Label::Ceiling), "label 1, ceiling");
  expectNothingFound(analyse(Label::Floor), "--floor-height");
  EXPECT_EQ(analyse(Label::Floor, {"--floor-height", "0"}).exit_code, 0);
}

TEST_F(SegmentationTools, FloorplanFittingGivesTheWallsOfEveryRoom)
{
  RoomScan scan;
  for (const std::uint32_t id : {3u, 5u}) {
    BoxRoom room;
    room.id = id;
    room.x += id == 3 ? 0 : 4.1;
    scan.addRoom(room);
  }
  const ProgramRun result = runOn(FLOORPLAN_FITTING, scan.pcd(true), "output.json");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out + result.err, "") << "quiet when piped";
  const auto found = plan();
  ASSERT_EQ(found.rooms.size(), 2u);
  EXPECT_EQ(found.rooms[0].id, 3u);
  EXPECT_EQ(found.rooms[1].id, 5u);
  for (const auto& room : found.rooms) {
    EXPECT_EQ(room.boundary.elements.size(), 4u);
    EXPECT_NEAR(room.area(), 12, 0.02);
    EXPECT_NEAR(room.ceilingAt({2, 0}) - room.floor.heightAt({2, 0}), 2.5, 0.002);
  }
}

TEST_F(SegmentationTools, FloorplanFittingTakesAFileWithoutRoomsForOneRoom)
{
  RoomScan scan = scanOf();
  for (auto& p : scan.points)
    p.room = 0;
  EXPECT_EQ(runOn(FLOORPLAN_FITTING, scan.pcd(true), "output.json").exit_code, 0);
  ASSERT_EQ(plan().rooms.size(), 1u);
  EXPECT_EQ(plan().rooms[0].id, 1u);
}

TEST_F(SegmentationTools, FloorplanFittingSaysWhatIsMissing)
{
  for (const auto& [label, words] : {std::pair{Label::Ceiling, "label 1, ceiling"},
                                     std::pair{Label::Floor, "label 2, floor"},
                                     std::pair{Label::Wall, "label 3, wall"}})
    expectNothingFound(
        runOn(FLOORPLAN_FITTING, scanOf().withoutLabel(label).pcd(true), "output.json"),
        words);
  EXPECT_EQ(runOn(FLOORPLAN_FITTING, scanOf().pcd(true), "output.json",
                  {"--max-radius", "0.1"})
                .exit_code,
            1);
}

} // namespace
