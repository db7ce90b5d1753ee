// SPDX-License-Identifier: BSD-3-Clause
#include "box_room.h"
#include "in_folder.h"
#include "option_help.h"
#include "plan_file.h"
#include "tool_cloud.h"

#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <set>
#include <utility>

namespace {

using namespace programs;
using pcl::sedr::tools::floatField;
using pcl::sedr::tools::loadCloud;
using pcl::sedr::tools::ToolCloud;

/** A room of 4 m x 3 m with a soffit, and one of 3 m x 3 m beside it. */
RoomScan
twoRooms()
{
  return scanOfRooms( // with a partition of 10 cm
      {{0.37, -1.21, 4, 3, 2.5, 1, true}, {4.47, -1.21, 3, 3, 2.5, 2}});
}

/** Runs the programs of the stages with their defaults. */
class StageByStage : public InFolder<> {
protected:
  void stage(const char* tool, const std::vector<std::string>& files)
  {
    std::vector<std::string> arguments;
    for (const std::string& file : files)
      arguments.push_back(file.front() == '-' ? file : in(file));
    done(run(tool, arguments));
  }

  /** Runs the stages in order, up to the floor plan. */
  void fitPlan(const RoomScan& scan)
  {
    writeFile(in("scan.pcd"), scan.pcd(false));
    stage(PARALLEL_VOXEL_GRID, {"scan.pcd", "thinned.pcd"});
    stage(ROOM_SEGMENTATION,
          {"thinned.pcd", "rooms.pcd", "--building", "building.json"});
    stage(GRID_SLICE_DETAIL, {"rooms.pcd", "details.pcd"});
    stage(FLOOR_PROJECTION_RECOVERY, {"details.pcd", "floor.pcd"});
    stage(CEILING_BOUNDARY_WALL_GROWING, {"floor.pcd", "walls.pcd"});
    stage(FLOORPLAN_FITTING, {"walls.pcd", "floorplan.json", "--raw", "scan.pcd",
                              "--building", "building.json"});
    stage(OPENING_DETECTION, {"scan.pcd", "floorplan.json", "floorplan.json",
                              "--building", "building.json"});
  }

