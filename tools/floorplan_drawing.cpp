// SPDX-License-Identifier: BSD-3-Clause
#include "model/solid_files.h"
#include "plan_file.h"
#include "run_tool.h"
#include "tool_error.h"

#include <pcl/sedr_filters/storeys.h>

#include <algorithm>
#include <cstdint>
#include <string>

using namespace pcl::sedr::tools;
using pcl::sedr::Floorplan;

namespace {

/** @brief The sheet of one storey. */
DrawingSheet
sheetOf(const std::string& output, const Floorplan& plan, std::uint32_t number)
{
  std::string known;
  for (const auto& storey : pcl::sedr::storeysOf(plan)) {
    if (storey.number == number)
      return {output, storey};
    known += (known.empty() ? "" : ", ") + std::to_string(storey.number);
  }
  throw ToolError("there is no storey " + std::to_string(number) +
                  " in the plan; there are: " + known);
}

} // namespace

int
main(int argc, char** argv)
{
  std::string plan;
  std::string output;
  double scale = 0;
  std::size_t storey = 0;
  Options options("pcl_floorplan_drawing", "Draws a floor plan to scale.");
  options.file("PLAN.json", plan,
               "floor plan, as pcl_sedr and pcl_floorplan_fitting "
               "write it");
  options.file("OUTPUT", output,
               "drawing to write: .svg, or .dxf (AutoCAD R12, one unit a metre); of "
               "several storeys one each, with its number before the extension");
  options.number("scale", scale, "", "50 for 1:50, of an SVG; 0: what fits an A4 page",
                 Range::between(0, 1e6));
  options.number("storey", storey, "", "draw this one only, to OUTPUT; 0: all",
                 Range::between(0, 1e6));
  return runTool(options, argc, argv, [&] {
    checkDrawingOutput(output);
    const auto drawn = loadFloorplan(plan);
    const auto origin = planOrigin(plan);
    if (storey > 0) {
      saveDrawing(sheetOf(output, *drawn, static_cast<std::uint32_t>(storey)), *drawn,
                  scale, origin);
      return Done;
    }
    const auto sheets = drawingSheets(output, *drawn);
    for (const DrawingSheet& sheet : sheets)
      checkDrawingOutput(sheet.path);
    for (const DrawingSheet& sheet : sheets)
      saveDrawing(sheet, *drawn, scale, origin);
    return Done;
  });
}
