// SPDX-License-Identifier: BSD-3-Clause
#include "report_data.h"

#include "plan_file.h"

#include <pcl/sedr_filters/plan_measures.h>

namespace pcl::sedr::tools {

namespace {

using Json = ResultFolder::Json;

/** @brief Returns a member of an object; null if it is missing. */
const Json&
member(const Json& json, const char* name)
{
  static const Json nothing;
  if (!json.is_object())
    return nothing;
  const auto found = json.find(name);
  return found == json.end() ? nothing : *found;
}

double
number(const Json& json, const char* name)
{
  const Json& value = member(json, name);
  return value.is_number() ? value.get<double>() : 0;
}

std::optional<double>
optionalNumber(const Json& json, const char* name)
{
  const Json& value = member(json, name);
  return value.is_number() ? std::optional<double>(value.get<double>()) : std::nullopt;
}

std::size_t
count(const Json& json, const char* name)
{
  const double value = number(json, name);
  return value > 0 ? static_cast<std::size_t>(value) : 0;
}

std::optional<bool>
optionalFlag(const Json& json, const char* name)
{
  const Json& value = member(json, name);
  return value.is_boolean() ? std::optional<bool>(value.get<bool>()) : std::nullopt;
}

std::string
text(const Json& json, const char* name)
{
  const Json& value = member(json, name);
  return value.is_string() ? value.get<std::string>() : "";
}

RoomFacts
roomOf(const Json& json)
{
  RoomFacts room;
  room.id = static_cast<std::uint32_t>(count(json, "id"));
  room.area = number(json, "area");
  room.perimeter = number(json, "perimeter");
  room.height = number(json, "height");
  room.volume = number(json, "volume");
  room.walls = count(json, "walls");
  room.columns = count(json, "columns");
  room.details = count(json, "details");
  room.repaired_share = optionalNumber(
      json, json.contains("unseen_share") ? "unseen_share" : "repaired_share");
  const Json& solid = member(json, "solid");
  room.wall_area = optionalNumber(solid, "wall_area");
  room.solid_closed = optionalFlag(solid, "closed_manifold");
  room.solid_problem = text(solid, "problem");
  const Json& mesh = member(json, "mesh");
  room.mesh_closed = optionalFlag(mesh, "closed_manifold");
  room.mesh_problem = text(mesh, "problem");
  return room;
}

/** @brief Returns the facts of a room that follow from the plan. */
RoomFacts
roomOf(const PlanRoom& plan)
{
  RoomFacts room;
  room.id = plan.id;
  room.area = plan.area();
  room.perimeter = plan.perimeter();
  room.height = meanHeight(plan);
  room.volume = volumeOf(plan, room.height);
  room.walls = plan.boundary.elements.size();
  room.columns = plan.columns.size();
  room.details = plan.details.size();
  return room;
}

std::optional<CoverageFacts>
coverageOf(const Json& json)
{
  if (!json.is_object())
    return std::nullopt;
  CoverageFacts coverage;
  coverage.seen = number(json, "seen");
  coverage.modelled = number(json, "modelled");
  coverage.share = number(json, "share");
  for (const auto& gap : member(json, "left_out")) {
    const Json& at = member(gap, "at");
    const bool is_place =
        at.is_array() && at.size() == 2 && at[0].is_number() && at[1].is_number();
    coverage.left_out.push_back({text(gap, "reason"), number(gap, "area"),
                                 number(gap, "floor"), number(gap, "ceiling"),
                                 is_place ? at[0].get<double>() : 0,
                                 is_place ? at[1].get<double>() : 0,
                                 optionalFlag(gap, "counts").value_or(true)});
  }
  return coverage;
}

std::optional<DistanceStatistics>
distancesOf(const Json& json)
{
  DistanceStatistics distances;
  distances.count = count(json, "count");
  if (distances.count == 0)
    return std::nullopt;
  distances.mean = number(json, "mean");
  distances.rms = number(json, "rms");
  distances.median = number(json, "median");
  distances.p95 = number(json, "p95");
  distances.p99 = number(json, "p99");
  distances.max = number(json, "max");
  distances.within_1cm = number(json, "within_1cm");
  distances.within_5cm = number(json, "within_5cm");
  distances.histogram_range = number(json, "histogram_range");
  for (const auto& bin : member(json, "histogram"))
    distances.histogram.push_back(bin.is_number() && bin.get<double>() > 0
                                      ? static_cast<std::size_t>(bin.get<double>())
                                      : 0);
  distances.beyond_histogram = count(json, "beyond_histogram");
  return distances;
}

} // namespace

double
ReportData::area() const
{
  double sum = 0;
  for (const auto& room : rooms)
    sum += room.area;
  return sum;
}

double
ReportData::volume() const
{
  double sum = 0;
  for (const auto& room : rooms)
    sum += room.volume;
  return sum;
}

ReportData
readReportData(const ResultFolder& folder)
{
  ReportData data;
  const Json& report = folder.report();
  const Json& input = member(report, "input");
  data.scan = text(input, "path");
  data.points = count(input, "points");
  data.unit = folder.scanSettings().unit;
  for (const auto& stage : member(report, "stages"))
    data.stages.push_back({text(stage, "stage"), count(stage, "points_in"),
                           count(stage, "points_out"), number(stage, "seconds")});
  const Json& parameters = member(report, "parameters");
  if (parameters.is_object())
    for (const auto& [name, value] : parameters.items())
      data.parameters.emplace_back(
          name, value.is_string()
                    ? value.get<std::string>()
                    : value.dump(-1, ' ', false, Json::error_handler_t::replace));
  for (const auto& warning : member(report, "warnings"))
    if (warning.is_string())
      data.warnings.push_back(warning.get<std::string>());
  data.coverage = coverageOf(member(report, "coverage"));
  const Json& evaluation = member(report, "evaluation");
  data.distances = distancesOf(member(evaluation, "cloud_to_mesh"));
  data.mesh_triangles = count(member(evaluation, "mesh"), "triangles");
  if (folder.has("floorplan.json")) {
    data.plan = *loadFloorplan(folder.file("floorplan.json"));
    data.tilts = planTilts(folder.file("floorplan.json"));
    data.max_wall = planMaxWall(folder.file("floorplan.json"));
  }
  data.storeys = storeysOf(data.plan);
  for (const auto& room : member(report, "rooms"))
    data.rooms.push_back(roomOf(room));
  if (data.rooms.empty())
    for (const auto& room : data.plan.rooms)
      data.rooms.push_back(roomOf(room));
  return data;
}

} // namespace pcl::sedr::tools