  pcl::sedr::Floorplan plan(const std::string& name) const
  {
    return pcl::sedr::tools::loadPlan(in(name)).plan;
  }
};

/** Expects each corner of a loop within a millimetre of one of the other. */
void
expectSameLoop(const pcl::sedr::PlanLoop& found, const pcl::sedr::PlanLoop& expected)
{
  ASSERT_EQ(found.elements.size(), expected.elements.size());
  for (const pcl::sedr::PlanElement& wall : found.elements) {
    double nearest = 1;
    for (const pcl::sedr::PlanElement& other : expected.elements)
      nearest = std::min(nearest, (wall.start - other.start).norm());
    EXPECT_LT(nearest, 0.001);
  }
}

TEST_F(StageByStage, ThePlanOfTwoStoreysIsThatOfPclSedr)
{
  RoomScan scan = twoRooms();
  scan.addRaised(twoRooms(), 2.8, 2);
  fitPlan(scan);
  // Bare rooms on each other look as if y were up.
  done(run(SEDR, {in("scan.pcd"), in("model"), "--no-mesh", "--up", "z"}));
  const pcl::sedr::Floorplan found = plan("floorplan.json");
  const pcl::sedr::Floorplan expected = plan("model/floorplan.json");
  ASSERT_EQ(expected.rooms.size(), 4u);
  ASSERT_EQ(found.rooms.size(), 4u);
  for (std::size_t r = 0; r < 4; ++r) {
    const pcl::sedr::PlanRoom& room = found.rooms[r];
    const pcl::sedr::PlanRoom& other = expected.rooms[r];
    EXPECT_EQ(room.id, other.id);
    EXPECT_EQ(room.niches.size(), other.niches.size());
    expectSameLoop(room.boundary, other.boundary);
    EXPECT_NEAR(room.floor.plane[3], other.floor.plane[3], 0.001);
    EXPECT_NEAR(room.ceiling.plane[3], other.ceiling.plane[3], 0.001);
    ASSERT_EQ(room.details.size(), other.details.size());
    for (std::size_t d = 0; d < room.details.size(); ++d)
      expectSameLoop(room.details[d].boundary, other.details[d].boundary);
  }
  EXPECT_EQ(found.openings.size(), expected.openings.size());
  ASSERT_EQ(found.storeys.size(), 2u);
  EXPECT_EQ(found.storeys[1].rooms, expected.storeys[1].rooms);
}

TEST_F(StageByStage, APlanInAnotherFrameIsToldAndRefused)
{
  fitPlan(twoRooms());
  pcl::sedr::Floorplan other = plan("floorplan.json");
  other.rooms.pop_back(); // points of rooms that a plan has not do not count
  other.openings.clear(); // a doorway of that room
  writeFile(in("part.json"), floorplanToJson(other));
  stage(STRUCTURE_REFINEMENT, {"walls.pcd", "part.json", "part.pcd"});
  for (pcl::sedr::PlanElement& wall : other.rooms[0].boundary.elements)
    for (Eigen::Vector2d* corner : {&wall.start, &wall.end})
      *corner += Eigen::Vector2d(2.5, 1.2);
  writeFile(in("moved.json"), floorplanToJson(other));
  expectSentence(
      run(STRUCTURE_REFINEMENT, {in("walls.pcd"), in("moved.json"), in("left.pcd")}), 2,
      "in another frame");
  EXPECT_FALSE(std::filesystem::exists(in("left.pcd")));
  const ProgramRun told = done(
      run(OPENING_DETECTION, {in("scan.pcd"), in("moved.json"), in("openings.json")}));
  EXPECT_TRUE(says(told.err, "its frame and unit?"));
}

TEST_F(StageByStage, TheFittingTellsTheDoubtsOfTheBuilding)
{
  fitPlan(twoRooms());
  auto building = nlohmann::json::parse(bytesOf(in("building.json")));
  building["doubts"] = {
      {{"rooms", {1, 2}}, {"at", {4.4, 0}}, {"area", 9}, {"chance", 0.4}},
      {{"rooms", {1, 7}}, {"at", {4.4, 0}}, {"area", 9}, {"chance", 0.4}}};
  writeFile(in("building.json"), building.dump());
  const ProgramRun result =
      run(FLOORPLAN_FITTING,
          {in("walls.pcd"), in("floorplan.json"), "--building", in("building.json")});
  EXPECT_TRUE(says(result.err, "room 1: it may be one room with room 2, 40 % likely"));
  EXPECT_FALSE(says(result.err, "room 7")) << "it has no plan";
}

TEST_F(StageByStage, TwoRoomsBecomeTwoClosedMeshes)
{
  fitPlan(twoRooms());
  stage(STRUCTURE_REFINEMENT, {"walls.pcd", "floorplan.json", "refined.pcd"});
  stage(VERTICAL_HOLE_REPAIR, {"refined.pcd", "floorplan.json", "structure.pcd"});
  stage(STRUCTURAL_POISSON, {"structure.pcd", "mesh.ply"});
  stage(FLOORPLAN_EXTRUSION, {"floorplan.json", "solid.ply"});
  stage(FLOORPLAN_DRAWING, {"floorplan.json", "floorplan.svg"});

  const pcl::sedr::Floorplan plan = this->plan("floorplan.json");
  ASSERT_EQ(plan.rooms.size(), 2u);
  EXPECT_NEAR(plan.rooms[0].area(), 12, 0.05);
  ASSERT_EQ(plan.rooms[0].details.size(), 1u);
  EXPECT_NEAR(plan.rooms[0].details[0].boundary.area(), 0.6 * 3, 0.05);
  EXPECT_NEAR(plan.rooms[1].area(), 9, 0.05);
  EXPECT_EQ(plan.rooms[1].details.size(), 0u);

  pcl::sedr::TriangleMesh mesh;
  ASSERT_EQ(pcl::sedr::loadMesh(in("mesh.ply"), mesh), "");
  EXPECT_LT(mesh.signedVolume(), 0) << "seen from within";
  EXPECT_EQ(mesh.labels.size(), mesh.triangles.size());
  EXPECT_EQ(std::set<std::uint32_t>(mesh.rooms.begin(), mesh.rooms.end()),
            (std::set<std::uint32_t>{1, 2}));
  const ToolCloud structure = loadCloud(in("structure.pcd"));
  EXPECT_EQ(floatField(structure.blob, "intensity").size(), structure.size());

  for (const auto& [name, tolerance] :
       {std::make_pair("mesh.ply", 0.6), std::make_pair("solid.ply", 0.2)}) {
    const ProgramRun judged =
        done(run(MESH_EVALUATION,
                 {in(name), "--json", in("figures.json"), "--self-intersections"}));
    const auto told = nlohmann::json::parse(bytesOf(in("figures.json"))).at("mesh");
    EXPECT_EQ(told.at("closed_manifold"), true) << judged.out;
    EXPECT_EQ(told.at("self_intersections"), 0) << name;
    EXPECT_EQ(told.at("components").size(), 2u);
    EXPECT_NEAR(std::abs(told.at("volume").get<double>()),
                12 * 2.5 - 1.8 * 0.4 + 9 * 2.5, tolerance);
  }
}

TEST_F(StageByStage, ThePageOfEveryStageNamesAllOptionsOfItsTool)
{
  const std::vector<std::pair<const char*, std::string>> pages{
      {PARALLEL_VOXEL_GRID, "parallel_voxel_grid"},
      {ROOM_SEGMENTATION, "room_segmentation"},
      {HORIZONTAL_PLANE_DETECTION, "horizontal_plane_detection"},
      {GRID_REGION_OUTLIER_REMOVAL, "grid_region_outlier_removal"},
      {GRID_SLICE_DETAIL, "grid_slice_detail"},
      {FLOOR_PROJECTION_RECOVERY, "floor_projection_recovery"},
      {CEILING_BOUNDARY_WALL_GROWING, "ceiling_boundary_wall_growing"},
      {FLOORPLAN_FITTING, "floorplan_fitting"},
      {OPENING_DETECTION, "opening_detection"},
      {STRUCTURE_REFINEMENT, "structure_refinement"},
      {VERTICAL_HOLE_REPAIR, "vertical_hole_repair"},
      {FLOORPLAN_EXTRUSION, "floorplan_extrusion"},
      {FLOORPLAN_DRAWING, "floorplan_drawing"},
      {SEDR, "indoor_structure_reconstruction"}};
  for (const auto& [tool, name] : pages) {
    const std::string page = bytesOf(DOC_FOLDER "/" + name + ".md");
    for (const auto& option : optionsIn(run(tool, {"-h"}).out))
      EXPECT_TRUE(says(page, "`--" + option.name))
          << name << ".md does not tell --" << option.name;
  }
}

} // namespace
