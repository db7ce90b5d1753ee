// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/json/floorplan_format.h"
#include "sedr_segmentation/src/openings/opening_search.h"

#include <pcl/common/angles.h>
#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_surface/plan_review.h>

#include <boost/algorithm/string/join.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
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

/** @brief Returns the names of files or folders, not where on the disk they are. */
std::string
namesOf(const std::vector<std::string>& paths)
{
  std::vector<std::string> names;
  for (const auto& path : paths)
    names.push_back((std::filesystem::absolute(path) / "")
                        .lexically_normal()
                        .parent_path()
                        .filename());
  return boost::join(names, ", ");
}

/** @brief Returns the scan, and non-default settings of reading it. */
Json
inputOf(const RunRecord& run)
{
  const ScanSettings& reading = run.reading;
  Json input{{"path", namesOf(run.inputs)},
             {"points", run.points},
             {"unit", reading.unit.value_or(1)}};
  if (!reading.up.empty())
    input["up"] = reading.up;
  if (reading.scan > 0)
    input["scan"] = reading.scan;
  if (reading.skip_broken)
    input["skip_broken"] = true;
  if (!reading.columns.empty())
    input["columns"] = reading.columns;
  return input;
}

/** @brief Returns all parameters used, in the order of the stages. */
Json
parametersOf(const RunRecord& run, const Reconstruction& chain)
{
  const ChainStages& c = chain.getStages();
  return {{"unit", run.reading.unit.value_or(1)},
          {"z_up", chain.getAssumptions().trust_up},
          {"levelled", chain.getAssumptions().keep_levelled},
          {"threads", chain.getNumberOfThreads()},
          {"seed", chain.getSeed()},
          {"voxel_size", chain.getVoxelSize()},
          {"plane_tolerance", chain.getPlaneTolerance()},
          {"grid_size", chain.getGridSize()},
          {"minimum_room_area", c.room_segmentation.getMinimumArea()},
          {"headroom", c.room_segmentation.getHeadroom()},
          {"minimum_enclosure", c.room_segmentation.getMinimumEnclosure()},
          {"storey_step", c.room_segmentation.getStoreyStep()},
          {"boundary_angle_degrees", pcl::rad2deg(chain.getBoundaryAngle())},
          {"boundary_neighbors", chain.getBoundaryNeighbors()},
          {"wall_distance", c.wall_growing.getDistanceThreshold()},
          {"boundary_tolerance", chain.getBoundaryTolerance()},
          {"refinement_distance", c.refinement.getMaximumDistance()},
          {"repair_grid_size", c.hole_repair.getGridSize()},
          {"chord_tolerance", c.extrusion.getChordTolerance()},
          {"cut_openings", c.extrusion.getCutOpenings()},
          {"tree_depth", c.poisson.getDepth()}};
}

/** @brief Returns the priors with their units, limits and sources. */
Json
priorsOf(const Reconstruction& chain)
{
  Json priors = Json::array();
  for (const Prior& prior : priorTable())
    priors.push_back({{"name", prior.name},
                      {"value", chain.getPriors().*prior.member},
                      {"unit", prior.unit},
                      {"low", prior.low},
                      {"high", prior.high},
                      {"source", prior.source}});
  return priors;
}

/** @brief In the order of WallCell; a leaf hides what is behind it. */
constexpr std::array<char, wallCellStates()> letters{'n', 's', 'w', 't',
                                                     'h', 'h', 'e', 'e'};
static_assert(letters.back() != 0);

/** @brief Returns the states in the middle of coarser cells, in runs, row by row from
 * the top. */
std::string
runsOf(const WallMap& map, double cell, std::size_t columns, std::size_t rows)
{
  std::string text;
  std::size_t length = 0;
  char last = 0;
  const auto end = [&] { text += length > 0 ? std::to_string(length) + last : ""; };
  for (std::size_t r = rows; r-- > 0;)
    for (std::size_t c = 0; c < columns; ++c) {
      const WallCell state =
          map.at(cell * (static_cast<double>(c) + 0.5),
                 map.heightOf(0) + cell * (static_cast<double>(r) + 0.5));
      const char letter = letters[static_cast<std::size_t>(state)];
      if (letter != last)
        end();
      length = letter == last ? length + 1 : 1;
      last = letter;
    }
  end();
  return text;
}

