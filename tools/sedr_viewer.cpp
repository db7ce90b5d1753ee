// SPDX-License-Identifier: BSD-3-Clause
#include "picture_file.h"
#include "run_tool.h"
#include "scan_file.h"
#include "scan_options.h"
#include "tool_error.h"
#include "viewer/keys.h"
#include "viewer/window/display.h"
#include "viewer/window/window.h"

#include <cstdio>
#include <filesystem>
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
  std::string colour = "label";
  std::string view = "iso";
  bool no_ceiling = false;
  bool no_edges = false;
  bool no_legend = false;
  std::optional<double> clip; ///< metres
  std::size_t storey = 0;
  double range = 0.05; ///< metres
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
               "what is shown, of raw, thinned, structure, plan, mesh, solid: one or "
               "more, with commas between; none given: mesh, or the next best");
  options.text("colour", s.colour, "what colours mean", colouringNames());
  options.text("view", s.view, "where the camera stands", viewPointNames());
  options.flag("no-ceiling", s.no_ceiling, "look inside: leave the ceilings out");
  options.optionalNumber("clip", s.clip, "m", "height above which nothing is shown",
                         "none");
  options.number("storey", s.storey, "", "number of the only storey shown; 0: all",
                 Range::between(0, 1e6));
  options.flag("two-views", s.state.two_views, "scan at the left, model at the right");
  options.flag("no-edges", s.no_edges, "no edges on the solid");
  options.flag("no-legend", s.no_legend, "no legend");
  options.number("point-size", s.state.point_size, "pixels", "size of points",
                 Range::between(1, 20));
  options.number("range", s.range, "m", "distance of the last colour",
                 Range::between(1e-4, 100));
  options.text(
      "raw", s.reading.scan,
      "raw scan of a folder, where it is not where report.json says; it is read "
      "as it was then");
  addScanOptions(options, s.file);
  options.hint("scan", raw_hint);
  options.number("max-points", s.reading.max_points, "points",
                 "of a cloud that are shown, 0 for all", Range::atLeast(0));
  options.text("screenshot", s.screenshot, "PNG to write instead of opening a window");
  options.text("size", s.size, "width and height of window or screenshot, pixels");
}

WindowSettings
windowSettings(const Settings& settings)
{
  constexpr int least = 100; // pixels
  constexpr int most = 8000;
  WindowSettings window;
  char rest = 0;
  if (std::sscanf(settings.size.c_str(), "%dx%d%c", &window.width, &window.height,
                  &rest) != 2 ||
      std::min(window.width, window.height) < least ||
      std::max(window.width, window.height) > most)
    throw ToolError("--size takes width and height as in 1200x800, each from 100 to "
                    "8000 pixels, not '" +
                    settings.size + "'");
  window.is_visible = settings.screenshot.empty();
  return window;
}

/** @brief Returns the initial state, checked before any file is read. */
ViewState
stateOf(const Settings& settings)
{
  ViewState state = settings.state;
  state.layers = layersOf(settings.layers);
  state.colouring = colouringOf(settings.colour);
  state.view_point = viewPointOf(settings.view);
  state.ceiling = !settings.no_ceiling;
  state.edges = !settings.no_edges;
  state.legend = !settings.no_legend;
  if (settings.clip)
    state.clip_height = *settings.clip;
  state.storey = static_cast<std::uint32_t>(settings.storey);
  return state;
}

/** @brief Throws a ToolError if the requested storey does not exist. */
void
checkStorey(const Painter& painter, std::uint32_t storey)
{
  if (storey != 0 && !painter.storeys().find(storey))
    throw ToolError("there is no storey " + std::to_string(storey) + ": the plan has " +
                    std::to_string(painter.storeys().storeys().size()));
}

/** @brief Throws a ToolError if an option has nothing to act on. */
void
checkOptions(const Settings& settings)
{
  std::error_code error;
  const bool is_folder = std::filesystem::is_directory(settings.path, error);
  const bool is_plan = std::filesystem::path(settings.path).extension() == ".json";
  const std::string given = settings.file.given();
  const auto isMesh = [&] {
    return readScanHead(settings.path, settings.file.resolved()).is_mesh;
  };
  if (!given.empty() && (is_folder || is_plan || isMesh()))
    throw ToolError(given + " tells how a scan is read, and '" + settings.path +
                    "' is none; " + raw_hint);
  if (!settings.reading.scan.empty() && !is_folder)
    throw ToolError("--raw names the raw scan of a folder that pcl_sedr has left, '" +
                    settings.path + "' is none");
}

int
run(const Settings& settings)
{
  checkOptions(settings);
  const WindowSettings window_settings = windowSettings(settings);
  ViewState state = stateOf(settings);
  if (!settings.screenshot.empty())
    checkPictureOutput(settings.screenshot);
  requireDisplay();
  ReadSettings reading = settings.reading;
  reading.file = settings.file.resolved();
  const ViewedResult result = readResult(settings.path, reading);
  for (const auto& note : result.notes)
    say("pcl_sedr_viewer: " + note);
  if (state.layers.empty())
    state.layers = result.firstLayers();
  const Painter painter(result, settings.range);
  checkStorey(painter, state.storey);
  Window window(result, painter, state, window_settings);
  if (settings.screenshot.empty()) {
    say(keyHelp());
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
