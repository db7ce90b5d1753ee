// SPDX-License-Identifier: BSD-3-Clause
#include "report_page.h"

#include "bytes/whole_file.h"
#include "colour.h"
#include "plan_file.h"
#include "report/page_parts.h"
#include "results/result_folder.h"
#include "run_tool.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/floorplan_drawing.h>

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr::tools {

namespace fs = std::filesystem;

std::set<std::string>
subjectsIn(const nlohmann::ordered_json& report, std::size_t most)
{
  std::vector<PlanDoubt> doubts;
  for (const auto& doubt : report.value("doubts", nlohmann::ordered_json::array()))
    doubts.push_back({doubt.value("subject", ""),
                      doubt.value("beside", std::vector<std::string>())});
  return leadingSubjects(doubts, most);
}

namespace {

using Json = ResultFolder::Json;

/** @brief Returns the scripts of three.js; empty if one is missing or has an end tag of
 * its element. */
std::string
threeScripts(const std::string& folder)
{
  std::string scripts;
  for (const char* name : {"/three.min.js", "/examples/js/controls/OrbitControls.js"}) {
    const std::string text =
        fs::is_regular_file(folder + name) ? textOfFile(folder + name) : "";
    if (text.empty() || text.find("</script") != std::string::npos)
      return "";
    scripts += text + "\n";
  }
  return scripts;
}

/** @brief Returns the sorted names of the folder's files, without the page. */
Json
fileNames(const std::string& path)
{
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path))
    if (entry.is_regular_file() && entry.path().stem() != "report.html" &&
        entry.path().filename() != "report.html" &&
        entry.path().string().back() != '~') // of a plan before
      names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

/** @brief Returns the colours of labels by name, of rooms in order, and of distances
 * from 0 to the range in even steps. */
Json
colours()
{
  constexpr std::uint32_t rooms = 12;
  Json json{{"labels", Json::object()},
            {"rooms", Json::array()},
            {"distances", Json::array()}};
  for (std::uint32_t k = 0; k <= static_cast<std::uint32_t>(StructureLabel::Column);
       ++k)
    json["labels"][toString(static_cast<StructureLabel>(k))] =
        hexCode(colourOf(static_cast<StructureLabel>(k)));
  for (std::uint32_t room = 1; room <= rooms; ++room)
    json["rooms"].push_back(hexCode(roomColour(room)));
  for (int k = 0; k <= distance_steps; ++k)
    json["distances"].push_back(hexCode(distanceColour(k, distance_steps)));
  return json;
}

/** @brief Returns a sheet of each storey, by its name. Sheets are small, so that their
 * letters are large on a page. */
Json
drawings(const PlanDocument& file, const Json& report)
{
  const Floorplan& plan = file.plan;
  Json sheets = Json::array();
  DrawingSettings settings;
  settings.max_wall = file.max_wall;
  settings.paper = PaperSize::A4;
  settings.is_numbered =
      wallsAmong(subjectsIn(report, std::numeric_limits<std::size_t>::max()));
  const std::vector<PlanStorey> storeys = storeysOf(plan);
  for (const PlanStorey& storey : storeys) {
    settings.storey = storeys.size() > 1 ? &storey : nullptr;
    const auto places = drawingPlaces(plan, settings).matrix();
    sheets.push_back({{"name", storey.name},
                      {"floor", storey.floor},
                      {"rooms", storey.rooms},
                      {"x", {places(0, 0), places(0, 1), places(0, 2)}},
                      {"y", {places(1, 0), places(1, 1), places(1, 2)}},
                      {"svg", drawFloorplan(plan, {DrawingFormat::Svg}, settings)[0]}});
  }
  return sheets;
}

Json
modelOf(const std::string& glb, std::size_t triangles, std::size_t shown)
{
  return {{"triangles", triangles},
          {"shown", shown},
          {"glb", base64(glb.data(), glb.size())}};
}

/** @brief Checks whether a report tells of the rooms of a plan, by number and area: a
 * plan that was edited has others. */
bool
tellsOf(const Json& report, const Floorplan& plan)
{
  constexpr double same_area = 0.005; // square metres
  const auto rooms = report.find("rooms");
  if (rooms == report.end())
    return true;
  return rooms->size() == plan.rooms.size() &&
         std::equal(plan.rooms.begin(), plan.rooms.end(), rooms->begin(),
                    [&](const PlanRoom& room, const Json& told) {
                      return told.value("id", 0U) == room.id &&
                             std::abs(told.value("area", 0.0) - room.area()) <=
                                 same_area;
                    });
}

/** @brief Returns everything the page shows. */
Json
pageData(const std::string& path, const PageSettings& settings)
{
  const ResultFolder folder(path);
  const fs::path full = fs::absolute(path).lexically_normal();
  const fs::path name = full.has_filename() ? full : full.parent_path();
  Json json{{"name", settings.name.empty() ? name.filename().string() : settings.name},
            {"report", folder.report()},
            {"plan", nullptr},
            {"drawings", Json::array()},
            {"files", fileNames(path)},
            {"colours", colours()},
            {"range", settings.range},
            {"models", Json::object()}};
  Floorplan plan;
  if (folder.has("floorplan.json")) {
    const PlanDocument file = loadPlan(folder.file("floorplan.json"));
    plan = file.plan;
    json["plan"] = Json::parse(textOfFile(folder.file("floorplan.json")));
    if (json["plan"].contains("doorways")) // of an earlier version: openings now
      json["plan"] = Json::parse(documentToJson(file));
    if (!tellsOf(folder.report(), plan)) {
      const char* const text =
          "floorplan.json is not the plan that report.json tells of: the report's "
          "figures are left out, and solid, mesh and points may be of the earlier plan";
      json["report"] = {{"doubts", {{{"text", text}}}}};
    }
    json["drawings"] = drawings(file, json["report"]);
  }
  const TriangleMesh mesh = folder.mesh("mesh.ply"); // triangles face into the rooms
  const TriangleMesh solid = folder.mesh("solid.ply");
  if (!solid.empty())
    json["models"]["solid"] =
        modelOf(folder.has("model.glb") ? textOfFile(folder.file("model.glb"))
                                        : meshToGlb(solid, plan),
                solid.triangles.size(), solid.triangles.size());
  if (!mesh.empty()) {
    TriangleMesh shown = reducedMesh(mesh, settings.max_triangles);
    shown.flip();
    json["models"]["mesh"] =
        modelOf(meshToGlb(shown, plan), mesh.triangles.size(), shown.triangles.size());
  }
  const std::string scan = settings.scan.empty() ? folder.scanPath() : settings.scan;
  if (scan.empty() && folder.has("structure.pcd"))
    warn("the page shows the points of structure.pcd in place of the scan: neither a "
         "folder above the model nor the working directory has it, with as many points "
         "as the report tells; pcl_sedr_report --scan names it");
  json["scan"] = pagePoints(folder, scan, plan, mesh, solid, settings.range);
  return json;
}

} // namespace

std::string
makePage(const std::string& path, const PageSettings& settings)
{
  std::string data =
      pageData(path, settings).dump(-1, ' ', false, Json::error_handler_t::replace);
  boost::replace_all(data, "<", "\\u003c"); // ends no script, starts no comment
  const std::pair<std::string, std::string> parts[] = {
      {"@page.css@", page_css},
      {"@data@", data},
      {"@three.js@", threeScripts(settings.three)},
      {"@texts.js@", texts_js},
      {"@model.js@", model_js},
      {"@page.js@", page_js}};
  std::string page = page_html;
  std::size_t place = 0;
  for (const auto& [name, text] : parts) { // in their order, none within another
    place = page.find(name, place);
    page.replace(place, name.size(), text);
    place += text.size();
  }
  return page;
}

std::string
writePage(const std::string& path, const PageSettings& settings)
{
  const std::string page = (fs::path(path) / "report.html").string();
  checkWritable(page);
  const std::string html = makePage(path, settings);
  writeWhole(page, [&](std::ostream& stream) { stream << html; });
  return page;
}

} // namespace pcl::sedr::tools
