// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"
#include "report_settings.h"
#include "wall_maps.h"

#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/json/floorplan_format.h"
#include "sedr_surface/src/sheet/text_spot.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/coverage.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>

namespace pcl::sedr::tools {

namespace {

using Json = nlohmann::ordered_json;
using Reconstruction = IndoorStructureReconstruction<pcl::PointXYZ>;

constexpr const char* format_name = "sedr-report";
constexpr int format_version = 1;

/** @brief Rounds real numbers to seven digits, the precision of floats, which would
 * have more digits as doubles. */
void
roundNumbers(Json& json)
{
  if (json.is_number_float()) {
    char text[32];
    std::snprintf(text, sizeof text, "%.7g", json.get<double>());
    json = std::strtod(text, nullptr);
  }
  else if (json.is_structured())
    for (auto& part : json)
      roundNumbers(part);
}

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

Json
solidOf(const ChainStages& chain, std::uint32_t room)
{
  for (const auto& report : chain.extrusion.getReports())
    if (report.room == room)
      return {{"closed_manifold", report.closed},
              {"triangles", report.triangles},
              {"area", report.area},
              {"floor_area", report.floor_area},
              {"ceiling_area", report.ceiling_area},
              {"wall_area", report.wall_area},
              {"riser_area", report.riser_area},
              {"volume", report.volume},
              {"problem", report.problem}};
  return nullptr;
}

/** @brief Returns how much of walls was measured; null if that is not known. */
Json
supportOf(const WallShares& walls)
{
  return walls.area > 0 ? Json{{"measured", walls.measured},
                               {"inferred", walls.inferred},
                               {"unseen", walls.unseen}}
                        : Json();
}

Json
roomsOf(const RunRecord& run, const Reconstruction& chain)
{
  Json rooms = Json::array();
  const Floorplan& plan = *chain.getFloorplan();
  const std::map<std::uint32_t, std::uint32_t> storeys = storeyOfRooms(plan);
  const std::vector<BuildingRoom>& found =
      chain.getStages().room_segmentation.getBuilding().rooms;
  for (const RoomRow& row : run.schedules.rooms) {
    const PlanRoom& room = *findRoom(plan, row.id);
    const auto seen =
        std::find_if(found.begin(), found.end(),
                     [&](const BuildingRoom& r) { return r.id == room.id; });
    const bool is_known = seen != found.end();
    rooms.push_back({{"id", room.id},
                     {"storey", storeys.at(room.id)},
                     {"area", row.area},
                     {"perimeter", row.perimeter},
                     {"height", row.height},
                     {"volume", row.volume},
                     {"walls", room.boundary.elements.size()},
                     {"columns", room.columns.size()},
                     {"details", room.details.size()},
                     {"support", supportOf(wallShares(plan, room))},
                     {"inferred_area", is_known ? seen->inferred : 0},
                     {"unseen_outline", is_known ? seen->unseen_outline : 0},
                     {"solid", solidOf(chain.getStages(), room.id)},
                     {"mesh", meshOf(chain.getStages(), room.id)}});
  }
  return rooms;
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
storeysOf(const Reconstruction& chain)
{
  const Floorplan& plan = *chain.getFloorplan();
  Json storeys = Json::array();
  for (const PlanStorey& storey : pcl::sedr::storeysOf(plan)) {
    double area = 0;
    for (const PlanRoom& room : partOf(plan, storey).rooms)
      area += room.area();
    storeys.push_back({{"number", storey.number},
                       {"name", storey.name},
                       {"floor", storey.floor},
                       {"area", area},
                       {"rooms", storey.rooms}});
  }
  return storeys;
}

/** @brief Returns the sizes of doors, windows and passages. */
Json
openingsOf(const Floorplan& plan)
{
  Json openings = Json::array();
  for (const PlanOpening& opening : plan.openings)
    openings.push_back({{"number", markOf(opening)},
                        {"kind", nameOf(opening.kind)},
                        {"rooms", opening.rooms},
                        {"width", opening.width()},
                        {"height", opening.height()},
                        {"bottom", opening.bottom},
                        {"confidence", opening.confidence},
                        {"residual", opening.residual}});
  return openings;
}

Json
schedulesOf(const Schedules& schedules)
{
  Json tables;
  for (const ScheduleTable& table : tablesOf(schedules))
    tables[table.name] = {{"columns", table.columns}, {"rows", table.rows}};
  return tables;
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

/** @brief Returns the place of a warning in plan, null if it has none. */
Json
placeOf(const PlanWarning& warning, const Floorplan& plan)
{
  Eigen::Vector2d at = warning.at;
  for (const PlanRoom& room : plan.rooms)
    if (room.id == warning.room && !at.allFinite()) {
      const std::vector<PlanElement>& walls = room.boundary.elements;
      at = warning.wall > 0 && warning.wall <= walls.size()
               ? walls[warning.wall - 1].pointAt(walls[warning.wall - 1].length() / 2)
               : textSpotIn(room.boundary, room.columns).place;
    }
  return at.allFinite() ? Json{at.x(), at.y()} : Json();
}

Json
warningsOf(const std::vector<PlanWarning>& list, const Floorplan& plan)
{
  Json warnings = Json::array();
  for (const PlanWarning& warning : list)
    warnings.push_back({{"kind", nameOf(warning.kind)},
                        {"room", warning.room},
                        {"wall", warning.wall},
                        {"at", placeOf(warning, plan)},
                        {"values", warning.values},
                        {"text", sentenceOf(warning)}});
  return warnings;
}

} // namespace

std::string
makeReport(const RunRecord& run, const Reconstruction& chain)
{
  Json evaluation;
  if (run.figures) {
    std::ostringstream stream;
    writeJson(stream, *run.figures);
    evaluation = Json::parse(stream.str());
  }
  const std::optional<Levelling>& levelling = chain.getModel().levelling;
  Json json{{"format", format_name},
            {"version", format_version},
            {"files", run.files},
            {"input", inputOf(run)},
            {"parameters", parametersOf(run, chain)},
            {"priors", priorsOf(chain)},
            {"stages", stagesOf(run)},
            {"storeys", storeysOf(chain)},
            {"origin", nullptr}, // reserves its position here
            {"levelling", levelling ? levellingToJson(*levelling) : Json()},
            {"frame", frameOf(chain.getModel())},
            {"positions", positionsOf(chain.getModel().mirrored)},
            {"noise", noiseOf(chain.getStages().floorplan_fitting.getWallNoise())},
            {"support", supportOf(wallShares(*chain.getFloorplan()))},
            {"rooms", roomsOf(run, chain)},
            {"schedules", schedulesOf(run.schedules)},
            {"openings", openingsOf(*chain.getFloorplan())},
            {"walls", wallMapsOf(chain)},
            {"coverage", coverageOf(run.coverage)},
            {"evaluation", evaluation},
            {"warnings", warningsOf(run.warnings, *chain.getFloorplan())},
            {"unlikely",
             warningsOf(unlikelyPlaces(*chain.getFloorplan()), *chain.getFloorplan())}};
  roundNumbers(json);
  const Eigen::Vector3d& origin = chain.getOrigin().place;
  json["origin"] = {origin.x(), origin.y(), origin.z()}; // with full precision
  // A path may contain any bytes; invalid UTF-8 becomes U+FFFD.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
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
