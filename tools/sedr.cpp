// SPDX-License-Identifier: BSD-3-Clause
#include "progress.h"
#include "run_tool.h"
#include "sedr/report.h"
#include "tool_cloud.h"
#include "tool_error.h"
#include "whole_file.h"

#include <pcl/common/angles.h>
#include <pcl/conversions.h>
#include <pcl/sedr_filters/floorplan_io.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>
#include <pcl/sedr_surface/mesh_evaluation.h>
#include <pcl/sedr_surface/mesh_io.h>

#include <filesystem>
#include <memory>

using namespace pcl::sedr::tools;
using Reconstruction = pcl::IndoorStructureReconstruction<pcl::PointXYZ>;
namespace fs = std::filesystem;

namespace {

/** @brief Makes the folder, and asks whether the outputs can be written there, before the work. */
void
prepareFolder(const std::string& folder)
{
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder))
    throw ToolError("the output folder '" + folder + "' cannot be made: " +
                    (error ? error.message() : "a file of that name exists"));
  for (const char* name : {"structure.pcd", "mesh.ply", "floorplan.json", "report.json"})
    checkWritable((fs::path(folder) / name).string());
}

/** @brief Loads the scan, and brings it to metres. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
loadScan(const std::string& path, double unit)
{
  const Progress progress("reading " + path);
  const ToolCloud file = loadCloud(path, unit);
  for (auto& p : *file.points)
    p.getVector3fMap() *= static_cast<float>(unit);
  return file.points;
}

/** @brief Runs the chain with progress; what fails is a ToolError that names the stage. */
void
reconstruct(Reconstruction& chain)
{
  std::unique_ptr<Progress> progress;
  chain.getChain().on_stage = [&](const std::string& stage) {
    progress.reset(); // one line ends before the next begins
    progress = std::make_unique<Progress>(stage);
  };
  pcl::PolygonMesh mesh;
  chain.reconstruct(mesh);
  progress.reset();
  if (mesh.polygons.empty())
    throw ToolError("no structure found: " + chain.getErrorMessage(), NothingFound);
}

/** @brief Distances of the labelled scan points, before refinement, from the mesh. */
pcl::sedr::MeshEvaluationResult
evaluate(const Reconstruction& chain, unsigned threads)
{
  const Progress progress("MeshEvaluation");
  const auto& result = chain.getChain();
  const std::size_t scanned = chain.getStageReports().front().points_out;
  pcl::IndicesPtr structure(new pcl::Indices);
  for (std::size_t i = 0; i < scanned; ++i)
    if (result.labels[i] != 0)
      structure->push_back(static_cast<int>(i));
  pcl::MeshEvaluation evaluation;
  evaluation.setInputMesh(
      std::make_shared<const pcl::sedr::TriangleMesh>(result.poisson.getMesh()));
  evaluation.setInputCloud(result.cloud);
  evaluation.setIndices(structure);
  evaluation.setNumberOfThreads(threads);
  pcl::sedr::MeshEvaluationResult figures;
  if (!evaluation.compute(figures))
    throw ToolError(evaluation.getErrorMessage(), NothingFound);
  return figures;
}

void
write(const std::string& folder, const Reconstruction& chain, const std::string& report)
{
  const auto path = [&](const char* name) { return (fs::path(folder) / name).string(); };
  pcl::PCLPointCloud2 structure;
  pcl::toPCLPointCloud2(*chain.getStructure(), structure);
  saveCloud(path("structure.pcd"), structure);
  const std::string problem =
      pcl::sedr::savePly(path("mesh.ply"), chain.getChain().poisson.getMesh());
  if (!problem.empty())
    throw ToolError(problem);
  writeWhole(path("floorplan.json"), [&](std::ostream& stream) {
    stream << pcl::sedr::floorplanToJson(*chain.getFloorplan());
  });
  writeWhole(path("report.json"), [&](std::ostream& stream) { stream << report; });
}

} // namespace

int
main(int argc, char** argv)
{
  Reconstruction chain;
  ReportInput input;
  std::string folder;
  double voxel = chain.getVoxelSize();
  double plane_tolerance = chain.getPlaneTolerance();
  double grid = chain.getGridSize();
  double angle = pcl::rad2deg(chain.getBoundaryAngle());
  unsigned neighbours = chain.getBoundaryNeighbors();
  std::size_t minimum_cells = chain.getMinimumDetailCells();
  double boundary_tolerance = chain.getBoundaryTolerance();
  int depth = chain.getTreeDepth();
  unsigned threads = chain.getNumberOfThreads();
  std::uint64_t seed = chain.getSeed();

  Options options("pcl_sedr",
                  "Reconstructs ceiling, floor and walls of an indoor scan as one closed mesh a "
                  "room.\nWrites structure.pcd, mesh.ply, floorplan.json and report.json.");
  options.file("INPUT", input.path, "PCD or PLY file, z up");
  options.file("OUTPUT_DIR", folder, "folder for the results, made if missing");
  options.number(
      "voxel-size", voxel, "m", "edge of a voxel in down-sampling", Range::between(0.005, 1));
  options.number("plane-tolerance",
                 plane_tolerance,
                 "m",
                 "tolerance of the planes of ceiling and floor",
                 Range::between(0.001, 1));
  options.number(
      "grid-size", grid, "m", "cell of outlier removal and grid-slices", Range::between(0.01, 1));
  options.number("boundary-angle",
                 angle,
                 "degrees",
                 "angle of boundary estimation",
                 Range::between(1, 359));
  options.number("boundary-neighbors",
                 neighbours,
                 "points",
                 "neighbours of boundary estimation",
                 Range::between(3, 10000));
  options.number("minimum-cells",
                 minimum_cells,
                 "cells",
                 "least region of a structural detail",
                 Range::atLeast(1));
  options.number("boundary-tolerance",
                 boundary_tolerance,
                 "m",
                 "tolerance of the walls' lines and circles",
                 Range::between(0.001, 1));
  options.number("tree-depth",
                 depth,
                 "levels",
                 "greatest depth of the Poisson reconstruction",
                 Range::between(3, 14));
  options.number("threads", threads, "", "threads, 0 for all processors", Range::between(0, 1024));
  options.number("seed", seed, "", "seed of the random samples", Range::atLeast(0));
  options.number("unit",
                 input.unit,
                 "m",
                 "length of one unit of the scan: 0.001 for millimetres",
                 Range::between(1e-6, 1e6));
  options.flag("z-up",
               chain.getChain().trust_up,
               "take z as up even if another axis seems to be");

  return runTool(options, argc, argv, [&] {
    chain.setVoxelSize(static_cast<float>(voxel));
    chain.setPlaneTolerance(plane_tolerance);
    chain.setGridSize(grid);
    chain.setBoundaryEstimation(pcl::deg2rad(angle), neighbours);
    chain.setMinimumDetailCells(minimum_cells);
    chain.setBoundaryTolerance(boundary_tolerance);
    chain.setTreeDepth(depth);
    chain.setNumberOfThreads(threads);
    chain.setSeed(seed);

    prepareFolder(folder);
    const auto scan = loadScan(input.path, input.unit);
    input.points = scan->size();
    chain.setInputCloud(scan);
    reconstruct(chain);
    write(folder, chain, makeReport(input, chain, evaluate(chain, threads)));
    for (const auto& warning : chain.getChain().warnings)
      std::cerr << "pcl_sedr: warning: " << warning << '\n';
    say(summaryOf(chain));
    return Done;
  });
}
