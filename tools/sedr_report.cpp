// SPDX-License-Identifier: BSD-3-Clause
#include "report/report_page.h"
#include "run_tool.h"
#include "tool_error.h"

#include <string>

using namespace pcl::sedr::tools;

int
main(int argc, char** argv)
{
  std::string folder;
  PageSettings settings;
  Options options("pcl_sedr_report",
                  "Writes report.html into a folder that pcl_sedr has left: plan, "
                  "rooms, model, distances and stages on one\npage that loads nothing "
                  "from anywhere.");
  options.file("OUTPUT_DIR", folder, "folder that pcl_sedr has left");
  options.text("scan", settings.scan,
               "raw scan, where it is in no folder above and not in this one");
  options.text("three", settings.three, "folder of three.js, Debian's libjs-three");
  options.number("max-triangles", settings.max_triangles, "triangles",
                 "of the mesh that can be turned on the page", Range::atLeast(100));
  return runTool(options, argc, argv, [&] {
    const Progress progress("writing the page");
    writePage(folder, settings);
    return Done;
  });
}
