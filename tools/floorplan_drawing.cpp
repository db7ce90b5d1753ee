// SPDX-License-Identifier: BSD-3-Clause
#include "bytes/whole_file.h"
#include "model/solid_files.h"
#include "plan_file.h"
#include "results/result_folder.h"
#include "run_tool.h"
#include "tool_error.h"

#include "sedr_filters/src/plan/missing_things.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace pcl::sedr::tools;
using pcl::sedr::Floorplan;
using pcl::sedr::SectionLine;

namespace {

/** @brief Reads where a section runs: x,y,x,y, or through rooms or stairs of the plan.
 */
SectionLine
sectionOf(const std::string& text, const Floorplan& plan)
{
  if (text == "rooms")
    return pcl::sedr::sectionThroughRooms(plan);
  if (text == "stairs") {
    if (const auto line = pcl::sedr::sectionThroughStairs(plan))
      return *line;
    throw ToolError("the plan has no stair whose flights were seen");
  }
  SectionLine line;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%lf,%lf,%lf,%lf%c", &line.from.x(), &line.from.y(),
                  &line.to.x(), &line.to.y(), &rest) != 4 ||
      !line.from.allFinite() || !line.to.allFinite() || line.from == line.to)
    throw ToolError("a section is 'rooms', 'stairs' or two different places, x,y,x,y; "
                    "not '" +
                    text + "'");
  return line;
}

/** @brief What a scan shows of a wall, see report.json. */
struct WallMap {
  double start = 0; ///< of the wall, from that of the map, metres
  double base = 0;
  double cell = 0;
  long columns = 0;
  long rows = 0;
  std::string cells; ///< row by row from the top

  bool isUnseen(double along, double height) const
  {
    const long column = std::lround(std::floor((start + along) / cell));
    const long row = rows - 1 - std::lround(std::floor((height - base) / cell));
    if (column < 0 || column >= columns || row < 0 || row >= rows)
      return false;
    const char state = cells[static_cast<std::size_t>(row * columns + column)];
    return state == 'h' || state == 'e';
  }
};

/** @brief Returns a text whose runs are written as their lengths and letters. */
std::string
withoutRuns(const std::string& runs)
{
  std::istringstream stream(runs);
  std::string text;
  std::size_t length = 0;
  for (char letter = 0; stream >> length >> letter;)
    text.append(length, letter);
  return text;
}

/** @brief Returns which places of walls a scan did not show: hidden, or without points,
 * as the maps of walls in a report.json tell, see DrawingSettings::is_unseen. Empty if
 * there is none. */
std::function<bool(std::uint32_t, std::size_t, double, double)>
unseenPlaces(const nlohmann::ordered_json& report, const Floorplan& plan)
{
  std::map<std::pair<std::uint32_t, std::size_t>, WallMap> maps;
  for (const auto& told : report.value("walls", nlohmann::ordered_json::array())) {
    WallMap map{0,
                told.value("base", 0.0),
                told.value("cell", 0.0),
                told.value("columns", 0L),
                told.value("rows", 0L),
                withoutRuns(told.value("cells", ""))};
    const pcl::sedr::PlanRoom* const room = findRoom(plan, told.value("room", 0U));
    if (!room || !(map.cell > 0) ||
        map.cells.size() != static_cast<std::size_t>(map.columns * map.rows))
      continue;
    for (const std::size_t wall : told.value("walls", std::vector<std::size_t>())) {
      if (wall < 1 || wall > room->boundary.elements.size())
        break;
      maps[{room->id, wall - 1}] = map;
      map.start += room->boundary.elements[wall - 1].length();
    }
  }
  if (maps.empty())
    return {};
  return [maps](std::uint32_t room, std::size_t wall, double along, double height) {
    const auto map = maps.find({room, wall});
    return map != maps.end() && map->second.isUnseen(along, height);
  };
}

/** @brief Names of PaperSize, in its order. */
const std::vector<std::string> paper_names{"A4", "A3", "A2", "A1", "A0"};

pcl::sedr::PaperSize
paperNamed(const std::string& name)
{
  const auto at = std::find(paper_names.begin(), paper_names.end(), name);
  return static_cast<pcl::sedr::PaperSize>(at - paper_names.begin());
}

} // namespace

int
main(int argc, char** argv)
{
  std::string plan;
  std::string output;
  pcl::sedr::DrawingSettings settings;
  std::string paper = "A3";
  std::uint32_t storey = 0;
  bool is_ceiling = false;
  std::string section;
  std::uint32_t room = 0;
  bool has_wall_numbers = false;
  Options options("pcl_floorplan_drawing", "Draws a floor plan to scale.");
  options.file("PLAN.json", plan,
               "floor plan, as pcl_sedr and pcl_floorplan_fitting "
               "write it");
  options.file(
      "OUTPUT", output,
      "drawing to write: .svg, .pdf, or .dxf (AutoCAD 2013, one unit a metre); "
      "of several storeys one each, with its number before the extension");
  options.number("scale", settings.scale, "", "50 for 1:50; 0: what fits the paper",
                 Range::between(0, 1e6));
  options.text("paper", paper, "smallest paper of the sheet", paper_names);
  addSheetTexts(options, settings.texts);
  options.flag("ceiling", is_ceiling, "draw the reflected ceiling plan instead");
  options.flag("wall-numbers", has_wall_numbers,
               "write the numbers of walls, which warnings name");
  options.number("storey", storey, "", "draw this one only, to OUTPUT; 0: all",
                 Range::between(0, 1e6));
  options.text("section", section,
               "draw a section instead: through most \"rooms\", through \"stairs\", or "
               "x,y,x,y");
  options.number("elevations", room, "",
                 "draw the walls of this room instead; 0: the plan",
                 Range::between(0, 1e6));
  return runTool(options, argc, argv, [&] {
    checkDrawingOutput(output);
    if (has_wall_numbers)
      settings.is_numbered = [](std::uint32_t, std::size_t) { return true; };
    const pcl::sedr::PlanDocument file = loadPlan(plan);
    const Floorplan& drawn = file.plan;
    const auto report = reportBeside(plan);
    settings.texts = filledIn(settings.texts, report);
    settings.origin = file.origin;
    settings.max_wall = file.max_wall;
    settings.paper = paperNamed(paper);
    settings.view =
        is_ceiling ? pcl::sedr::DrawingView::Ceiling : pcl::sedr::DrawingView::Floor;
    if (!section.empty()) {
      if (!saveDrawing({{output}, {}, {}, sectionOf(section, drawn)}, drawn, settings))
        throw ToolError("the section " + section + " cuts no room of the plan");
      return Done;
    }
    if (room > 0) {
      if (!findRoom(drawn, room))
        throw ToolError(lacksRoom(drawn, room));
      settings.is_unseen = unseenPlaces(report, drawn);
      writeWhole(output, drawElevations(drawn, room, {formatOf(output)}, settings)[0]);
      return Done;
    }
    settings.sections = sectionsOf(allDrawings(drawn));
    std::vector<DrawingSheet> sheets = drawingSheets({output}, drawn, settings.view);
    if (storey > 0) {
      const std::vector<pcl::sedr::PlanStorey> storeys = storeysOf(drawn);
      const pcl::sedr::PlanStorey* const one = findStorey(storeys, storey);
      if (!one)
        throw ToolError(lacksStorey(storeys, storey));
      sheets = {{{output}, *one, settings.view, {}}};
    }
    for (const DrawingSheet& sheet : sheets)
      checkDrawingOutput(sheet.paths[0]);
    for (const DrawingSheet& sheet : sheets)
      saveDrawing(sheet, drawn, settings);
    return Done;
  });
}
