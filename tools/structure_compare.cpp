// SPDX-License-Identifier: BSD-3-Clause
#include "bytes/whole_file.h"
#include "compare/comparison.h"
#include "plan_file.h"
#include "run_tool.h"
#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include "stage_pictures.h"
#include "tool_error.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <string>

using namespace pcl::sedr::tools;
using pcl::sedr::Floorplan;

namespace {

/** @brief Returns the plan of a folder of pcl_sedr, or of a plan file. */
pcl::sedr::PlanDocument
planOf(const std::string& path)
{
  std::error_code error;
  return loadPlan(std::filesystem::is_directory(path, error)
                      ? (std::filesystem::path(path) / "floorplan.json").string()
                      : path);
}

constexpr Colour
colourOf(ChangeKind kind)
{
  return kind == ChangeKind::Appeared   ? 0x28a046
         : kind == ChangeKind::Vanished ? 0xd22828
                                        : 0xf0961e;
}

/** @brief Draws both plans on top of each other, the first one faint, and the changes
 * in colours: walls as lines; columns, details and rooms as outlines. */
Picture
drawChanges(const Floorplan& before,
            const Floorplan& after,
            const std::vector<Change>& changes)
{
  const Eigen::Vector2d above(0, 0.35); // metres, from the named outline
  Panel panel("plan, the first one faint", viewOf({&before, &after}));
  panel.addPlan(before, 1.5, colours::faint);
  panel.addPlan(after, 1.5, colours::ink);
  std::map<ChangeKind, std::size_t> counts;
  for (const auto& change : changes) {
    ++counts[change.kind];
    panel.addLines(change.outlines, colourOf(change.kind), 3.5);
    if (!change.outlines.empty())
      panel.labels.emplace_back(pcl::sedr::boundsOf(change.outlines.back()).center() +
                                    above,
                                change.what + " " + toString(change.kind));
  }
  Picture picture{counted(changes.size(), "change"), {panel}};
  for (const auto kind :
       {ChangeKind::Appeared, ChangeKind::Vanished, ChangeKind::Moved})
    picture.legend.emplace_back(std::string(toString(kind)) + ": " +
                                    std::to_string(counts[kind]),
                                colourOf(kind));
  return picture;
}

/** @brief Warns if nearly all walls have moved alike, or most rooms of both plans are
 * where the other one has none: that is hardly one building in one frame. */
void
warnOfFrames(const Floorplan& before,
             const Floorplan& after,
             const std::vector<Change>& changes,
             const CompareSettings& settings)
{
  if (const auto shift = commonShift(before, changes, settings))
    warn("walls have moved as if all of the second model were shifted by (" +
         pcl::sedr::decimalText(shift->x(), 2) + ", " +
         pcl::sedr::decimalText(shift->y(), 2) + ") m: is it in the same frame?");
  const auto roomsThat = [&](ChangeKind kind) {
    return static_cast<std::size_t>(
        std::count_if(changes.begin(), changes.end(), [kind](const Change& change) {
          return change.kind == kind && change.what == "room";
        }));
  };
  const std::size_t vanished = roomsThat(ChangeKind::Vanished);
  const std::size_t appeared = roomsThat(ChangeKind::Appeared);
  if (2 * vanished > before.rooms.size() && 2 * appeared > after.rooms.size())
    warn(std::to_string(vanished) + " of " + counted(before.rooms.size(), "room") +
         " have vanished, and of " + counted(after.rooms.size(), "room") + " after " +
         std::to_string(appeared) +
         " were not there: are both models of one building, in one frame?");
}

/** @brief The options of the command line. */
struct Settings {
  std::string before;
  std::string after;
  std::string json;
  PictureFile picture;
  CompareSettings compare;
};

void
addOptions(Options& options, Settings& s)
{
  options.file(
      "A", s.before,
      "model before: a folder that pcl_sedr has left, or a floor plan (.json)");
  options.file("B", s.after, "model after, likewise, in the same frame");
  options.number("tolerance", s.compare.tolerance, "m",
                 "what is less off its place has not moved", Range::between(0.001, 1));
  options.text("json", s.json, "JSON to write");
  s.picture.declare(options);
}

int
run(const Settings& settings)
{
  if (!settings.json.empty())
    checkOutput(settings.json, "a list of changes", {".json"});
  settings.picture.check();
  const pcl::sedr::PlanDocument first = planOf(settings.before);
  const pcl::sedr::PlanDocument second = planOf(settings.after);
  const Floorplan& before = first.plan;
  const Floorplan after =
      moved(second.plan, 0, second.origin.place - first.origin.place);
  const auto changes = comparePlans(before, after, settings.compare);
  warnOfFrames(before, after, changes, settings.compare);
  for (const auto& change : changes)
    std::cout << describe(change) << '\n';
  if (changes.empty())
    std::cout << "nothing has changed by more than " << settings.compare.tolerance
              << " m; widths of openings are not compared\n";
  if (!settings.json.empty())
    writeWhole(settings.json, changesToJson(changes, settings.compare));
  settings.picture.write([&] { return drawChanges(before, after, changes); });
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
