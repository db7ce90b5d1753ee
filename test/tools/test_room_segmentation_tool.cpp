// SPDX-License-Identifier: BSD-3-Clause
// What pcl_room_segmentation leaves: rooms, owners, the building as a file.
#include "rooms/labelled_rooms.h"
#include "stage_tools.h"
#include "tool_error.h"

#include <tuple>
#include <utility>

namespace {

using namespace programs;
using pcl::sedr::tools::loadBuilding;
using pcl::sedr::tools::ToolCloud;
using pcl::sedr::tools::wholeField;

using Whole = std::vector<std::uint32_t>;
using RoomSegmentationTool = StageToolRuns<>;

TEST_F(RoomSegmentationTool, ATurnedScanGivesTheSameVoxelsAndRooms)
{
  constexpr double turn = 0.5; // radians
  const RoomScan scan = scanOfRooms({{0, 0, 6, 5}, {0, 5.11, 4, 3}});
  RoomScan turned = scan;
  for (auto& p : turned.points)
    std::tie(p.x, p.y) = std::pair(
        static_cast<float>(std::cos(turn) * p.x - std::sin(turn) * p.y + 3.007),
        static_cast<float>(std::sin(turn) * p.x + std::cos(turn) * p.y - 1.013));
  const auto roomsOf = [&](const RoomScan& points, const Strings& options) {
    Strings of_grid = options;
    of_grid.insert(of_grid.end(), {"--leaf", "0.1"});
    done(runOn({PARALLEL_VOXEL_GRID}, points.pcd(false), of_grid));
    std::filesystem::rename(in("output.pcd"), in("input_thinned.pcd"));
    EXPECT_EQ(
        runTo(in("output.pcd"), {ROOM_SEGMENTATION}, in("input_thinned.pcd"), options)
            .exit_code,
        0);
    return output();
  };
  const auto sameShare = [&](const Strings& options) {
    const ToolCloud first = roomsOf(scan, options);
    const ToolCloud second = roomsOf(turned, options);
    std::size_t same = 0;
    for (std::size_t i = 0; i < second.points->size(); ++i) {
      const auto& q = (*second.points)[i];
      const Eigen::Vector2d moved(q.x - 3.007, q.y + 1.013);
      const Eigen::Vector2f p = (Eigen::Rotation2Dd(-turn) * moved).cast<float>();
      for (std::size_t k = 0; k < first.points->size(); ++k)
        if (const auto& o = (*first.points)[k];
            first.room[k] == second.room[i] &&
            (Eigen::Vector3f(p.x(), p.y(), q.z) - o.getVector3fMap()).norm() < 0.005F) {
          ++same;
          break;
        }
    }
    return static_cast<double>(same) / static_cast<double>(second.points->size());
  };
  EXPECT_GT(sameShare({}), 0.85); // some lie at the ends of voxels
  EXPECT_LT(sameShare({"--scan-axes"}), 0.6);
}

TEST_F(RoomSegmentationTool, RoomSegmentationWritesTheBuilding)
{
  RoomScan scan = scanOf();
  scan.addRaised(scanOf({0.37, -1.21, 3}), 2.8, 1);
  const ProgramRun result = done(
      runOn({ROOM_SEGMENTATION}, scan.pcd(false), {"--building", in("building.json")}));
  const ToolCloud cloud = output();
  std::size_t labelled = 0;
  std::size_t elsewhere = 0; // where an upper floor was hidden
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    ASSERT_EQ(cloud.room[i] != 0, cloud.label[i] != 0);
    labelled += cloud.label[i] != 0 ? 1 : 0;
    elsewhere +=
        cloud.label[i] != 0 && cloud.room[i] != (scan.points[i].z > 2.65 ? 2u : 1u) ? 1
                                                                                    : 0;
  }
  EXPECT_GT(labelled, scan.points.size() / 4);
  const Whole owners = wholeField(cloud.blob, "owner");
  std::size_t strange = 0; // walls of another room
  for (std::size_t i = 0; i < scan.points.size(); ++i)
    strange += scan.points[i].label == Label::Wall &&
                       owners[i] != (scan.points[i].z > 2.65 ? 2u : 1u)
                   ? 1
                   : 0;
  EXPECT_LT(strange, scan.points.size() / 100);
  EXPECT_LT(elsewhere, labelled / 20) << "rooms by their storeys";
  const pcl::sedr::Building building = loadBuilding(in("building.json"));
  ASSERT_EQ(building.rooms.size(), 2u);
  EXPECT_EQ(building.storeys.size(), 2u);
  EXPECT_NEAR(building.rooms[1].floor, 2.8, 0.1);
  EXPECT_NEAR(building.rooms[1].ceiling, 5.3, 0.1);
  EXPECT_GE(std::count(result.out.begin(), result.out.end(), '\n'), 3)
      << "a heading and a line a room:\n"
      << result.out;
  EXPECT_EQ(
      runOn({ROOM_SEGMENTATION}, scan.pcd(false), {"--building", in("building.txt")})
          .exit_code,
      1);
}

TEST_F(RoomSegmentationTool, ABuildingReadsBackWithLinksAndDoubtsAndNothingElseDoes)
{
  pcl::sedr::Building building;
  building.links = {{{1, 2}, {4.1, 1.0 / 3}, {4.1, 1.2}, 0.01, 2.05}};
  building.doubts = {{{2, 2}, {1.0 / 3, 7}, 3.2, 0.48}};
  const std::string text = pcl::sedr::tools::buildingToJson(building);
  writeFile(in("building.json"), text);
  const pcl::sedr::Building read = loadBuilding(in("building.json"));
  ASSERT_EQ(read.links.size(), 1u);
  EXPECT_EQ(read.links[0].rooms, building.links[0].rooms);
  ASSERT_EQ(read.doubts.size(), 1u);
  EXPECT_EQ(read.doubts[0].rooms, building.doubts[0].rooms);
  EXPECT_EQ(pcl::sedr::tools::buildingToJson(read), text);
  for (const char* other : {"", "{}", "[1]", R"({"format": "sedr-planes"})",
                            R"({"format": "sedr-building", "version": 5})"}) {
    writeFile(in("building.json"), other);
    EXPECT_THROW(loadBuilding(in("building.json")), pcl::sedr::tools::ToolError)
        << other;
  }
  EXPECT_THROW(loadBuilding(in("missing.json")), pcl::sedr::tools::ToolError);
}

TEST_F(RoomSegmentationTool, ABuildingHasTheGapsOfItsRoomsInRuns)
{
  pcl::sedr::Building building;
  pcl::sedr::BuildingRoom& room = building.rooms.emplace_back();
  for (const int x : {-2, -1, 0, 1, 4}) // two runs, and one after a gap
    room.columns.push_back({{x, 7}, x < 0 ? 0.05F : 0.1F, 2.5F, true, x != 4});
  EXPECT_TRUE(
      says(pcl::sedr::tools::buildingToJson(building),
           "\"gaps\":[[-2,7,2,0.05,2.5,3],[0,7,2,0.1,2.5,3],[4,7,1,0.1,2.5,1]]"));
}

} // namespace
