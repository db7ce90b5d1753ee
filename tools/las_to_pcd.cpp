// SPDX-License-Identifier: BSD-3-Clause
#include "run_tool.h"
#include "scan_options.h"
#include "tool_error.h"

using namespace pcl::sedr::tools;

int
main(int argc, char** argv)
{
  std::string input;
  std::string output;
  ScanOptions scan;
  Options options("pcl_las_to_pcd",
                  "Writes a LAS file, or columns of text, as PCD or PLY with x, y, z "
                  "and, where they are there, intensity and rgb.");
  options.file("INPUT.las", input,
               "LAS 1.0 to 1.4, .xyz, .txt, .pts or .csv; - is the standard input");
  options.file("OUTPUT", output, "PCD or PLY to write");
  addScanOptions(options, scan);
  addDoublesOption(options, scan);
  return runTool(options, argc, argv, [&] {
    convertScan(input, output, scan);
    return Done;
  });
}
