// SPDX-License-Identifier: BSD-3-Clause
#include "bytes/whole_file.h"
#include "run_tool.h"
#include "simulator/scan/scan.h"
#include "simulator/scene/scene.h"
#include "simulator/truth/truth.h"
#include "tool_error.h"

#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <string>
#include <system_error>

namespace sim = pcl::sedr::sim;
using namespace pcl::sedr::tools;

namespace {

constexpr int kNameWidth = 16; ///< of scene names in a list

struct Settings {
  std::string scene;
  std::string folder;
  std::string print;
  bool list = false;
  sim::ScanOptions scan;
};

void
addOptions(Options& options, Settings& s)
{
  options.optionalFile(
      "SCENE", s.scene,
      "name of a built-in scene, or a scene file, which ends in .json");
  options.optionalFile("OUTPUT_DIR", s.folder, "folder for the files, made if missing");
  options.flag("list", s.list, "list the built-in scenes and how they are scanned");
  options.text("print", s.print, "print the file of this scene, to copy and edit");
  options.number("seed", s.scan.seed, "", "seed of all random numbers");
  options.optionalNumber("noise", s.scan.noise, "m", "standard deviation along the ray",
                         "see --list", Range::atLeast(0));
  options.optionalNumber("rays", s.scan.rays_per_station, "",
                         "rays a scanner position, about", "see --list",
                         Range::between(1, 1e8));
  options.optionalNumber("max-range", s.scan.max_range, "m", "longest range",
                         "see --list", Range::above(0));
  options.number("threads", s.scan.threads, "",
                 "threads; 0: as many as the machine has", Range::between(0, 256));
}

void
printScenes()
{
  for (const sim::Scene& scene : sim::allScenes()) {
    std::cout << std::left << std::setw(kNameWidth) << scene.name << ' '
              << scene.summary << '\n';
    for (const sim::Scanner& scanner : scene.scanners)
      std::cout << std::setw(kNameWidth) << "" << ' ' << scanner.stations.size()
                << " positions, --rays " << scanner.rays_per_station << " --noise "
                << scanner.noise << " --max-range " << scanner.max_range << '\n';
  }
}

/** @brief Writes binary x y z (float32), label room (uint32). */
void
writePcd(const std::string& path, const std::vector<sim::ScanPoint>& points)
{
  static_assert(sizeof(sim::ScanPoint) == 20,
                "a point is written as it lies in memory");
  writeWhole(path, [&](std::ostream& file) {
    file << "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n"
         << "FIELDS x y z label room\nSIZE 4 4 4 4 4\nTYPE F F F U U\nCOUNT 1 1 "
            "1 1 1\n"
         << "WIDTH " << points.size() << "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\n"
         << "POINTS " << points.size() << "\nDATA binary\n";
    file.write(reinterpret_cast<const char*>(points.data()),
               static_cast<std::streamsize>(points.size() * sizeof(sim::ScanPoint)));
  });
}

/** @brief Writes a line for each position: x y z in metres and its number of points,
 * which are in the same order in the scan. */
void
writePositions(const std::string& path, const std::vector<sim::ScanPosition>& positions)
{
  writeWhole(path, [&](std::ostream& file) {
    file.precision(10);
    file << "# x y z points\n";
    for (const sim::ScanPosition& position : positions)
      file << position.place.x() << ' ' << position.place.y() << ' '
           << position.place.z() << ' ' << position.points << '\n';
  });
}

void
simulate(const Settings& settings)
{
  const sim::Scene scene = sim::sceneNamed(settings.scene);
  const std::filesystem::path folder = settings.folder;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  checkWritable((folder / "scan.pcd").string()); // before the long work begins
  const sim::SceneMesh mesh = sim::meshOf(scene);
  sim::Scan scan;
  {
    const Progress progress("scanning");
    scan = sim::scan(scene, mesh, settings.scan);
  }
  const std::size_t triangles = sim::writeTruth(folder, scene, mesh);
  writePcd((folder / "scan.pcd").string(), scan.points);
  writePositions((folder / "positions.txt").string(), scan.positions);
  std::cout << scene.name << ": " << scan.points.size() << " points of " << scan.rays
            << " rays, truth of " << triangles << " triangles\n";
}

int
run(const Settings& settings)
{
  try {
    if ((settings.list || !settings.print.empty()) && !settings.scene.empty())
      throw ToolError("--list and --print scan nothing: they take no SCENE");
    if (settings.list)
      printScenes();
    else if (!settings.print.empty())
      std::cout << sim::sceneText(settings.print);
    else if (settings.folder.empty())
      throw ToolError("SCENE and OUTPUT_DIR are needed; see -h");
    else
      simulate(settings);
  }
  catch (const std::bad_alloc&) {
    throw;
  }
  catch (const std::exception& error) {
    throw ToolError(error.what());
  }
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Settings settings;
  Options options(
      "pcl_simulate_indoor_scan",
      "Scans an indoor scene. Writes OUTPUT_DIR/scan.pcd (x y z label room),\n"
      "OUTPUT_DIR/positions.txt (x y z points: where they were scanned from),\n"
      "OUTPUT_DIR/truth.ply (the closed structure, one component a room)\n"
      "and OUTPUT_DIR/truth.json (rooms, storeys and what joins them).\n"
      "Label: 0 other, 1 ceiling, 2 floor, 3 wall, 4 detail, 5 column.");
  addOptions(options, settings);
  return runTool(options, argc, argv, [&] { return run(settings); });
}
