// SPDX-License-Identifier: BSD-3-Clause
#include "labelling_tools.h"

#include <utility>

namespace {

using namespace programs;
using pcl::sedr::tools::loadCloud;
using pcl::sedr::tools::ToolCloud;

INSTANTIATE_TEST_SUITE_P(SegmentationTools,
                         ToolContract,
                         ::testing::Values(Tool(GRID_SLICE_DETAIL),
                                           Tool(FLOORPLAN_FITTING, "output.json")));

using SegmentationTools = LabellingTools;

TEST_F(SegmentationTools, SliceDetailFindsTheSoffitOfEveryRoom)
{
  const RoomScan scan = scanOfRooms( // with a partition of 10 cm
      {{4.47, -1.21, 4, 3, 2.5, 7, true}, {0.37, -1.21, 4, 3, 2.5, 4, true}});
  RoomScan undersides = scan;
  for (auto& p : undersides.points)
    if (p.z > 2.11f)
      p.label = Label::Other;
  RoomScan input = scan;
  for (auto& p : input.points) // plane detection labels the soffit ceiling
    if (p.label == Label::Detail)
      p.label = p.z < 2.11f ? Label::Ceiling : Label::Other;
    else if (p.label == Label::Other && p.z < 0.76f && p.z > 0.74f)
      p.label = Label::Floor; // a table that is labelled floor
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

TEST_F(SegmentationTools, SliceDetailSaysWhatIsMissing)
{
  const auto analyse = [&](Label left_out) {
    return runOn(GRID_SLICE_DETAIL, scanOf().withoutLabel(left_out).pcd(true),
                 "output.pcd");
  };
  expectNothingFound(analyse(Label::Ceiling), "label 1, ceiling");
  expectNothingFound(analyse(Label::Floor), "label 2, floor");
}

TEST_F(SegmentationTools, FloorplanFittingGivesTheWallsOfEveryRoom)
{
  const RoomScan scan =
      scanOfRooms({{0.37, -1.21, 4, 3, 2.5, 3}, {4.47, -1.21, 4, 3, 2.5, 5}});
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

TEST_F(SegmentationTools, FloorplanFittingFollowsTheRawScan)
{
  // A raw scan shifted by 6 mm upwards and 5 mm sideways from the labelled points.
  const RoomScan scan = scanOf();
  RoomScan raw = scan;
  for (auto& p : raw.points) {
    p.x += 0.005F;
    p.z += 0.006F;
  }
  writeFile(in("raw.pcd"), raw.pcd(false));
  ASSERT_EQ(runOn(FLOORPLAN_FITTING, scan.pcd(true), "output.json").exit_code, 0);
  const auto found = plan().rooms.at(0);
  const ProgramRun result =
      runOn(FLOORPLAN_FITTING, scan.pcd(true), "output.json", {"--raw", in("raw.pcd")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto fitted = plan().rooms.at(0);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(fitted.boundary.elements[i].start.x(),
                found.boundary.elements[i].start.x() + 0.005, 0.001);
  const Eigen::Vector2d middle(2, 0);
  EXPECT_NEAR(fitted.floor.heightAt(middle), 0.006, 0.0005);
  EXPECT_NEAR(fitted.ceiling.heightAt(middle), 2.506, 0.0005);

  const ProgramRun missing = runOn(FLOORPLAN_FITTING, scan.pcd(true), "output.json",
                                   {"--raw", in("none.pcd")});
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_NE(missing.err.find("none.pcd"), std::string::npos) << missing.err;
}

TEST_F(SegmentationTools, FloorplanFittingSaysWhatIsMissing)
{
  for (const auto& [label, words] : {std::pair{Label::Ceiling, "label 1, ceiling"},
                                     std::pair{Label::Floor, "label 2, floor"},
                                     std::pair{Label::Wall, "label 3, wall"}})
    expectNothingFound(
        runOn(FLOORPLAN_FITTING, scanOf().withoutLabel(label).pcd(true), "output.json"),
        words);
}

} // namespace
