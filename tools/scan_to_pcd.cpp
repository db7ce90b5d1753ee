// SPDX-License-Identifier: BSD-3-Clause
#include "e57/e57_reader.h"
#include "run_tool.h"
#include "scan_file.h"
#include "scan_options.h"
#include "tool_cloud.h"
#include "tool_error.h"

#include <cstdio>

using namespace pcl::sedr::tools;

namespace {

struct Settings {
  std::string input;
  std::string output;
  bool list = false;
  ScanOptions scan;
};

/** @brief Prints a line for each scan. */
void
listScans(const std::string& path)
{
  constexpr std::size_t longest_name = 100;
  const std::vector<E57Entry> entries = listE57Scans(path);
  std::printf("scan     points position, m                         name\n");
  for (const auto& [scan, problem] : entries) {
    const std::string position =
        scan.has_pose ? pcl::sedr::Origin{scan.translation}.text(", ") : "not told";
    std::printf("%4zu %10llu %-35s %s%s%s\n", scan.number,
                static_cast<unsigned long long>(scan.points), position.c_str(),
                plainText(scan.name, longest_name).c_str(),
                problem.empty() ? "" : " broken: ", plainText(problem).c_str());
  }
}

int
run(const Settings& settings)
{
  const std::string given = settings.scan.given();
  if (settings.list && !(settings.output.empty() && given.empty()))
    throw ToolError("--list reads no points, it takes no " +
                    (given.empty() ? "OUTPUT" : given));
  if (!settings.list && settings.output.empty())
    throw ToolError("the name of the PCD to write is missing; --list names the scans "
                    "of an E57 file");
  if (settings.list) {
    listScans(settings.input);
    return Done;
  }
  checkCloudOutput(settings.output);
  const ScanFile scan(settings.input, settings.scan.resolved());
  saveScan(settings.output, scan, scan);
  say(std::to_string(scan.size()) + " points");
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Settings settings;
  Options options(
      "pcl_scan_to_pcd",
      "Writes a scan of any format as PCD or PLY with x, y, z and, where "
      "they are there, intensity and rgb; of an E57 file all scans, each in "
      "its place.");
  options.file("INPUT", settings.input,
               "PCD, PLY, E57, LAS or text to read; - is the standard input");
  options.optionalFile("OUTPUT", settings.output,
                       "PCD or PLY to write, not needed with --list");
  options.flag("list", settings.list,
               "print number, points, position and name of every scan of an E57 file "
               "instead");
  addScanOptions(options, settings.scan);
  return runTool(options, argc, argv, [&] { return run(settings); });
}
