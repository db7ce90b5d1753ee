// SPDX-License-Identifier: BSD-3-Clause
#include "bytes/whole_file.h"
#include "run_tool.h"
#include "tool_error.h"
#include "viewer/window.h"

#include "sedr_filters/src/plan/missing_things.h"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>

using namespace pcl::sedr::tools;

namespace {

/** @brief The options of the command line. */
struct Settings {
  std::string path;
  std::string screenshot;
  std::string size = "1200x800";
  std::string layers;
  bool no_legend = false;
  std::optional<double> clip; ///< metres
  ReadSettings reading;
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
               "what is shown, of scan, structure, mesh, solid, plan, openings: one or "
               "more, with commas between; none given: mesh, or the next best");
  options.text("colour", s.state.colour, "what colours mean",
               {"label", "room", "distance", "height"});
  options.text("view", s.state.view, "where the camera stands", {"top", "iso"});
  options.flag("ceilings", s.state.ceilings, "show ceilings too");
  options.optionalNumber("clip", s.clip, "m", "height above which nothing is shown",
                         "none");
  options.number("storey", s.state.storey, "",
                 "number of the only storey shown; 0: all", Range::between(0, 1e6));
  options.number("room", s.state.room, "", "number of the only room shown; 0: all",
                 Range::between(0, 1e6));
  options.flag("no-legend", s.no_legend, "no legend");
  options.text(
      "raw", s.reading.scan,
      "raw scan of a folder, where it is in no folder above and not in this one; it is "
      "read as it was then");
  options.number("max-points", s.reading.max_points, "points",
                 "of a cloud that are shown, 0 for all", Range::atLeast(0));
  options.text("screenshot", s.screenshot, "PNG to write instead of opening a window");
  options.text("size", s.size, "width and height of window or screenshot, pixels");
}

/** @brief Returns width and height in pixels. */
std::pair<int, int>
sizeOf(const std::string& text)
{
  std::pair<int, int> size;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &size.first, &size.second, &rest) != 2 ||
      std::min(size.first, size.second) < 100 ||
      std::max(size.first, size.second) > 8000)
    throw ToolError("--size takes width and height as in 1200x800, each from 100 to "
                    "8000 pixels, not '" +
                    text + "'");
  return size;
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

int
run(const Settings& settings)
{
  std::error_code error;
  if (!settings.reading.scan.empty() &&
      !std::filesystem::is_directory(settings.path, error))
    throw ToolError("--raw names the raw scan of a folder that pcl_sedr has left, '" +
                    settings.path + "' is none");
  const auto [width, height] = sizeOf(settings.size);
  if (!settings.screenshot.empty())
    checkOutput(settings.screenshot, "a picture", {".png"});
  ViewState state = settings.state;
  state.layers = layersOf(settings.layers);
  state.legend = !settings.no_legend;
  state.clip_height = settings.clip.value_or(state.clip_height);
  requireDisplay();
  const ViewedResult result = readResult(settings.path, settings.reading);
  for (const auto& note : result.notes)
    say("pcl_sedr_viewer: " + note);
  const auto& storeys = result.rules.storeys();
  if (state.storey != 0 && !findStorey(storeys, state.storey))
    throw ToolError(pcl::sedr::lacksStorey(storeys, state.storey));
  if (state.room != 0 && result.rules.boxOf(state.room).isEmpty())
    throw ToolError("there is no room " + std::to_string(state.room) + " in the plan");
  for (const char* layer : {"mesh", "solid", "structure", "plan", "scan"})
    if (state.layers.empty() && result.has(layer))
      state.layers = {layer};
  Window window(result, state, width, height, settings.screenshot.empty());
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
      "Shows what pcl_sedr has left, or a cloud of one of its stages, by label, room "
      "or distance.\nKey h tells all keys.");
  addOptions(options, settings);
  return runTool(options, argc, argv, [&] { return run(settings); });
}
