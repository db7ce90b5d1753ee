// SPDX-License-Identifier: BSD-3-Clause
#include "tool_cloud.h"
#include "tool_contract.h"

#include <gtest/gtest.h>

namespace {

using namespace programs;
using pcl::sedr::tools::floatField;
using pcl::sedr::tools::loadCloud;
using pcl::sedr::tools::ToolCloud;

INSTANTIATE_TEST_SUITE_P(FilterTools,
                         ToolContract,
                         ::testing::Values(PARALLEL_VOXEL_GRID,
                                           GRID_REGION_OUTLIER_REMOVAL,
                                           FLOOR_PROJECTION_RECOVERY));

class FilterTools : public InFolder<> {
protected:
  ToolCloud output() const { return loadCloud(in("output.pcd")); }

  /** Runs a tool on an ASCII PCD with the fields x y z label room intensity. */
  ProgramRun onPoints(const std::string& tool,
                      const std::vector<std::string>& lines,
                      const std::vector<std::string>& options = {})
  {
    std::string bytes =
        "FIELDS x y z label room intensity\nSIZE 4 4 4 1 2 8\nTYPE F F F U U F\n"
        "WIDTH " +
        std::to_string(lines.size()) + "\nDATA ascii\n";
    for (const auto& line : lines)
      bytes += line + "\n";
    writeFile(in("input.pcd"), bytes);
    return run(tool, {in("input.pcd"), in("output.pcd")}, options);
  }
};

using Numbers = std::vector<float>;
using Whole = std::vector<std::uint32_t>;

TEST_F(FilterTools, VoxelGridAveragesAllFields)
{
  const ProgramRun result =
      onPoints(PARALLEL_VOXEL_GRID, {"0.01 0.01 0.01 3 2 10", "0.03 0.01 0.01 3 2 20",
                                     "0.06 0.01 0.01 1 1 5", "1000000 0 0 1 1 7"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out + result.err, "") << "quiet when piped";
  const ToolCloud cloud = output();
  EXPECT_EQ(floatField(cloud.blob, "x"), (Numbers{0.02f, 0.06f, 1e6f}));
  EXPECT_EQ(floatField(cloud.blob, "intensity"), (Numbers{15, 5, 7}));
  EXPECT_EQ(cloud.label, (Whole{3, 1, 1}));
  EXPECT_EQ(cloud.room, (Whole{2, 1, 1}));
}

TEST_F(FilterTools, VoxelGridTakesItsOptions)
{
  const std::vector<std::string> points{"0.01 0 0 1 0 1", "0.2 0 0 1 0 2",
                                        "0.3 0 0 2 0 3", "5 0 0 1 0 4"};
  EXPECT_EQ(onPoints(PARALLEL_VOXEL_GRID, points, {"--leaf", "1", "--min-points", "2"})
                .exit_code,
            0);
  EXPECT_EQ(floatField(output().blob, "intensity"), (Numbers{2}));
  const ProgramRun none = onPoints(PARALLEL_VOXEL_GRID, points, {"--min-points", "5"});
  expectSentence(none, 2);
  EXPECT_EQ(onPoints(PARALLEL_VOXEL_GRID, points, {"--leaf", "0"}).exit_code, 1);
}

/** Rooms of 6 x 6 and 5 x 5 cells of 1 m and an outlier, ceilings at 2.5 m. */
std::vector<std::string>
ceilings()
{
  std::vector<std::string> lines;
  const auto add = [&](int x, int y) {
    lines.push_back(std::to_string(x) + ".5 " + std::to_string(y) + ".5 2.5 1 9 " +
                    std::to_string(lines.size()));
  };
  add(40, 40);
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 6; ++x)
      add(x, y);
  for (int y = 0; y < 5; ++y)
    for (int x = 10; x < 15; ++x)
      add(x, y);
  lines.push_back("40.5 40.5 0 2 8 100"); // a floor point, which this tool ignores
  return lines;
}

TEST_F(FilterTools, OutlierRemovalLabelsRoomsAndKeepsAllRowsUnlessAskedToRemoveThem)
{
  EXPECT_EQ(
      onPoints(GRID_REGION_OUTLIER_REMOVAL, ceilings(), {"--grid", "1"}).exit_code, 0);
  const ToolCloud cloud = output();
  ASSERT_EQ(cloud.size(), 63u);
  EXPECT_EQ(cloud.label[0], 0u);
  EXPECT_EQ(cloud.room[0], 0u);
  EXPECT_EQ(cloud.label[1], 1u);
  EXPECT_EQ(cloud.room[1], 1u);
  EXPECT_EQ(cloud.room[61], 2u);
  EXPECT_EQ(cloud.label[62], 2u);
  EXPECT_EQ(cloud.room[62], 8u);
  EXPECT_EQ(floatField(cloud.blob, "intensity")[61], 61.f);

  const auto removing =
      onPoints(GRID_REGION_OUTLIER_REMOVAL, ceilings(), {"--grid", "1", "--remove"});
  EXPECT_EQ(removing.exit_code, 0) << removing.err;
  const ToolCloud kept = output();
  ASSERT_EQ(kept.size(), 62u);
  EXPECT_EQ(kept.room[0], 1u);
  EXPECT_EQ(floatField(kept.blob, "intensity")[0], 1.f);
}

TEST_F(FilterTools, FloorRecoveryFillsEveryRoomAtItsOwnHeight)
{
  const std::vector<std::string> points{
      "0.5 0.5 2.5 1 1 11", // room 1: ceiling of three cells, its floor missing in one
      "1.5 0.5 2.5 1 1 12", "2.5 0.5 2.5 1 1 13",
      "0.5 0.4 0.1 2 0 14", "1.5 0.4 0.3 2 0 15",
      "10.5 0.5 3 1 2 21", // room 2, lower, and a soffit beside its ceiling
      "11.5 0.5 2 4 0 22",  "10.5 0.4 -1 2 2 23",
      "30.5 0.5 0 2 0 31", // outside
      "5.5 0.5 1 3 0 41"}; // a wall
  EXPECT_EQ(onPoints(FLOOR_PROJECTION_RECOVERY, points, {"--grid", "1"}).exit_code, 0);
  const ToolCloud cloud = output();
  ASSERT_EQ(cloud.size(), 12u);
  EXPECT_EQ(cloud.label, (Whole{1, 1, 1, 2, 2, 1, 4, 2, 0, 3, 2, 2}));
  EXPECT_EQ(cloud.room, (Whole{1, 1, 1, 1, 1, 2, 2, 2, 0, 0, 1, 2}));
  EXPECT_EQ(floatField(cloud.blob, "intensity")[10], 13.f)
      << "fields of the source survive";
  EXPECT_EQ(floatField(cloud.blob, "intensity")[11], 22.f);
  EXPECT_FLOAT_EQ((*cloud.points)[10].z, 0.2f);
  EXPECT_EQ((*cloud.points)[11].z, -1.f);
  EXPECT_EQ((*cloud.points)[11].x, 11.5f);
}

TEST_F(FilterTools, FloorRecoveryRemovesRowsAndTakesTheHeightOfOtherFloors)
{
  const std::vector<std::string> points{"0.5 0.5 2.5 1 0 1", "30.5 0.5 -0.5 2 0 2"};
  EXPECT_EQ(onPoints(FLOOR_PROJECTION_RECOVERY, points, {"--grid", "1", "--remove"})
                .exit_code,
            0);
  const ToolCloud cloud = output();
  EXPECT_EQ(cloud.label, (Whole{1, 2}));
  EXPECT_EQ((*cloud.points)[1].z, -0.5f);
  EXPECT_EQ(floatField(cloud.blob, "intensity"), (Numbers{1, 1}));
}

TEST_F(FilterTools, PlyComesInAndGoesOut)
{
  writeFile(
      in("a.ply"),
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
      "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar "
      "blue\n"
      "end_header\n1 2 3 10 20 30\n");
  EXPECT_EQ(run(PARALLEL_VOXEL_GRID, {in("a.ply"), in("b.ply")}).exit_code, 0);
  EXPECT_NE(bytesOf(in("b.ply")).find("property uchar green"), std::string::npos);
  EXPECT_EQ(loadCloud(in("b.ply")).blob.data, loadCloud(in("a.ply")).blob.data);
}

} // namespace
