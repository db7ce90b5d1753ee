// SPDX-License-Identifier: BSD-3-Clause
#include "progress.h"
#include "report/report_page.h"
#include "run_tool.h"
#include "scan_file.h"
#include "sedr/chain_pictures.h"
#include "sedr/output_folder.h"
#include "sedr/report.h"
#include "sedr/solid_files.h"
#include "tool_cloud.h"
#include "tool_error.h"
#include "whole_file.h"

#include <pcl/common/angles.h>
#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>
#include <pcl/sedr_surface/mesh_evaluation.h>
#include <pcl/sedr_surface/mesh_io.h>

#include <chrono>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

using namespace pcl::sedr::tools;
using pcl::sedr::StageReport;
using Reconstruction = pcl::IndoorStructureReconstruction<pcl::PointXYZ>;

namespace {

const std::vector<std::string> output_names{
    "structure.pcd",  "mesh.ply",      "solid.ply",     "solid.obj",  "solid.mtl",
    "floorplan.json", "floorplan.svg", "floorplan.dxf", "report.json"};

/** @brief Runs a step that is no stage of the chain, with progress; it is handed its
 * report, to fill in the points. */
StageReport
timed(const std::string& name, const std::function<void(StageReport&)>& step)
{
  const Progress progress(name);
  StageReport report{name};
  const auto start = std::chrono::steady_clock::now();
  step(report);
  report.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

/** @brief Runs the chain with progress; what fails is a ToolError that names the stage.
 */
void
reconstruct(Reconstruction& chain, bool with_mesh)
{
  std::unique_ptr<Progress> progress;
  chain.getChain().on_stage = [&](const std::string& stage) {
    progress.reset(); // one line ends before the next begins
    progress = std::make_unique<Progress>(stage);
  };
  const bool is_done = chain.findStructure() && (!with_mesh || chain.makeMesh());
  chain.getChain().on_stage = nullptr; // it knows `progress`, which ends here
  progress.reset();
  if (!is_done)
    throw ToolError("no structure found: " + chain.getErrorMessage(), NothingFound);
}

/** @brief Distances of the labelled scan points, before refinement, from the mesh. */
pcl::sedr::MeshEvaluationResult
evaluate(const Reconstruction& chain, unsigned threads, StageReport& report)
{
  const auto& result = chain.getChain();
  const std::size_t scanned = chain.getStageReports().front().points_out;
  pcl::IndicesPtr structure(new pcl::Indices);
  for (std::size_t i = 0; i < scanned; ++i)
    if (result.labels[i] != 0)
      structure->push_back(static_cast<int>(i));
  pcl::MeshEvaluation evaluation;
  const std::shared_ptr<const pcl::sedr::TriangleMesh> mesh(
      std::shared_ptr<void>(), &result.poisson.getMesh()); // the chain's own, no copy
  evaluation.setInputMesh(mesh);
  evaluation.setInputCloud(result.cloud);
  evaluation.setIndices(structure);
  evaluation.setNumberOfThreads(threads);
  pcl::sedr::MeshEvaluationResult figures;
  if (!evaluation.compute(figures))
    throw ToolError(evaluation.getErrorMessage(), NothingFound);
  report.points_in = structure->size();
  report.points_out = structure->size() - figures.skipped_points;
  return figures;
}

/** @brief Writes the model: all but the report. */
void
writeModel(const OutputFolder& folder, const Reconstruction& chain, bool with_mesh)
{
  saveStructure(folder.file("structure.pcd"), *chain.getStructure());
  const std::string problem =
      with_mesh ? pcl::sedr::savePly(folder.file("mesh.ply"),
                                     chain.getChain().poisson.getMesh())
                : std::string();
  if (!problem.empty())
    throw ToolError(problem);
  writeWhole(folder.file("floorplan.json"), [&](std::ostream& stream) {
    stream << pcl::sedr::floorplanToJson(*chain.getFloorplan());
  });
  for (const char* name : {"floorplan.svg", "floorplan.dxf"})
    saveDrawing(folder.file(name), *chain.getFloorplan());
  const auto& extrusion = chain.getChain().extrusion;
  for (const char* name : {"solid.ply", "solid.obj"})
    saveSolid(folder.file(name), extrusion.getMesh(), extrusion.getElements());
}

void
writePictures(const OutputFolder& folder, const std::vector<PictureFile>& pictures)
{
  folder.fill([&] {
    for (const auto& picture : pictures)
      writeWhole(folder.file(picture.name),
                 [&](std::ostream& stream) { stream << picture.bytes; });
  });
}

/** @brief What the command line sets; the defaults are the chain's. */
struct Settings {
  explicit Settings(const Reconstruction& chain)
      : voxel(chain.getVoxelSize())
      , plane_tolerance(chain.getPlaneTolerance())
      , grid(chain.getGridSize())
      , angle(pcl::rad2deg(chain.getBoundaryAngle()))
      , neighbours(chain.getBoundaryNeighbors())
      , minimum_cells(chain.getMinimumDetailCells())
      , boundary_tolerance(chain.getBoundaryTolerance())
      , depth(chain.getTreeDepth())
      , threads(chain.getNumberOfThreads())
      , seed(chain.getSeed())
      , z_up(chain.getChain().trust_up)
      , mesh_from_plan(chain.getChain().mesh_from_plan)
  {}

  std::string input;
  std::string folder;
  double voxel;
  double plane_tolerance;
  double grid;
  double angle; ///< degrees
  unsigned neighbours;
  std::size_t minimum_cells;
  double boundary_tolerance;
  int depth;
  std::string poisson_solver = "sedr";
  unsigned threads;
  std::uint64_t seed;
  double unit = 1; ///< metres
  bool z_up;
  bool fixed_grid = false;
  bool mesh_from_plan;
  bool no_mesh = false;
  bool pictures = false;
  bool report = false;
};

void
addOptions(Options& options, Settings& s)
{
  options.file("INPUT", s.input, "PCD or PLY file, z up");
  options.file("OUTPUT_DIR", s.folder, "folder for the results, made if missing");
  options.number("voxel-size", s.voxel, "m", "edge of a voxel in down-sampling",
                 Range::between(0.005, 1));
  options.number("plane-tolerance", s.plane_tolerance, "m",
                 "tolerance of the planes of ceiling and floor",
                 Range::between(0.001, 1));
  options.number("grid-size", s.grid, "m", "cell of outlier removal and grid-slices",
                 Range::between(0.01, 1));
  options.flag("fixed-grid", s.fixed_grid,
               "keep the cells even where the scan is too sparse to fill them");
  options.number("boundary-angle", s.angle, "degrees", "angle of boundary estimation",
                 Range::between(1, 359));
  options.number("boundary-neighbors", s.neighbours, "points",
                 "neighbours of boundary estimation", Range::between(3, 10000));
  options.number("minimum-cells", s.minimum_cells, "cells",
                 "least region of a structural detail", Range::atLeast(1));
  options.number("boundary-tolerance", s.boundary_tolerance, "m",
                 "tolerance of the walls' lines and circles", Range::between(0.001, 1));
  options.number("tree-depth", s.depth, "levels",
                 "greatest depth of the Poisson reconstruction", Range::between(3, 14));
  options.text(
      "poisson-solver", s.poisson_solver,
      "what solves the equation of mesh.ply: cells along the surface of its own, "
      "or pcl::Poisson",
      {"sedr", "pcl"});
  options.number("threads", s.threads, "", "threads, 0 for all processors",
                 Range::between(0, 1024));
  options.number("seed", s.seed, "", "seed of the random samples", Range::atLeast(0));
  options.number("unit", s.unit, "m",
                 "length of one unit of the scan: 0.001 for millimetres",
                 Range::between(1e-6, 1e6));
  options.flag("z-up", s.z_up,
               "take z as up even if another axis seems to be, or the scan leans");
  options.flag("mesh-from-plan", s.mesh_from_plan,
               "sample the floor plan for mesh.ply, not the points");
  options.flag("no-mesh", s.no_mesh,
               "stop at the plan and its solid: no mesh.ply and no distances to it");
  options.flag("pictures", s.pictures,
               "write a picture of what each stage decided to OUTPUT_DIR/pictures");
  options.flag("report", s.report,
               "write report.html, one page on all of it, as pcl_sedr_report does");
}

void
apply(const Settings& s, Reconstruction& chain)
{
  chain.setVoxelSize(static_cast<float>(s.voxel));
  chain.setPlaneTolerance(s.plane_tolerance);
  chain.setGridSize(s.grid);
  chain.setAdaptiveGrid(!s.fixed_grid);
  chain.setBoundaryEstimation(pcl::deg2rad(s.angle), s.neighbours);
  chain.setMinimumDetailCells(s.minimum_cells);
  chain.setBoundaryTolerance(s.boundary_tolerance);
  chain.setTreeDepth(s.depth);
  chain.getChain().poisson.setSolver(s.poisson_solver == "pcl"
                                         ? pcl::sedr::PoissonSolver::Pcl
                                         : pcl::sedr::PoissonSolver::Sedr);
  chain.setNumberOfThreads(s.threads);
  chain.setSeed(s.seed);
  chain.getChain().trust_up = s.z_up;
  chain.getChain().mesh_from_plan = s.mesh_from_plan;
}

/** @brief Writes report.html from the files of the model, which are there by now. */
void
writeReportPage(const Settings& settings)
{
  const Progress progress("writing the page");
  PageSettings page;
  page.scan = settings.input;
  writePage(settings.folder, page);
}

/** @brief Reads, reconstructs, measures and writes. */
int
run(const Settings& settings, Reconstruction& chain)
{
  if (settings.no_mesh && (settings.pictures || settings.report))
    throw ToolError(
        "--pictures and --report show the mesh, which --no-mesh leaves out");
  std::vector<std::string> names = output_names;
  if (settings.report)
    names.emplace_back("report.html");
  const OutputFolder folder(settings.folder, names);
  std::optional<OutputFolder> picture_folder;
  std::optional<ChainPictures> pictures;
  if (settings.pictures) {
    picture_folder.emplace(folder.file("pictures"), ChainPictures::names());
    pictures.emplace(chain);
  }
  RunRecord record;
  record.path = settings.input;
  record.unit = settings.unit;
  const StageReport reading = timed("reading", [&](StageReport& report) {
    // What is not in its header is read while it is thinned.
    const auto scan = std::make_shared<ScanFile>(settings.input, settings.unit);
    record.points = report.points_in = report.points_out = scan->size();
    chain.setInputSource(scan);
  });
  reconstruct(chain, !settings.no_mesh);
  record.stages = chain.getStageReports();
  record.stages.insert(record.stages.begin(), reading);
  if (!settings.no_mesh)
    record.stages.push_back(timed("MeshEvaluation", [&](StageReport& report) {
      record.figures = evaluate(chain, settings.threads, report);
    }));
  std::vector<PictureFile> drawn;
  if (pictures)
    record.stages.push_back(
        timed("drawing", [&](StageReport&) { drawn = pictures->draw(); }));
  folder.fill([&] {
    record.stages.push_back(timed("writing", [&](StageReport& report) {
      writeModel(folder, chain, !settings.no_mesh);
      report.points_in = report.points_out = chain.getStructure()->size();
    }));
    writeWhole(folder.file("report.json"),
               [&](std::ostream& stream) { stream << makeReport(record, chain); });
    if (picture_folder)
      writePictures(*picture_folder, drawn);
    if (settings.report)
      writeReportPage(settings);
  });
  for (const auto& warning : chain.getChain().warnings)
    std::cerr << "pcl_sedr: warning: " << warning << '\n';
  say(summaryOf(record, chain));
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  Reconstruction chain;
  Settings settings(chain);
  Options options(
      "pcl_sedr",
      "Reconstructs ceiling, floor and walls of an indoor scan as one closed mesh a "
      "room.\nWrites structure.pcd, mesh.ply, solid.ply, solid.obj, floorplan.json, "
      "floorplan.svg, floorplan.dxf and report.json.");
  addOptions(options, settings);
  return runTool(options, argc, argv, [&] {
    apply(settings, chain);
    return run(settings, chain);
  });
}
