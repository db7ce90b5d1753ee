// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/runs/isolated.h"
#include "benchmark/runs/run.h"
#include "benchmark/runs/run_list.h"
#include "benchmark/table/bars.h"
#include "benchmark/table/csv_file.h"
#include "benchmark/table/formatted.h"
#include "bytes/whole_file.h"
#include "prior_values.h"
#include "progress.h"
#include "run_tool.h"
#include "simulator/scene/scenes.h"
#include "tool_error.h"

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

using namespace pcl::sedr::benchmark;
using namespace pcl::sedr::tools;
namespace sim = pcl::sedr::sim;

namespace {

/** @brief The options of the command line. */
struct Settings {
  std::string scenes = "all";
  std::string noises = "0.001,0.005,0.01,0.02";
  std::string seeds = "1,2,3";
  std::string part = "1/1";
  std::string csv;
  std::string keep;
  std::string priors;
  bool resume = false;
  bool no_mesh = false;
  bool positions = false;
  std::size_t rays = 0;
  unsigned threads = 0;
};

void
addOptions(Options& options, Settings& s)
{
  options.text("scenes", s.scenes,
               "built-in scenes and JSON files of scenes, with commas between them; "
               "'all' stands for all built-in ones");
  options.text("noise", s.noises, "noise levels, standard deviations in metres");
  options.text("seeds", s.seeds, "seeds of the simulator");
  options.flag("no-mesh", s.no_mesh,
               "stop at the structure's points, which is quicker");
  options.flag("positions", s.positions, "tell the positions of the scanner");
  options.text("csv", s.csv, "file to which every run adds a line when it ends");
  options.flag("resume", s.resume, "skip the runs that --csv has already");
  options.text("part", s.part, "do every N-th run only, such as 1/2 and 2/2");
  options.text("keep", s.keep, "folder in which to keep the files of every run");
  options.text("prior", s.priors,
               "what is believed before a scan is looked at, name=value, with commas");
  options.number("rays", s.rays, "rays",
                 "rays a scanner position, 0 for the scene's own",
                 Range::between(0, 1e8));
  options.number("threads", s.threads, "", "threads, 0 for all processors",
                 Range::between(0, 256));
}

/** @brief A run to execute. */
struct Task {
  const sim::Scene* scene;
  RunSettings settings;
};

std::vector<sim::Scene>
loadScenes(const std::string& list)
{
  if (list == "all")
    return sim::allScenes();
  std::vector<sim::Scene> scenes;
  for (const std::string& name : wordsOf(list, "scenes"))
    try {
      scenes.push_back(sim::sceneNamed(name));
    }
    catch (const std::exception& error) {
      throw ToolError(error.what());
    }
  return scenes;
}

/** @brief Returns the requested part of all runs: every scene at every noise and seed,
 * in this order. */
std::vector<Task>
tasksOf(const std::vector<sim::Scene>& scenes, const Settings& settings)
{
  const Part part = partOf(settings.part, "part");
  const pcl::sedr::Priors priors = priorsOf(settings.priors);
  std::vector<Task> tasks;
  std::size_t index = 0;
  for (const sim::Scene& scene : scenes)
    for (const double noise : noisesOf(settings.noises, "noise"))
      for (const std::uint64_t seed : seedsOf(settings.seeds, "seeds"))
        if (part.holds(index++))
          tasks.push_back(
              {&scene,
               {noise, seed, !settings.no_mesh, settings.rays, settings.threads,
                settings.keep, priors, settings.positions}});
  return tasks;
}

void
print(const RunRow& row)
{
  std::printf("%-16s %5.2f cm  seed %-3zu ", row.scene.c_str(), 100 * row.noise,
              static_cast<std::size_t>(row.seed));
  if (!row.failure.empty())
    std::printf("failed: %s", row.failure.c_str());
  else {
    std::printf("%zu/%zu rooms", row.rooms.rooms_found, row.rooms.rooms_true);
    if (row.mesh.isMeasured())
      std::printf(", mean %.3f cm, within 5 cm %.2f %%",
                  100 * row.mesh.truth_to_mesh_mean, 100 * row.mesh.truth_within_5cm);
    else if (row.structure.isMeasured())
      std::printf(", points: mean %.3f cm, covered %.2f %%",
                  100 * row.structure.points_to_truth_mean,
                  100 * row.structure.truth_covered);
    std::printf(", %.1f s", row.seconds);
    for (const Miss& miss : missedBars(row))
      std::printf("; %s", miss.text.c_str());
  }
  std::printf("\n");
  std::fflush(stdout);
}

void
tell(const RunRow& row, const std::string& csv)
{
  print(row);
  if (!csv.empty())
    appendRow(csv, row);
}

/** @brief Executes a run in a separate process, so that even a crash yields a row. */
void
run(const Task& task, const std::string& csv)
{
  const RunRow asked = rowOf(*task.scene, task.settings);
  try {
    runIsolated([&] {
      RunRow row;
      {
        const Progress progress(
            asked.scene + formatted(", noise %g m, seed %zu", asked.noise, asked.seed));
        row = runScene(*task.scene, task.settings);
      }
      tell(row, csv);
    });
  }
  catch (const std::exception& error) {
    RunRow failed = asked;
    failed.failure = error.what();
    tell(failed, csv);
  }
}

/** @brief Executes all runs that are missing. */
int
work(const Settings& settings)
{
  if (settings.resume && settings.csv.empty())
    throw ToolError("--resume goes on with the rows of a file, but there is no --csv");
  std::vector<std::string> lines;
  if (!settings.csv.empty()) {
    checkWritable(settings.csv);
    lines = linesToContinue(settings.csv);
  }
  const std::vector<sim::Scene> scenes = loadScenes(settings.scenes);
  for (const Task& task : tasksOf(scenes, settings))
    if (!settings.resume || !rowOf(*task.scene, task.settings).isIn(lines))
      run(task, settings.csv);
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Settings settings;
  Options options(
      "pcl_sedr_benchmark",
      "Scans scenes in the simulator, reconstructs them with the defaults of pcl_sedr "
      "and compares\nthe results with the truth. Prints a line a run; a run that fails "
      "is a row like any other.");
  addOptions(options, settings);
  return runTool(options, argc, argv, [&] { return work(settings); });
}
