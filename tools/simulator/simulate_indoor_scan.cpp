// SPDX-License-Identifier: BSD-3-Clause
#include "simulator/scan/scan.h"
#include "simulator/scene/building.h"
#include "simulator/scene/scenes.h"
#include "simulator/truth/files.h"
#include "simulator/truth/room_links.h"
#include "simulator/truth/room_truth.h"
#include "simulator/truth/truth_mesh.h"

#include <boost/program_options.hpp>

#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace po = boost::program_options;
namespace sim = pcl::sedr::sim;

namespace {

constexpr int kNameWidth = 16; ///< of scene names in a list

/** @brief The command line. Numbers are signed so that -1 is not read as a huge one. */
struct Arguments {
  std::string scene;
  std::filesystem::path folder;
  std::int64_t seed = static_cast<std::int64_t>(sim::ScanOptions{}.seed);
  std::int64_t threads = sim::ScanOptions{}.threads;
  std::int64_t rays = 0;
  std::int64_t building = 0;
  double noise = 0.0;
  double max_range = 0.0;
  double chord_tolerance = sim::kChordTolerance;
  sim::ScanOptions scan;
  bool help = false;
  bool version = false;
  bool list = false;
  std::string print;

  /** @brief Returns true if only information is requested and nothing is scanned. */
  bool isQuestion() const { return help || version || list || !print.empty(); }
};

po::options_description
visibleOptions(Arguments& arguments)
{
  po::options_description options("Options");
  auto add = options.add_options();
  add("help,h", po::bool_switch(&arguments.help), "print this help");
  add("version", po::bool_switch(&arguments.version), "print the version");
  add("list", po::bool_switch(&arguments.list),
      "list the built-in scenes and how they are scanned");
  add("print", po::value(&arguments.print)->value_name("SCENE"),
      "print the file of a scene, to copy and edit");
  add("seed",
      po::value(&arguments.seed)->default_value(arguments.seed)->value_name("N"),
      "seed of all random numbers, not negative");
  add("noise", po::value(&arguments.noise)->value_name("M"),
      "standard deviation along the ray in metres (default: see --list)");
  add("rays", po::value(&arguments.rays)->value_name("N"),
      "rays a scanner position, about (default: see --list)");
  add("max-range", po::value(&arguments.max_range)->value_name("M"),
      "longest range in metres (default: see --list)");
  add("chord-tolerance",
      po::value(&arguments.chord_tolerance)
          ->default_value(arguments.chord_tolerance, "0.0005")
          ->value_name("M"),
      "distance of the truth's chords from their arcs in metres");
  add("building", po::value(&arguments.building)->value_name("N"),
      "write a storey of copies of the scene side by side instead, of about N points "
      "in all: scan.pcd alone, of x y z label");
  add("threads",
      po::value(&arguments.threads)->default_value(arguments.threads)->value_name("N"),
      "threads; 0: as many as the machine has");
  return options;
}

void
printHelp(const po::options_description& options)
{
  std::cout
      << "Usage: pcl_simulate_indoor_scan SCENE OUTPUT_DIR [options]\n"
      << "       pcl_simulate_indoor_scan --list\n"
      << "       pcl_simulate_indoor_scan --print SCENE\n\n"
      << "Scans an indoor scene: SCENE is the name of a built-in one or a scene file,\n"
      << "which ends in .json. Writes OUTPUT_DIR/scan.pcd (x y z label room),\n"
      << "OUTPUT_DIR/positions.txt (x y z points: where they were scanned from),\n"
      << "OUTPUT_DIR/truth.ply (the closed structure, one component a room)\n"
      << "and OUTPUT_DIR/truth.json (rooms, storeys and what joins them).\n"
      << "Label: 0 other, 1 ceiling, 2 floor, 3 wall, 4 detail, 5 column.\n\n"
      << options;
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

/** @brief Throws @p sentence unless a value is valid. */
void
require(bool is_valid, const std::string& sentence)
{
  if (!is_valid)
    throw std::invalid_argument(sentence);
}

/** @brief Checks the numbers and applies them to the scan options.
 * @throw std::invalid_argument if one is out of range
 */
void
applyNumbers(Arguments& arguments, const po::variables_map& given)
{
  require(arguments.seed >= 0, "--seed must not be negative");
  require(arguments.threads >= 0 && arguments.threads <= 256,
          "--threads must be from 0 to 256");
  arguments.scan.seed = static_cast<std::uint64_t>(arguments.seed);
  arguments.scan.threads = static_cast<unsigned>(arguments.threads);
  require(arguments.chord_tolerance >= 1e-6 && arguments.chord_tolerance <= 0.1,
          "--chord-tolerance must be from 0.000001 to 0.1 metres");
  if (given.count("noise") > 0) {
    require(std::isfinite(arguments.noise) && arguments.noise >= 0.0,
            "--noise must be a number of metres, not negative");
    arguments.scan.noise = arguments.noise;
  }
  if (given.count("max-range") > 0) {
    require(arguments.max_range > 0.0,
            "--max-range must be a positive number of metres");
    arguments.scan.max_range = arguments.max_range;
  }
  if (given.count("building") > 0)
    require(arguments.building >= 1 && arguments.building <= 2'000'000'000,
            "--building must be from 1 to 2000000000 points");
  if (given.count("rays") > 0) {
    require(arguments.rays >= 1 && arguments.rays <= 100'000'000,
            "--rays must be from 1 to 100000000");
    arguments.scan.rays_per_station = static_cast<std::size_t>(arguments.rays);
  }
}

Arguments
parse(int argc, char** argv)
{
  Arguments arguments;
  po::options_description options = visibleOptions(arguments);
  po::options_description positional_options;
  positional_options.add_options()("scene", po::value(&arguments.scene));
  positional_options.add_options()("folder", po::value<std::string>());
  po::positional_options_description positional;
  positional.add("scene", 1).add("folder", 1);

  po::options_description all;
  all.add(options).add(positional_options);
  // Accept -rays for --rays, as the other programs and PCL's tools do.
  const int style = (po::command_line_style::default_style |
                     po::command_line_style::allow_long_disguise) &
                    ~po::command_line_style::allow_guessing;
  po::variables_map given;
  po::store(po::command_line_parser(argc, argv)
                .options(all)
                .positional(positional)
                .style(style)
                .run(),
            given);
  po::notify(given);
  if (arguments.help)
    printHelp(options);
  if (arguments.isQuestion())
    return arguments;
  if (given.count("folder") == 0)
    throw std::invalid_argument("SCENE and OUTPUT_DIR are needed; see -h");
  arguments.folder = given["folder"].as<std::string>();
  applyNumbers(arguments, given);
  return arguments;
}

void
showProgress(double share)
{
  std::fprintf(stderr, "\rscanning %3.0f %%%s", 100.0 * share, share < 1.0 ? "" : "\n");
}

/** @brief Creates the folder, or fails, before the long work begins. */
void
prepareFolder(const std::filesystem::path& folder)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw std::runtime_error("Cannot create the folder " + folder.string() + ": " +
                             error.message());
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw std::runtime_error("Cannot write to the folder " + folder.string());
}

void
simulate(Arguments& arguments)
{
  const sim::Scene scene = sim::sceneNamed(arguments.scene);
  prepareFolder(arguments.folder);
  if (isatty(STDERR_FILENO) != 0)
    arguments.scan.progress = showProgress;
  if (arguments.building > 0) {
    const sim::BuildingScan building = sim::writeBuilding(
        arguments.folder / "scan.pcd", scene,
        static_cast<std::size_t>(arguments.building), arguments.scan);
    std::cout << scene.name << ": " << building.points << " points of "
              << building.copies << " copies\n";
    return;
  }
  const sim::Mesh truth = sim::truthMesh(scene, arguments.chord_tolerance);
  const sim::Scan scan = sim::scan(scene, arguments.scan);
  sim::writePly(arguments.folder / "truth.ply", truth, scene.placement);
  sim::writeText(arguments.folder / "truth.json",
                 sim::roomTruthsToJson(scene.name, sim::roomTruths(scene, truth),
                                       sim::roomLinks(scene)));
  sim::writePcd(arguments.folder / "scan.pcd", scan.points);
  sim::writePositions(arguments.folder / "positions.txt", scan.positions);
  std::cout << scene.name << ": " << scan.points.size() << " points of " << scan.rays
            << " rays, truth of " << truth.faces.size() << " triangles\n";
}

} // namespace

int
main(int argc, char** argv)
{
  try {
    Arguments arguments = parse(argc, argv);
    if (!arguments.isQuestion())
      simulate(arguments);
    else if (arguments.version)
      std::cout << "pcl_simulate_indoor_scan (SEDR) " SEDR_VERSION "\n";
    else if (arguments.list)
      printScenes();
    else if (!arguments.print.empty())
      std::cout << sim::sceneText(arguments.print);
    return 0;
  }
  catch (const std::exception& error) {
    std::cerr << "pcl_simulate_indoor_scan: " << error.what() << '\n';
    return 1;
  }
}
