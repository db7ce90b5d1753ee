// SPDX-License-Identifier: BSD-3-Clause
#include "bytes/whole_file.h"
#include "compare/change_mesh.h"
#include "compare/change_picture.h"
#include "compare/comparison.h"
#include "compare/plan_alignment.h"
#include "joint_scan.h"
#include "picture_file.h"
#include "plan_file.h"
#include "progress.h"
#include "run_tool.h"
#include "scale.h"
#include "scan_options.h"
#include "tool_error.h"

#include <pcl/common/angles.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <string>

using namespace pcl::sedr::tools;
using pcl::sedr::Floorplan;
using pcl::sedr::Origin;

namespace {

bool
endsIn(const std::string& path, const std::string& end)
{
  return path.size() > end.size() &&
         path.compare(path.size() - end.size(), end.size(), end) == 0;
}

/** @brief A plan and the origin of its coordinates. */
struct PlacedPlan {
  Floorplan plan;
  Origin origin;
};

/** @brief Returns the plan of a scan, as pcl_sedr finds it. */
PlacedPlan
planOfScan(const std::string& path, const ScanSettings& reading)
{
  const Progress progress("reconstructing " + path);
  pcl::IndoorStructureReconstruction<pcl::PointXYZ> chain;
  const auto scan =
      std::make_shared<JointScan>(std::vector<std::string>{path}, reading);
  chain.setInputSource(scan);
  if (!chain.findStructure())
    throw ToolError("'" + path + "': no structure found: " + chain.getErrorMessage(),
                    NothingFound);
  return {*chain.getFloorplan(), scan->origin()};
}

/** @brief Returns whether a path is that of a scan, not of a folder or plan file. */
bool
isScan(const std::string& path)
{
  std::error_code error;
  return !std::filesystem::is_directory(path, error) && !endsIn(path, ".json");
}

/** @brief Returns the plan of a folder of pcl_sedr, of a plan file, or of a scan. */
PlacedPlan
planOf(const std::string& path, const ScanSettings& reading)
{
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    const auto plan = std::filesystem::path(path) / "floorplan.json";
    if (!std::filesystem::exists(plan, error))
      throw ToolError("'" + path +
                      "' holds no floorplan.json, which pcl_sedr writes; a scan is "
                      "named by its file");
    return {*loadFloorplan(plan.string()), planOrigin(plan.string())};
  }
  if (!isScan(path))
    return {*loadFloorplan(path), planOrigin(path)};
  return planOfScan(path, reading);
}

/** @brief Returns a plan relative to another origin. */
Floorplan
inFrameOf(const Origin& origin, const PlacedPlan& placed)
{
  if (placed.origin == origin)
    return placed.plan;
  PlanTransform shift;
  shift.shift = placed.origin.place - origin.place;
  return transformed(placed.plan, shift);
}

/** Metres, how rough the alignment of two plans may be before --align. */
constexpr double reach = 0.5;

/** @brief The options of the command line. */
struct Settings {
  std::string before;
  std::string after;
  ScanOptions reading; ///< of scans
  bool align = false;
  std::string mesh;
  std::string json;
  std::string picture;
  CompareSettings compare;
};

void
addOptions(Options& options, Settings& s)
{
  options.file(
      "A", s.before,
      "model before: a folder that pcl_sedr has left, a floor plan (.json), or "
      "a scan");
  options.file("B", s.after, "model after, likewise, in the same frame");
  addScanOptions(options, s.reading);
  options.number("tolerance", s.compare.tolerance, "m",
                 "what is less off its place has not moved", Range::between(0.001, 1));
  options.flag("align", s.align, "refine a rough alignment of B first, by ICP");
  options.text("mesh", s.mesh,
               "PLY to write, in colours: green appeared, red vanished, orange moved");
  options.text("json", s.json, "JSON to write");
  addPictureOption(options, s.picture);
}

int
run(const Settings& settings)
{
  if (!settings.json.empty())
    checkJsonOutput(settings.json);
  checkPictureOutput(settings.picture);
  if (!settings.mesh.empty() && !endsIn(settings.mesh, ".ply"))
    throw ToolError("the mesh is written as PLY, '" + settings.mesh +
                    "' does not end in .ply");
  if (!settings.mesh.empty())
    checkWritable(settings.mesh);
  if (const std::string given = settings.reading.given();
      !given.empty() && !isScan(settings.before) && !isScan(settings.after))
    throw ToolError(given + " tells how a scan is read, and neither '" +
                    settings.before + "' nor '" + settings.after + "' is one");
  ScanSettings reading = settings.reading.resolved();
  const auto [before, origin] = planOf(settings.before, reading);
  reading.origin = origin; // one frame for both
  Floorplan after = inFrameOf(origin, planOf(settings.after, reading));
  if (settings.align) {
    const auto transform = alignPlans(after, before, reach);
    if (!transform)
      throw ToolError("'" + settings.after +
                          "' cannot be aligned: hardly a wall of it lies within " +
                          fixedText(reach, 2) + " m of one of '" + settings.before +
                          "' that faces the same way",
                      NothingFound);
    after = transformed(after, *transform);
    char text[120];
    std::snprintf(text, sizeof text,
                  "aligned: turned by %.2f degrees, shifted by x %+.3f, y %+.3f, z "
                  "%+.3f m\n",
                  pcl::rad2deg(transform->angle), transform->shift.x(),
                  transform->shift.y(), transform->shift.z());
    std::cout << text;
  }
  const auto changes = comparePlans(before, after, settings.compare);
  for (const auto& change : changes)
    std::cout << describe(change) << '\n';
  if (changes.empty())
    std::cout << "nothing has changed\n";
  if (!settings.json.empty())
    writeWhole(settings.json, [&](std::ostream& stream) {
      stream << changesToJson(changes, settings.compare);
    });
  if (!settings.mesh.empty())
    saveChangeMesh(settings.mesh, before, after, changes);
  if (!settings.picture.empty())
    savePicture(settings.picture, drawChanges(before, after, changes));
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Settings settings;
  Options options("pcl_structure_compare",
                  "Tells what has appeared, vanished and moved between two models of "
                  "the same rooms.");
  addOptions(options, settings);
  return runTool(options, argc, argv, [&] { return run(settings); });
}
