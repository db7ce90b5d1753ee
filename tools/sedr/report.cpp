// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include <pcl/common/angles.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <sstream>

namespace pcl {
namespace sedr {
namespace tools {

namespace {

using Json = nlohmann::ordered_json;
using Reconstruction = IndoorStructureReconstruction<pcl::PointXYZ>;

constexpr const char* format_name = "sedr-report";
constexpr int format_version = 1;

Json
parametersOf(const Reconstruction& chain)
{
  const StructureChain& c = chain.getChain();
  return {{"voxel_size", chain.getVoxelSize()},
          {"plane_tolerance", chain.getPlaneTolerance()},
          {"maximum_tilt_degrees", pcl::rad2deg(c.plane_detection.getMaximumTilt())},
          {"minimum_plane_area", c.plane_detection.getMinimumArea()},
          {"minimum_room_height", c.plane_detection.getMinimumRoomHeight()},
          {"grid_size", chain.getGridSize()},
          {"minimum_room_area", c.room_segmentation.minimum_area},
          {"minimum_floor_share", c.room_segmentation.minimum_floor_share},
          {"minimum_wall_share", c.room_segmentation.minimum_wall_share},
          {"minimum_cells", chain.getMinimumDetailCells()},
          {"trials", c.slice_detail.getTrials()},
          {"boundary_angle_degrees", pcl::rad2deg(chain.getBoundaryAngle())},
          {"boundary_neighbors", chain.getBoundaryNeighbors()},
          {"wall_distance", c.wall_growing.getDistanceThreshold()},
          {"boundary_tolerance", chain.getBoundaryTolerance()},
          {"minimum_element_length", c.floorplan_fitting.getMinimumLength()},
          {"refinement_distance", c.refinement.getMaximumDistance()},
          {"repair_grid_size", c.hole_repair.getGridSize()},
          {"tree_depth", chain.getTreeDepth()},
          {"point_weight", c.poisson.getPointWeight()},
          {"seed", chain.getSeed()}};
}

Json
stagesOf(const Reconstruction& chain)
{
  Json stages = Json::array();
  for (const auto& stage : chain.getStageReports())
    stages.push_back({{"stage", stage.name},
                      {"points_in", stage.points_in},
                      {"points_out", stage.points_out},
                      {"seconds", stage.seconds}});
  return stages;
}

/** @brief Mean height of a room: its volume, column by column over its cells, by its area. */
double
meanHeight(const PlanRoom& room)
{
  constexpr double step = 0.05;
  Eigen::AlignedBox2d box;
  for (const auto& corner : room.boundary.polygon(0.01))
    box.extend(corner);
  double sum = 0;
  std::size_t count = 0;
  for (double y = box.min().y() + step / 2; y < box.max().y(); y += step)
    for (double x = box.min().x() + step / 2; x < box.max().x(); x += step) {
      const Eigen::Vector2d p(x, y);
      if (!room.contains(p))
        continue;
      sum += room.ceilingAt(p) - room.floor.heightAt(p);
      ++count;
    }
  return count == 0 ? 0 : sum / static_cast<double>(count);
}

/** @brief Share of a room's points that hole repair had to add. */
double
repairedShare(const StructureChain& chain, std::uint32_t room)
{
  std::size_t all = 0;
  std::size_t repaired = 0;
  for (const auto& p : *chain.structure)
    all += p.room == room ? 1 : 0;
  for (const int i : chain.hole_repair.getRepairedIndices())
    repaired += (*chain.structure)[i].room == room ? 1 : 0;
  return all == 0 ? 0 : static_cast<double>(repaired) / static_cast<double>(all);
}

Json
meshOf(const StructureChain& chain, std::uint32_t room)
{
  for (const auto& report : chain.poisson.getReports())
    if (report.room == room)
      return {{"closed_manifold", report.closed},
              {"area", report.area},
              {"volume", report.volume},
              {"depth", report.depth},
              {"attempts", report.attempts},
              {"problem", report.problem}};
  return nullptr;
}

Json
roomsOf(const Reconstruction& chain)
{
  Json rooms = Json::array();
  for (const auto& room : chain.getFloorplan()->rooms) {
    const double height = meanHeight(room);
    rooms.push_back({{"id", room.id},
                     {"area", room.area()},
                     {"perimeter", room.perimeter()},
                     {"height", height},
                     {"volume", height * room.area()},
                     {"walls", room.boundary.elements.size()},
                     {"columns", room.columns.size()},
                     {"details", room.details.size()},
                     {"repaired_share", repairedShare(chain.getChain(), room.id)},
                     {"mesh", meshOf(chain.getChain(), room.id)}});
  }
  return rooms;
}

} // namespace

std::string
makeReport(const ReportInput& input,
           const Reconstruction& chain,
           const MeshEvaluationResult& figures)
{
  std::ostringstream evaluation;
  writeJson(evaluation, figures);
  const Json json{{"format", format_name},
                  {"version", format_version},
                  {"input", {{"path", input.path}, {"points", input.points}, {"unit", input.unit}}},
                  {"parameters", parametersOf(chain)},
                  {"stages", stagesOf(chain)},
                  {"rooms", roomsOf(chain)},
                  {"evaluation", Json::parse(evaluation.str())},
                  {"warnings", chain.getChain().warnings}};
  return json.dump(1) + "\n";
}

std::string
summaryOf(const Reconstruction& chain)
{
  double area = 0;
  double seconds = 0;
  for (const auto& room : chain.getFloorplan()->rooms)
    area += room.area();
  for (const auto& stage : chain.getStageReports())
    seconds += stage.seconds;
  std::size_t closed = 0;
  for (const auto& report : chain.getChain().poisson.getReports())
    closed += report.closed ? 1 : 0;
  char text[160];
  std::snprintf(text,
                sizeof text,
                "%zu rooms, %.1f square metres, %zu closed meshes, %.1f s",
                chain.getFloorplan()->rooms.size(),
                area,
                closed,
                seconds);
  return text;
}

} // namespace tools
} // namespace sedr
} // namespace pcl
