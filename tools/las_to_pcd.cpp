// SPDX-License-Identifier: BSD-3-Clause
#include "run_tool.h"
#include "scan_file.h"
#include "scan_options.h"
#include "tool_cloud.h"
#include "tool_error.h"

using namespace pcl::sedr::tools;

namespace {

struct Settings {
  std::string input;
  std::string output;
  ScanOptions scan;
};

int
run(const Settings& settings)
{
  checkCloudOutput(settings.output);
  const ScanFile scan(settings.input, settings.scan.resolved());
  saveScan(settings.output, scan);
  say(std::to_string(scan.size()) + " points");
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Settings settings;
  Options options("pcl_las_to_pcd",
                  "Writes a LAS file, or columns of text, as PCD or PLY with x, y, z "
                  "and, where they are there, intensity and rgb.");
  options.file("INPUT.las", settings.input,
               "LAS 1.0 to 1.4, .xyz, .txt, .pts or .csv; - is the standard input");
  options.file("OUTPUT", settings.output, "PCD or PLY to write");
  addScanOptions(options, settings.scan);
  addDoublesOption(options, settings.scan);
  return runTool(options, argc, argv, [&] { return run(settings); });
}
