// SPDX-License-Identifier: BSD-3-Clause
#include "colours/scan_colours.h"
#include "tagged_scan.h"
#include "tool_cloud.h"
#include "tools/sedr_tool_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <map>
#include <sstream>
#include <thread>

namespace {

using namespace programs;
using namespace pcl::sedr::tools;
using Rgb = std::array<std::uint8_t, 3>;

const std::map<Label, Rgb> painted{{Label::Floor, {200, 20, 10}},
                                   {Label::Ceiling, {10, 30, 210}},
                                   {Label::Wall, {20, 190, 40}},
                                   {Label::Other, {0, 0, 0}}};

/** A scan whose points have the colours of their labels; every ninth is white. */
std::string
paintedPcd(const RoomScan& scan)
{
  std::string bytes = pcdHeader("x y z rgb", scan.points.size());
  std::size_t number = 0;
  for (const RoomPoint& p : scan.points) {
    const Rgb rgb = ++number % 9 == 0 ? Rgb{255, 255, 255} : painted.at(p.label);
    const std::array<std::uint8_t, 4> packed{rgb[2], rgb[1], rgb[0], 255};
    for (const float coordinate : {p.x, p.y, p.z})
      bytes.append(reinterpret_cast<const char*>(&coordinate), sizeof coordinate);
    bytes.append(reinterpret_cast<const char*>(packed.data()), packed.size());
  }
  return bytes;
}

/** The scan, four times denser so that a voxel holds several points. */
RoomScan
denseScan()
{
  RoomScan scan = scanOf();
  const std::vector<RoomPoint> once = scan.points;
  for (const float off : {0.004F, 0.008F, 0.012F})
    for (RoomPoint p : once) {
      p.x += p.label == Label::Wall ? 0 : off;
      p.z += p.label == Label::Wall ? off : 0;
      scan.points.push_back(p);
    }
  return scan;
}

using ScanColours = SedrTool;

TEST_F(ScanColours, AreOnMeshPointsAndElementsAndMarkedWhereNothingWasSeen)
{
  writeFile(in("input.pcd"), paintedPcd(denseScan()));
  const ProgramRun result = run(SEDR, {in("input.pcd"), in("model")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const ToolCloud points = loadCloud(in("model/structure.pcd"));
  const ToolCloud mesh = loadCloud(in("model/mesh.ply"));
  for (const ToolCloud* cloud : {&points, &mesh}) {
    const auto* const field = findField(cloud->blob, "rgb");
    ASSERT_NE(field, nullptr);
    const std::vector<std::uint32_t> seen = wholeField(cloud->blob, "seen");
    ASSERT_EQ(seen.size(), cloud->size());
    std::size_t right = 0;
    std::size_t counted = 0;
    for (std::size_t i = 0; i < cloud->size(); ++i) {
      const std::uint8_t* const blue =
          &cloud->blob.data[i * cloud->blob.point_step + field->offset];
      const Rgb rgb{blue[2], blue[1], blue[0]};
      right += rgb == painted.at(static_cast<Label>(cloud->label[i])) ? 1 : 0;
      const pcl::PointXYZ& p = (*cloud->points)[i];
      // Below the cupboard and the table there is floor that nobody saw.
      const bool is_hidden = p.x > 0.37 + 1.65 && p.x < 0.37 + 2.35 &&
                             p.y > -1.21 + 2.65 && p.y < -1.21 + 2.9 && p.z < 0.01;
      if (cloud->label[i] == static_cast<std::uint32_t>(Label::Floor) && is_hidden) {
        EXPECT_EQ(seen[i], 0u) << p;
        ++counted;
      }
      if (std::abs(p.x - 0.37 - 1) < 0.4 && p.z > 2.49) {
        EXPECT_EQ(seen[i], 1u) << p;
      }
    }
    EXPECT_GT(counted, 0u);
    EXPECT_GT(static_cast<double>(right), 0.9 * static_cast<double>(cloud->size()));
  }
  const std::string glb = bytesOf(in("model/model.glb"));
  std::ostringstream red; // of the floor, linear
  red << std::pow((200 / 255.0 + 0.055) / 1.055, 2.4);
  EXPECT_NE(
      glb.find("\"name\":\"floor\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[" +
               red.str().substr(0, 6)),
      std::string::npos);
  EXPECT_NE(glb.find("\"extras\":{\"seen\":true}"), std::string::npos);
}

TEST_F(ScanColours, OfLabelsAreWrittenIfAskedFor)
{
  writeFile(in("input.pcd"), paintedPcd(denseScan()));
  ASSERT_EQ(run(SEDR, {in("input.pcd"), in("model")}, {"--colours", "label"}).exit_code,
            0);
  EXPECT_EQ(bytesOf(in("model/mesh.ply")).find("seen"), std::string::npos);
  EXPECT_EQ(bytesOf(in("model/structure.pcd")).find("rgb"), std::string::npos);
  EXPECT_EQ(bytesOf(in("model/model.glb")).find("seen"), std::string::npos);
}

TEST_F(ScanColours, StayOnTheSolidOfAnEditedModel)
{
  writeFile(in("input.pcd"), paintedPcd(denseScan()));
  ASSERT_EQ(run(SEDR, {in("input.pcd"), in("model")}, {"--no-mesh"}).exit_code, 0);
  const std::string glb = bytesOf(in("model/model.glb"));
  ASSERT_EQ(run(FLOORPLAN_EDIT, {in("model"), "--name", "1=Hall"}).exit_code, 0);
  EXPECT_NE(bytesOf(in("model/model.glb")).find("\"extras\":{\"seen\":true}"),
            std::string::npos);
}

TEST(MedianColours, AreThoseOfGroupsWhateverTheOrder)
{
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a.pcd").string();
  RoomScan scan;
  for (int i = 0; i < 300; ++i)
    scan.points.push_back({static_cast<float>(i % 3), static_cast<float>(i), 0,
                           i % 3 == 0 ? Label::Floor : Label::Wall, 1});
  writeFile(path, paintedPcd(scan));
  const JointScan joint({path}, {});
  ASSERT_TRUE(joint.hasColours());
  const auto medians = medianColours(
      joint, [](const Eigen::Vector3f& p) { return static_cast<std::size_t>(p.x()); },
      2, 0);
  ASSERT_EQ(medians.size(), 2u) << "the third group is beyond";
  EXPECT_EQ(medians[0].rgb, painted.at(Label::Floor));
  EXPECT_EQ(medians[1].rgb, painted.at(Label::Wall));
  EXPECT_TRUE(medians[0].is_seen);
  const auto none = medianColours(
      joint, [](const Eigen::Vector3f&) { return std::size_t{9}; }, 1, 0);
  EXPECT_FALSE(none[0].is_seen);
}

TEST(SurfaceColours, AreSeenWithinAVoxelAndTheScatterOfPoints)
{
  pcl::PointCloud<pcl::PointXYZ> points;
  points.emplace_back(0.F, 0.F, 0.F);
  const SurfaceColours::Surface wall{1, 3};
  for (const float voxel : {0.05F, 0.01F}) {
    const SurfaceColours colours(points, {wall}, {{{9, 8, 7}, true}}, voxel);
    for (const float off : {-0.001F, 0.001F}) {
      const auto colour = colours.at({0, voxel + 0.025F + off, 0}, wall);
      EXPECT_EQ(colour.is_seen, off < 0) << voxel;
      EXPECT_EQ(colour.rgb, (Rgb{9, 8, 7})) << "also where it is filled in";
    }
  }
}

TEST_F(ScanColours, AndTagsAreFoundOnTheThreadsGiven)
{
  writeFile(in("input.pcd"), paintedPcd(denseScan()));
  const JointScan scan({in("input.pcd")}, {});
  const auto own = std::this_thread::get_id();
  std::atomic<int> elsewhere{0};
  const auto group_of = [&](const Eigen::Vector3f&) {
    elsewhere += std::this_thread::get_id() == own ? 0 : 1;
    return std::size_t{0};
  };
  const auto tag_of = [&](const Eigen::Vector3f& p) {
    return PointTag{static_cast<std::uint32_t>(group_of(p))};
  };
  medianColours(scan, group_of, 1, 1);
  EXPECT_EQ(elsewhere, 0);
  for (const char* name : {"tagged.las", "tagged.pcd"})
    saveTagged(in(name), scan, tag_of, 1);
  EXPECT_EQ(elsewhere, 0);
}

} // namespace
