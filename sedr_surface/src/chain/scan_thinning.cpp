// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/rays/mirrored_points.h"
#include "sedr_filters/src/rays/sight_lines.h"
#include "sedr_segmentation/src/adjust/plan_adjustment.h"
#include "sedr_segmentation/src/scan/scan_check.h"
#include "sedr_segmentation/src/scan/scan_excerpt.h"

#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <algorithm>
#include <limits>

namespace pcl::sedr {

namespace {

PointView
viewOf(const std::vector<Eigen::Vector3f>& points)
{
  return {points.data(), sizeof(Eigen::Vector3f), points.size()};
}

/** @brief Returns why voxels have no size or are too large for the grid, a sentence;
 * empty if neither. */
std::string
voxelProblem(double voxel_size, double grid_size)
{
  if (!(voxel_size > 0))
    return "the voxel size must be above 0 m, it is " + numberText(voxel_size);
  if (voxel_size <= 1.001 * grid_size)
    return {};
  return "the voxel size " + numberText(voxel_size) +
         " m must not be above the grid size " + numberText(grid_size) +
         " m, or cells stay empty";
}

/** @brief Returns k of an excerpt that holds every k-th point. */
std::size_t
excerptStep(std::size_t points)
{
  return rawStep(points, AdjustmentParameters().max_points);
}

} // namespace

std::optional<BuildingFrame>
StructureChain::findFrame(const std::vector<Eigen::Vector3f>& excerpt)
{
  ParallelVoxelGrid<PointXYZ> grid = stages_.voxel_grid;
  const Cloud::Ptr cloud(new Cloud);
  cloud->resize(excerpt.size());
  for (std::size_t i = 0; i < excerpt.size(); ++i)
    (*cloud)[i].getVector3fMap() = excerpt[i];
  grid.setInputCloud(cloud);
  const Cloud::Ptr sample(new Cloud);
  grid.filter(*sample);
  setCloud(sample);
  if (!checkScan(positions_))
    return {};
  model_.frame = findBuildingFrame(PointView(*model_.cloud), {}, threads_,
                                   model_.levelFrame().rotation, getGridSize());
  return model_.frame;
}

ThinnedScan
StructureChain::thin(const RowSource& scan)
{
  ThinnedScan thinned;
  thinned.size = scan.size();
  thinned.problem = scan.problem();
  if (thinned.problem.empty()) {
    *thinned.excerpt = excerptOf(scan, AdjustmentParameters().max_points, threads_);
    thinned.problem = scanProblem(viewOf(*thinned.excerpt));
  }
  if (!thinned.problem.empty())
    return thinned;
  if (const auto frame = findFrame(*thinned.excerpt)) {
    stages_.voxel_grid.filter(MovedRows(scan, *frame, threads_), *thinned.points);
    thinned.strays = stages_.voxel_grid.getStrayPoints();
  }
  return thinned;
}

bool
StructureChain::findStructureOf(const RowSource* scan)
{
  if (const std::string wrong = voxelProblem(getVoxelSize(), getGridSize());
      !wrong.empty())
    return refuse(wrong);
  ThinnedScan thinned;
  const auto thinScan = [&](StageReport& report) {
    thinned =
        scan ? thin(*scan)
             : thinning_([this](const auto& excerpt) { return findFrame(excerpt); });
    report.points_in = thinned.size;
    report.points_out = thinned.points->size();
    if (!thinned.problem.empty())
      refuse(thinned.problem);
    else if (scan && model_.problem.empty())
      return stages_.voxel_grid.getErrorMessage();
    return std::string();
  };
  if (!runStage("ParallelVoxelGrid", 0, thinScan))
    return false;
  model_.stray_share = static_cast<double>(thinned.strays) /
                       static_cast<double>(std::max<std::size_t>(thinned.size, 1));
  movePoints(model_.frame, viewOf(*thinned.excerpt), threads_, thinned.excerpt->data());
  ScanPositions positions = positions_;
  for (ScanPosition& position : positions)
    position.place =
        model_.frame.toBuilding(position.place.cast<double>()).cast<float>();
  const auto leaveOut = [&](StageReport& report) {
    leaveOutMirrored(positions, thinned);
    report.points_out = thinned.points->size();
    return std::string();
  };
  if (!positions.empty() &&
      !runStage("MirroredPoints", thinned.points->size(), leaveOut))
    return false;
  setCloud(thinned.points);
  stages_.floorplan_fitting.setRawPoints(thinned.excerpt);
  const bool is_found = runStages();
  stages_.floorplan_fitting.setRawPoints(nullptr);
  return is_found;
}

/** @brief Erases reflections from the thinned points and sets them to NaN in the
 * excerpt. */
void
StructureChain::leaveOutMirrored(const ScanPositions& positions, ThinnedScan& scan)
{
  Cloud& thinned = *scan.points;
  std::vector<Eigen::Vector3f>& rows = *scan.excerpt;
  const MirroredPoints found = findMirroredPoints(
      PointView(thinned), viewOf(rows), excerptStep(scan.size), positions, threads_);
  MirrorFigures& mirrored = model_.mirrored;
  mirrored.positions = static_cast<std::size_t>(
      std::count_if(positions.begin(), positions.end(),
                    [](const ScanPosition& position) { return position.isKnown(); }));
  mirrored.untrue = static_cast<std::size_t>(std::count_if(
      positions.begin(), positions.end(), [&](const ScanPosition& position) {
        return std::find(found.untrue.begin(), found.untrue.end(), position.place) !=
               found.untrue.end();
      }));
  mirrored.rays = found.rays;
  mirrored.mirrors = found.mirrors;
  mirrored.lines =
      found.lines.empty() ? nullptr : std::make_shared<SightLines>(found.lines);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < thinned.size(); ++i)
    if (found.of_thinned[i] == 0) {
      thinned[kept++] = thinned[i];
      mirrored.behind.push_back(found.behind[i]);
    }
  mirrored.points = thinned.size() - kept;
  thinned.resize(kept);
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (found.of_rows[k] != 0)
      rows[k].setConstant(std::numeric_limits<float>::quiet_NaN());
}

} // namespace pcl::sedr
