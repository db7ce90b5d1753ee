// SPDX-License-Identifier: BSD-3-Clause
#include "scan_options.h"

#include "plan_file.h"
#include "run_tool.h"
#include "scan_file.h"
#include "tool_cloud.h"
#include "tool_error.h"

#include "bytes/input_file.h"
#include "formats/scan_formats.h"

#include <filesystem>
#include <utility>

namespace pcl::sedr::tools {

namespace {

/** @brief Returns the origin that a folder of pcl_sedr, a JSON file, a comment in the
 * head of another file or the VIEWPOINT of a PCD states. */
std::optional<Origin>
statedOrigin(const std::string& path)
{
  namespace fs = std::filesystem;
  std::error_code error;
  if (fs::is_directory(path, error)) {
    const fs::path plan = fs::path(path) / "floorplan.json";
    if (!fs::exists(plan, error))
      throw ToolError("'" + path + "' holds no floorplan.json, which pcl_sedr writes");
    return statedOrigin(plan.string());
  }
  constexpr int max_lines = 20; // in a header
  constexpr std::size_t max_bytes = 256;
  if (fs::path(path).extension() == ".json")
    return statedPlanOrigin(path);
  const InputFile file(path);
  LineReader lines(file);
  Origin origin;
  std::string_view line;
  for (int k = 0; k < max_lines && lines.next(line); ++k)
    if (Origin::fromComment(std::string(line.substr(0, max_bytes)), origin))
      return origin;
  if (!looksLikePcd(file))
    return std::nullopt;
  ScanSettings as_it_is;
  as_it_is.shifts = false;
  origin = ScanFile(path, as_it_is).origin();
  return origin.isZero() ? std::nullopt : std::make_optional(origin);
}

} // namespace

Origin
originOfModel(const std::string& path)
{
  return statedOrigin(path).value_or(Origin());
}

ScanSettings
ScanOptions::resolved() const
{
  ScanSettings all = settings;
  Origin given;
  if (origin.empty())
    return all;
  std::error_code error;
  if (Origin::fromText(origin, given))
    all.origin = given;
  else if (std::filesystem::exists(origin, error))
    all.origin = statedOrigin(origin);
  if (!all.origin)
    throw ToolError("'" + origin +
                    "' states no origin: --origin takes x,y,z, or a "
                    "folder that pcl_sedr wrote, its floorplan.json or report.json");
  return all;
}

std::string
ScanOptions::given() const
{
  const std::pair<const char*, bool> options[] = {
      {"--scan", settings.scan != 0},           {"--skip-broken", settings.skip_broken},
      {"--columns", !settings.columns.empty()}, {"--unit", settings.unit.has_value()},
      {"--up", !settings.up.empty()},           {"--origin", !origin.empty()}};
  for (const auto& [name, is_given] : options)
    if (is_given)
      return name;
  return "";
}

void
addScanOptions(Options& options, ScanOptions& scan)
{
  options.optionalNumber("unit", scan.settings.unit, "m",
                         "length of one unit of the scan: 0.001 for millimetres, "
                         "0.3048 for feet",
                         "1", Range::between(1e-6, 1e6));
  options.text("up", scan.settings.up,
               "axis of the scan that is up; it becomes z, with which all results and "
               "--origin are; else z, unless another is far likelier",
               {"x", "-x", "y", "-y", "z", "-z"});
  options.text("origin", scan.origin,
               "x,y,z in m that coordinates are counted from, or a model whose origin "
               "is taken; whole metres in the middle of scans that lie more than 1 km "
               "from 0, else 0,0,0");
  options.number("scan", scan.settings.scan, "",
                 "number of the scan of an E57 file that is read, 0 = all",
                 Range::atLeast(0));
  options.flag("skip-broken", scan.settings.skip_broken,
               "leave out the scans of an E57 file that cannot be read");
  options.text("columns", scan.settings.columns,
               "names of the columns of a text, such as "
               "x,y,z,intensity,red,green,blue; a column "
               "without a use is _: _,x,y,z if the first numbers the points");
}

void
addPositionsOption(Options& options, ScanOptions& scan)
{
  options.text("positions", scan.settings.positions,
               "text of the scanner's positions: a line each of x y z, in the unit and "
               "frame of the scan, and how many points are from there, in their order; "
               "else as an E57 or a PCD tells them");
}

} // namespace pcl::sedr::tools
