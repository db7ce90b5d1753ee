// SPDX-License-Identifier: BSD-3-Clause
#include "plan_file.h"
#include "run_tool.h"
#include "sedr/solid_files.h"
#include "tool_error.h"

#include <string>

using namespace pcl::sedr::tools;

int
main(int argc, char** argv)
{
  std::string plan;
  std::string output;
  double scale = 0;
  Options options("pcl_floorplan_drawing", "Draws a floor plan to scale.");
  options.file("PLAN.json", plan,
               "floor plan, as pcl_sedr and pcl_floorplan_fitting "
               "write it");
  options.file("OUTPUT", output,
               "drawing to write: .svg, or .dxf (AutoCAD R12, one unit a metre)");
  options.number("scale", scale, "", "50 for 1:50, of an SVG; 0: what fits an A4 page",
                 Range::between(0, 1e6));
  return runTool(options, argc, argv, [&] {
    checkDrawingOutput(output);
    saveDrawing(output, *loadFloorplan(plan), scale);
    return Done;
  });
}