/** @brief Returns what a scan shows of each wall: `room`, `walls` (of its boundary,
 * from 1), `length`, `base` (z of the lowest cells), `cell` (metres), `columns`,
 * `rows`, `cells` and the `openings` on it. The cells run row by row from the top, each
 * run of equal ones as its number and a letter: s seen, w within the wall, h hidden, e
 * nothing, n no room. Cells of all walls together are at most half a million, coarser
 * for more.
 */
Json
wallMapsOf(const Reconstruction& chain)
{
  const auto found = chain.getStages().opening_detection.getSearch();
  Json maps = Json::array();
  if (!found)
    return maps;
  const StructureModel& model = chain.getModel();
  const OpeningSearch& search = *found;
  const Floorplan& plan = *model.plan;
  const BuildingFrame to_maps = model.levelFrame().to(model.frame);
  const auto onSide = [&](const WallSide& side, const Eigen::Vector2d& p) {
    return side.line.project(to_maps.toBuilding({p.x(), p.y(), 0}).head<2>());
  };
  constexpr double finest = 0.1; // metres
  constexpr double most = 5e5;   // cells
  double area = 0;
  for (const WallMap& map : search.maps)
    area += map.cell() * map.cell() * static_cast<double>(map.columns() * map.rows());
  const double cell = std::max(finest, std::sqrt(area / most));
  for (std::size_t k = 0; k < search.maps.size(); ++k) {
    const WallSide& side = search.sides[k];
    if (!side.may_have_openings)
      continue;
    const WallMap& map = search.maps[k];
    const double size = std::max(cell, map.cell());
    const auto partsOf = [size](double length) {
      return static_cast<std::size_t>(std::ceil(length / size));
    };
    const std::size_t columns = partsOf(side.line.length());
    const std::size_t rows = partsOf(map.cell() * static_cast<double>(map.rows()));
    Json walls = Json::array();
    if (side.isWall())
      walls.push_back(side.element + 1);
    Json openings = Json::array(); // framed on this side or on the other one
    for (const PlanOpening& opening : plan.openings)
      for (const OpeningWall& in : opening.walls)
        if (in.room == plan.rooms[side.room].id && side.isWall() &&
            in.element == side.element) {
          const auto [from, to] =
              std::minmax({onSide(side, opening.start), onSide(side, opening.end)});
          openings.push_back({{"kind", nameOf(opening.kind)},
                              {"from", from},
                              {"to", to},
                              {"bottom", opening.bottom},
                              {"top", opening.top}});
        }
    maps.push_back({{"room", plan.rooms[side.room].id},
                    {"walls", walls},
                    {"length", side.line.length()},
                    {"base", map.heightOf(0) + to_maps.origin.z()},
                    {"cell", size},
                    {"columns", columns},
                    {"rows", rows},
                    {"cells", runsOf(map, size, columns, rows)},
                    {"openings", openings}});
  }
  return maps;
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
            {"remarks", nullptr},
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
  std::string summary = counted(chain.getFloorplan()->rooms.size(), "room", "rooms") +
                        decimalText(area, 1) + " square metres, ";
  if (const WallShares walls = wallShares(*chain.getFloorplan()); walls.area > 0)
    summary += "walls " + percentText(walls.measured) + " measured, " +
               percentText(walls.inferred) + " inferred, " + percentText(walls.unseen) +
               " unseen, ";
  const auto& meshes = chain.getStages().poisson.getReports();
  const auto closed = std::count_if(meshes.begin(), meshes.end(),
                                    [](const auto& mesh) { return mesh.closed; });
  if (run.figures)
    summary +=
        counted(static_cast<std::size_t>(closed), "closed mesh", "closed meshes");
  return summary + decimalText(seconds, 1) + " s";
}

} // namespace pcl::sedr::tools
