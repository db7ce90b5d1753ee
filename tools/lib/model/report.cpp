// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include "plan_report.h"
#include "report_settings.h"
#include "wall_maps.h"

#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/json/floorplan_format.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/plan_review.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>
#include <utility>

namespace pcl::sedr::tools {

namespace {

using Json = nlohmann::ordered_json;
using Reconstruction = IndoorStructureReconstruction<pcl::PointXYZ>;

constexpr const char* format_name = "sedr-report";
constexpr int format_version = 1;

/** @brief Returns the results from scanner positions, or null. */
Json
positionsOf(const MirrorFigures& mirrored)
{
  if (mirrored.positions == 0)
    return nullptr;
  return {{"known", mirrored.positions},
          {"untrue", mirrored.untrue},
          {"rays", mirrored.rays},
          {"mirrors", mirrored.mirrors},
          {"mirrored_points", mirrored.points}};
}

Json
stagesOf(const RunRecord& run)
{
  Json stages = Json::array();
  for (const auto& stage : run.stages)
    stages.push_back({{"stage", stage.name},
                      {"points_in", stage.points_in},
                      {"points_out", stage.points_out},
                      {"seconds", stage.seconds}});
  return stages;
}

Json
meshOf(const ChainStages& chain, std::uint32_t room)
{
  for (const auto& report : chain.poisson.getReports())
    if (report.room == room)
      return {{"closed_manifold", report.closed},
              {"area", report.area},
              {"volume", report.volume},
              {"depth", report.depth},
              {"problem", report.problem}};
  return nullptr;
}

/** @brief Tells of rooms what their plan does not: what of their outline nobody saw,
 * and their meshes. */
void
tellScanOfRooms(const Reconstruction& chain, Json& rooms)
{
  for (const BuildingRoom& found :
       chain.getStages().room_segmentation.getBuilding().rooms)
    for (Json& room : rooms)
      if (room["id"] == found.id)
        room["unseen_outline"] = found.unseen_outline;
  for (Json& room : rooms)
    room["mesh"] = meshOf(chain.getStages(), room["id"]);
}

/** @brief Returns the frame in which the building was found: the angle by which its x
 * axis is turned, degrees, and its origin in the frame of the plan. */
Json
frameOf(const StructureModel& model)
{
  const BuildingFrame frame = model.levelFrame().to(model.frame);
  return {{"yaw", -frame.yaw() * 180 / M_PI}, {"origin", frame.origin}};
}

/** @brief Returns the noise of the walls of each storey, metres. */
Json
noiseOf(const std::vector<WallNoise>& storeys)
{
  Json all = Json::array();
  for (const WallNoise& noise : storeys)
    all.push_back({{"rooms", noise.rooms},
                   {"measured", noise.measured},
                   {"correlation", noise.correlation},
                   {"stretches", noise.stretches}});
  return all;
}

Json
wallMapsOf(const Reconstruction& chain)
{
  const StructureModel& model = chain.getModel();
  const auto search = chain.getStages().opening_detection.getSearch();
  return search ? wallMaps(*model.plan, *search, model.levelFrame().to(model.frame))
                : Json::array();
}

Json
coverageOf(const Coverage& coverage)
{
  Json left_out = Json::array();
  for (const CoverageGap& gap : coverage.left_out)
    left_out.push_back({{"reason", gap.reason},
                        {"area", gap.area},
                        {"floor", gap.floor},
                        {"ceiling", gap.ceiling},
                        {"at", {gap.at.x(), gap.at.y()}},
                        {"counts", gap.counts}});
  return {{"seen", coverage.seen},
          {"modelled", coverage.modelled},
          {"share", coverage.share()},
          {"not_counted", coverage.not_counted},
          {"left_out", left_out}};
}

} // namespace

std::string
makeReport(const RunRecord& run, const Reconstruction& chain, PlanReview& review)
{
  Json evaluation;
  if (run.figures) {
    std::ostringstream stream;
    writeJson(stream, *run.figures);
    evaluation = Json::parse(stream.str());
  }
  const StructureModel& model = chain.getModel();
  const Floorplan& plan = *chain.getFloorplan();
  Json json{{"format", format_name},
            {"version", format_version},
            {"verdict", nullptr}, // reserves its position, as others do
            {"doubts", nullptr},
            {"files", run.files},
            {"input", inputOf(run)},
            {"parameters", parametersOf(run, chain)},
            {"priors", priorsOf(chain)},
            {"stages", stagesOf(run)},
            {"storeys", nullptr},
            {"origin", nullptr},
            {"levelling", model.levelling ? levellingToJson(*model.levelling) : Json()},
            {"frame", frameOf(model)},
            {"positions", positionsOf(model.mirrored)},
            {"noise", noiseOf(chain.getStages().floorplan_fitting.getWallNoise())},
            {"support", nullptr},
            {"rooms", nullptr},
            {"schedules", nullptr},
            {"accuracy", nullptr},
            {"openings", nullptr},
            {"walls", wallMapsOf(chain)},
            {"coverage", coverageOf(run.coverage)},
            {"evaluation", evaluation}};
  json["parameters"].update(Json(nlohmann::json(run.texts)));
  review = setPlan(json, plan, run.schedules, chain.getStages().extrusion.getReports(),
                   run.warnings);
  tellScanOfRooms(chain, json["rooms"]);
  return textOf(std::move(json), chain.getOrigin());
}

std::string
summaryOf(const RunRecord& run, const Reconstruction& chain)
{
  double area = 0;
  double seconds = 0;
  for (const auto& room : chain.getFloorplan()->rooms)
    area += room.area();
  for (const auto& stage : run.stages)
    seconds += stage.seconds;
  const auto counted = [](std::size_t number, const char* one, const char* more) {
    return std::to_string(number) + " " + (number == 1 ? one : more) + ", ";
  };
  const auto percent = [](double share) { return decimalText(100 * share, 0) + " % "; };
  std::string summary = counted(chain.getFloorplan()->rooms.size(), "room", "rooms") +
                        decimalText(area, 1) + " square metres, ";
  if (const WallShares walls = wallShares(*chain.getFloorplan()); walls.area > 0)
    summary += "walls " + percent(walls.measured) + "measured, " +
               percent(walls.inferred) + "inferred, " + percent(walls.unseen) +
               "unseen, ";
  const auto& meshes = chain.getStages().poisson.getReports();
  const auto closed = std::count_if(meshes.begin(), meshes.end(),
                                    [](const auto& mesh) { return mesh.closed; });
  if (run.figures)
    summary +=
        counted(static_cast<std::size_t>(closed), "closed mesh", "closed meshes");
  return summary + decimalText(seconds, 1) + " s";
}

} // namespace pcl::sedr::tools
