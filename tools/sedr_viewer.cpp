// SPDX-License-Identifier: BSD-3-Clause
#include "run_tool.h"
#include "scan_file.h"
#include "scan_options.h"
#include "tool_error.h"
#include "viewer/window.h"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>

using namespace pcl::sedr::tools;

namespace {

constexpr const char* raw_hint = "the raw scan of a folder is named by --raw";

/** @brief The options of the command line. */
struct Settings {
  std::string path;
  std::string screenshot;
  std::string size = "1200x800";
  std::string layers;
  bool no_legend = false;
  std::optional<double> clip; ///< metres
  ReadSettings reading;
  ScanOptions file;
  ViewState state;
};

void
addOptions(Options& options, Settings& s)
{
  options.file("INPUT", s.path,
               "folder that pcl_sedr has left; or a cloud, with label or room as a "
               "stage leaves it, or raw, as PCD, PLY, E57, LAS or text; or one of its "
               "meshes or plans");
  options.text("layers", s.layers,
               "what is shown, of scan, structure, mesh, solid, plan: one or more, "
               "with commas between; none given: mesh, or the next best");
  options.text("colour", s.state.colour, "what colours mean",
               {"label", "room", "distance", "height"});
  options.text("view", s.state.view, "where the camera stands",
               {"top", "iso", "inside"});
  options.flag("ceilings", s.state.ceilings, "show ceilings too");
  options.optionalNumber("clip", s.clip, "m", "height above which nothing is shown",
                         "none");
  options.number("storey", s.state.storey, "",
                 "number of the only storey shown; 0: all", Range::between(0, 1e6));
  options.number("room", s.state.room, "", "number of the only room shown; 0: all",
                 Range::between(0, 1e6));
  options.flag("two-views", s.state.two_views, "scan at the left, model at the right");
  options.flag("no-legend", s.no_legend, "no legend");
  options.number("point-size", s.state.point_size, "pixels", "size of points",
                 Range::between(1, 20));
  options.text("raw", s.reading.scan,
               "raw scan of a folder, where it is not where report.json says; it is "
               "read as it was then");
  addScanOptions(options, s.file);
  options.number("max-points", s.reading.max_points, "points",
                 "of a cloud that are shown, 0 for all", Range::atLeast(0));
  options.text("screenshot", s.screenshot, "PNG to write instead of opening a window");
  options.text("size", s.size, "width and height of window or screenshot, pixels");
}

WindowSettings
windowSettings(const Settings& settings)
{
  WindowSettings window;
  char rest = 0;
  if (std::sscanf(settings.size.c_str(), "%dx%d%c", &window.width, &window.height,
                  &rest) != 2 ||
      std::min(window.width, window.height) < 100 ||
      std::max(window.width, window.height) > 8000)
    throw ToolError("--size takes width and height as in 1200x800, each from 100 to "
                    "8000 pixels, not '" +
                    settings.size + "'");
  window.is_visible = settings.screenshot.empty();
  if (!window.is_visible &&
      std::filesystem::path(settings.screenshot).extension() != ".png")
    throw ToolError("a picture is written as PNG, '" + settings.screenshot +
                    "' does not end in .png");
  return window;
}

std::set<std::string>
layersOf(const std::string& names)
{
  std::set<std::string> layers;
  std::istringstream list(names);
  for (std::string name; std::getline(list, name, ',');) {
    if (std::count(layer_names.begin(), layer_names.end(), name) == 0)
      throw ToolError("there is no layer '" + name +
                      "'; there are: " + boost::join(layer_names, ", "));
    layers.insert(name);
  }
  return layers;
}

/** @brief Throws a ToolError if an option has nothing to act on. */
void
checkOptions(const Settings& settings)
{
  std::error_code error;
  const bool is_folder = std::filesystem::is_directory(settings.path, error);
  const bool is_plan = std::filesystem::path(settings.path).extension() == ".json";
  const std::string given = settings.file.given();
  if (!given.empty() && (is_folder || is_plan ||
                         readScanHead(settings.path, settings.file.resolved()).is_mesh))
    throw ToolError(given + " tells how a scan is read, and '" + settings.path +
                    "' is none; " + raw_hint);
  if (!settings.reading.scan.empty() && !is_folder)
    throw ToolError("--raw names the raw scan of a folder that pcl_sedr has left, '" +
                    settings.path + "' is none");
}

/** @brief Throws a ToolError if the only storey or room to be shown does not exist. */
void
checkState(const ViewState& state, const ViewedResult& result)
{
  if (state.storey != 0 && !result.rules.find(state.storey))
    throw ToolError("there is no storey " + std::to_string(state.storey) +
                    ": the plan has " + std::to_string(result.rules.storeys().size()));
  if (state.room != 0 && result.rules.boxOf(state.room).isEmpty())
    throw ToolError("there is no room " + std::to_string(state.room) + " in the plan");
}

int
run(const Settings& settings)
{
  checkOptions(settings);
  const WindowSettings window_settings = windowSettings(settings);
  ViewState state = settings.state;
  state.layers = layersOf(settings.layers);
  state.legend = !settings.no_legend;
  state.clip_height = settings.clip.value_or(state.clip_height);
  requireDisplay();
  ReadSettings reading = settings.reading;
  reading.file = settings.file.resolved();
  const ViewedResult result = readResult(settings.path, reading);
  for (const auto& note : result.notes)
    say("pcl_sedr_viewer: " + note);
  checkState(state, result);
  for (const char* layer : {"mesh", "solid", "structure", "plan", "scan"})
    if (state.layers.empty() && result.has(layer))
      state.layers = {layer};
  Window window(result, state, window_settings);
  if (settings.screenshot.empty()) {
    say(window.help());
    window.run();
  }
  else
    window.saveScreenshot(settings.screenshot);
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Settings settings;
  Options options(
      "pcl_sedr_viewer",
      "Shows what pcl_sedr has left, or a cloud of one of its stages: from "
      "all sides, from inside, by\nlabel, room or distance. Key h tells all "
      "keys.");
  addOptions(options, settings);
  return runTool(options, argc, argv, [&] { return run(settings); });
}
