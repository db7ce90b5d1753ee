// SPDX-License-Identifier: BSD-3-Clause
#include "colours/scan_colours.h"
#include "tagged_scan.h"
#include "tool_cloud.h"
#include "tools/sedr_tool_runs.h"

#include <array>
#include <cstring>
#include <map>

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

/** The scan, four times denser: none of its surfaces is farther than 3 cm from a point.
 */
RoomScan
denseScan()
{
  RoomScan scan = scanOf();
  const std::vector<RoomPoint> once = scan.points;
  for (const float off : {0.0125F, 0.025F, 0.0375F})
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
  done(run(SEDR, {in("input.pcd"), in("model")}));
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
  EXPECT_TRUE(
      says(glb, "\"name\":\"floor\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[" +
                    red.str().substr(0, 6)));
  EXPECT_TRUE(says(glb, "\"extras\":{\"seen\":true}"));
}

TEST_F(ScanColours, OfLabelsAreWrittenIfAskedFor)
{
  writeFile(in("input.pcd"), paintedPcd(denseScan()));
  done(run(SEDR, {in("input.pcd"), in("model")}, {"--colours", "label"}));
  EXPECT_FALSE(says(bytesOf(in("model/mesh.ply")), "seen"));
  EXPECT_FALSE(says(bytesOf(in("model/structure.pcd")), "rgb"));
  EXPECT_FALSE(says(bytesOf(in("model/model.glb")), "seen"));
}

TEST_F(ScanColours, StayOnTheSolidOfAnEditedModel)
{
  writeFile(in("input.pcd"), paintedPcd(denseScan()));
  done(run(SEDR, {in("input.pcd"), in("model")}, {"--no-mesh"}));
  const std::string glb = bytesOf(in("model/model.glb"));
  done(run(FLOORPLAN_EDIT, {in("model"), "--name", "1=Hall"}));
  EXPECT_TRUE(says(bytesOf(in("model/model.glb")), "\"extras\":{\"seen\":true}"));
}

/** One point at a distance along each axis, both ways, about a place. */
void
addAround(const Eigen::Vector3f& place, float distance, Label label, RoomScan& scan)
{
  for (int axis = 0; axis < 3; ++axis)
    for (const float sign : {-1.F, 1.F}) {
      Eigen::Vector3f p = place;
      p[axis] += sign * distance;
      scan.points.push_back({p.x(), p.y(), p.z(), label, 1});
    }
}

TEST(MedianColours, AreOfAllPointsWithinThreeCentimetresInAnyFrameAndOnAnyThreads)
{
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a.pcd").string();
  pcl::sedr::BuildingFrame frame;
  frame.rotation = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  frame.origin = {3, -2, 1};
  RoomScan scan;
  SurfacePlaces places;
  const Eigen::Matrix3f back = frame.rotation.transpose().cast<float>();
  // Places in and on the borders of cells, on both sides of 0.
  for (const float at : {-1.F, -0.06F, -0.031F, 0.F, 0.03F, 0.06F, 2.345F}) {
    const Eigen::Vector3f place(
        at, 3 * at + 10 * static_cast<float>(places.points.size()), -at);
    places.add(place, {1, 3});
    const Eigen::Vector3f in_scan = back * place + frame.origin.cast<float>();
    addAround(in_scan, 0.0295F, Label::Wall, scan);
    addAround(in_scan, 0.0305F, Label::Floor, scan);
    addAround(in_scan, 0.0310F, Label::Floor, scan);
  }
  places.add({50, 50, 0}, {1, 3}); // alone
  writeFile(path, paintedPcd(scan));
  const JointScan joint({path}, {});
  ASSERT_TRUE(joint.hasColours());
  for (const unsigned threads : {1U, 3U}) {
    const auto medians = medianColours(joint, places, frame, threads);
    ASSERT_EQ(medians.size(), 8u);
    for (std::size_t i = 0; i < 7; ++i) {
      EXPECT_TRUE(medians[i].is_seen) << i;
      EXPECT_EQ(medians[i].rgb, painted.at(Label::Wall)) << i;
    }
    EXPECT_FALSE(medians[7].is_seen);
  }
}

TEST(SurfaceColours, AreFilledInFromTheNearestPlaceOfTheSurface)
{
  const Surface wall{1, 3};
  const Surface floor{1, 2};
  SurfacePlaces places;
  places.add({0, 0, 0}, wall);
  places.add({1, 0, 0}, wall); // not seen
  places.add({1, 0, 0.01F}, floor);
  const SurfaceColours colours(
      places, {{{9, 8, 7}, true}, {{0, 0, 0}, false}, {{1, 2, 3}, true}}, 0);
  const auto of = colours.of(places, 1);
  ASSERT_EQ(of.size(), 3u);
  EXPECT_EQ(of[0].rgb, (Rgb{9, 8, 7}));
  EXPECT_TRUE(of[0].is_seen);
  EXPECT_EQ(of[1].rgb, (Rgb{9, 8, 7})) << "filled in, not from the floor beside";
  EXPECT_FALSE(of[1].is_seen);
  EXPECT_EQ(of[2].rgb, (Rgb{1, 2, 3}));
  const SurfaceColours wide(places, {{{9, 8, 7}, true}, {}, {}}, 0.05);
  for (const float off : {-0.001F, 0.001F}) {
    SurfacePlaces beside;
    beside.add({0, 0.05F + off, 0}, wall);
    EXPECT_EQ(wide.of(beside, 1)[0].is_seen, off < 0);
  }
}

} // namespace
