// SPDX-License-Identifier: BSD-3-Clause
#include "labelling_tools.h"

#include <utility>

namespace {

using namespace programs;
using pcl::sedr::tools::loadCloud;
using pcl::sedr::tools::ToolCloud;

INSTANTIATE_TEST_SUITE_P(HorizontalPlaneDetection,
                         ToolContract,
                         ::testing::Values(Tool(HORIZONTAL_PLANE_DETECTION)));

using HorizontalPlaneDetectionTool = LabellingTools;

TEST_F(HorizontalPlaneDetectionTool, ListsAndLabelsCeilingAndFloorAndKeepsAllFields)
{
  const RoomScan scan = scanOf();
  const ProgramRun result =
      runOn(HORIZONTAL_PLANE_DETECTION, scan.pcd(false), "output.pcd");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out.rfind("kind ", 0), 0u) << "a heading:\n" << result.out;
  for (const char* plane : {"ceiling     2.500", "floor       0.000"})
    EXPECT_NE(result.out.find(plane), std::string::npos) << result.out;
  const ToolCloud cloud = loadCloud(in("output.pcd"));
  expectIntensity(cloud);
  // Profiles of walls get no label, so one row of points along each wall is lost.
  EXPECT_GT(share(scan, cloud, Label::Ceiling, Label::Ceiling), 0.93);
  EXPECT_GT(share(scan, cloud, Label::Floor, Label::Floor), 0.9);
  EXPECT_EQ(share(scan, cloud, Label::Floor, Label::Ceiling), 0);
  EXPECT_LT(share(scan, cloud, Label::Other, Label::Ceiling), 0.001);
  EXPECT_LT(share(scan, cloud, Label::Other, Label::Floor), 0.05) << "no table top";
}

TEST_F(HorizontalPlaneDetectionTool, ForgetsRooms)
{
  EXPECT_EQ(
      runOn(HORIZONTAL_PLANE_DETECTION, scanOf().pcd(true), "output.pcd").exit_code, 0);
  EXPECT_EQ(loadCloud(in("output.pcd")).room[0], 0u);
}

TEST_F(HorizontalPlaneDetectionTool, SaysWhatIsMissing)
{
  const RoomScan scan = scanOf();
  const auto detect = [&](const RoomScan& part, const Strings& options = {}) {
    return runOn(HORIZONTAL_PLANE_DETECTION, part.pcd(false), "output.pcd", options);
  };
  expectNothingFound(detect(scan.withoutLabel(Label::Ceiling)), "0 are ceilings");
  expectNothingFound(detect(scan.withoutLabel(Label::Floor)), "0 floors");
  expectNothingFound(
      detect(scan.without([](const auto& p) { return p.label != Label::Wall; })),
      "horizontal plane");
  expectNothingFound(detect(scan, {"--min-area", "50"}), "50");
}

TEST_F(HorizontalPlaneDetectionTool, KnowsScansThatCannotBeRoomsInMetres)
{
  RoomScan scan = scanOf({0, 0, 6, 5});
  for (const BoxRoom& room : {BoxRoom{0, 5.11, 4, 3}, BoxRoom{4.13, 5.11, 5, 4.27}})
    scan.addRoom(room);
  const auto detect = [&](const Strings& options = {}) {
    return runOn(HORIZONTAL_PLANE_DETECTION, scan.pcd(false), "output.pcd", options);
  };
  for (auto& p : scan.points)
    std::swap(p.y, p.z);
  EXPECT_NE(detect().err.find("y seems to be up"), std::string::npos);
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

} // namespace
