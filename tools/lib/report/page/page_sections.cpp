// SPDX-License-Identifier: BSD-3-Clause
#include "page_sections.h"

#include "advice.h"
#include "histogram_svg.h"
#include "html_text.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>

namespace pcl::sedr::tools {

namespace {

/** @brief Formats small lengths in centimetres: "0.34 cm". */
std::string
centimetres(double metres)
{
  return numberText(100 * metres, metres < 0.1 ? 2 : 1) + "&nbsp;cm";
}

std::string
figure(const std::string& name, const std::string& value)
{
  return "<div><dt>" + name + "</dt><dd>" + value + "</dd></div>\n";
}

/** @brief An important parameter of a stage: its name in report.json, and its unit. */
struct StageParameter {
  const char* name;
  const char* shown;
  const char* unit;
};

const std::map<std::string, std::vector<StageParameter>>&
stageParameters()
{
  static const std::map<std::string, std::vector<StageParameter>> table{
      {"reading", {{"unit", "unit", "m"}}},
      {"ParallelVoxelGrid", {{"voxel_size", "voxel", "m"}}},
      {"HorizontalPlaneDetection",
       {{"plane_tolerance", "tolerance", "m"},
        {"maximum_tilt_degrees", "tilt up to", "degrees"}}},
      {"GridRegionOutlierRemoval", {{"grid_size", "cell", "m"}}},
      {"RoomSegmentation",
       {{"minimum_room_area", "rooms from", "m²"},
        {"widest_door", "doors up to", "m"}}},
      {"GridSliceDetail",
       {{"minimum_cells", "details from", "cells"}, {"trials", "trials", ""}}},
      {"FloorProjectionRecovery", {{"grid_size", "cell", "m"}}},
      {"CeilingBoundaryWallGrowing",
       {{"boundary_angle_degrees", "angle", "degrees"},
        {"boundary_neighbors", "neighbours", ""},
        {"wall_distance", "distance", "m"}}},
      {"FloorplanFitting", {{"boundary_tolerance", "tolerance", "m"}}},
      {"StructureRefinement", {{"refinement_distance", "distance", "m"}}},
      {"VerticalHoleRepair", {{"repair_grid_size", "cell", "m"}}},
      {"FloorplanExtrusion", {{"chord_tolerance", "chord", "m"}}},
      {"StructuralPoisson", {{"tree_depth", "depth up to", "levels"}}},
  };
  return table;
}

/** @brief Formats a value with as many digits as needed: 3.002299 becomes 3. */
std::string
shortValue(const std::string& json)
{
  char* end = nullptr;
  const double value = std::strtod(json.c_str(), &end);
  if (json.empty() || *end != '\0')
    return escaped(json);
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string
parametersOf(const std::string& stage, const ReportData& data)
{
  const auto known = stageParameters().find(stage);
  if (known == stageParameters().end())
    return "";
  std::string text;
  for (const auto& parameter : known->second)
    for (const auto& [name, value] : data.parameters)
      if (name == parameter.name)
        text += (text.empty() ? "" : ", ") + std::string(parameter.shown) + "&nbsp;" +
                shortValue(value) + (*parameter.unit ? "&nbsp;" : "") + parameter.unit;
  return text;
}

} // namespace

std::string
figuresPart(const ReportData& data)
{
  std::string html = "<dl class=\"figures\">\n";
  if (!data.rooms.empty()) {
    html += figure(data.rooms.size() == 1 ? "room" : "rooms",
                   std::to_string(data.rooms.size()));
    if (data.storeys.size() > 1)
      html += figure("storeys", std::to_string(data.storeys.size()));
    html += figure("floor area", numberText(data.area(), 1) + "&nbsp;m²");
    html += figure("volume", numberText(data.volume(), 1) + "&nbsp;m³");
    const auto closed =
        std::count_if(data.rooms.begin(), data.rooms.end(),
                      [](const RoomFacts& room) { return room.mesh_closed == true; });
    if (data.rooms.front().mesh_closed)
      html += figure("closed meshes", std::to_string(closed) + " of " +
                                          std::to_string(data.rooms.size()));
  }
  if (data.distances) {
    html += figure("half the points within", centimetres(data.distances->median));
    html += figure("within 5&nbsp;cm", percentText(data.distances->within_5cm));
  }
  return html + "</dl>\n";
}

std::string
advicePart(const ReportData& data)
{
  const auto advices = adviceOn(data);
  std::string html = "<ul class=\"advice\">\n";
  for (const auto& advice : advices) {
    html += "<li>" + escaped(advice.finding);
    if (!advice.remedy.empty())
      html += "<span class=\"remedy\">" + escaped(advice.remedy) + "</span>";
    html += "</li>\n";
  }
  const std::string unknown = unknownOf(data);
  if (advices.empty() && !unknown.empty())
    html += "<li>Nothing stands out, but the files do not tell " + escaped(unknown) +
            ".</li>\n";
  else if (advices.empty())
    html +=
        "<li class=\"fine\">Nothing stands out: all rooms are closed, most of their "
        "surface was seen, and the points lie where the model is.</li>\n";
  return htmlSection("check", "Before you trust it", html + "</ul>\n");
}

std::string
histogramPart(const ReportData& data, double range)
{
  if (!data.distances)
    return "";
  const DistanceStatistics& d = *data.distances;
  return "<figure>" + histogramSvg(d, range) +
         "<figcaption>Distances of the scan's points that were taken for structure "
         "from the mesh, before they were refined.</figcaption></figure>\n" +
         htmlTable({"points", "mean", "half within", "95&nbsp;% within",
                    "99&nbsp;% within", "farthest", "within 1&nbsp;cm",
                    "within 5&nbsp;cm"},
                   {{numberText(static_cast<double>(d.count), 0), centimetres(d.mean),
                     centimetres(d.median), centimetres(d.p95), centimetres(d.p99),
                     centimetres(d.max), percentText(d.within_1cm),
                     percentText(d.within_5cm)}}) +
         "<p class=\"note\">Noise of the scanner is in these figures, and so are "
         "things "
         "at the walls that were taken for structure at first: read the median.</p>\n";
}

std::string
stagesPart(const ReportData& data)
{
  if (data.stages.empty())
    return "";
  std::vector<std::vector<std::string>> rows;
  double seconds = 0;
  for (const auto& stage : data.stages) {
    seconds += stage.seconds;
    rows.push_back({escaped(stage.name),
                    numberText(static_cast<double>(stage.points_in), 0),
                    numberText(static_cast<double>(stage.points_out), 0),
                    numberText(stage.seconds, 2), parametersOf(stage.name, data)});
  }
  rows.push_back({"together", "", "", numberText(seconds, 2), ""});
  return htmlSection("stages", "Stages",
                     htmlTable({"stage", "points in", "points out", "seconds", "with"},
                               rows, {true, false, false, false, true}));
}

std::string
parametersPart(const ReportData& data)
{
  if (data.parameters.empty())
    return "";
  std::vector<std::vector<std::string>> rows;
  for (const auto& [name, value] : data.parameters)
    rows.push_back({"<code>" + escaped(name) + "</code>", escaped(value)});
  return htmlSection(
      "parameters", "Parameters",
      "<details><summary>all " + std::to_string(rows.size()) +
          " of this run: lengths in metres, angles in degrees</summary>\n" +
          htmlTable({"parameter", "value"}, rows) + "</details>\n");
}

} // namespace pcl::sedr::tools
