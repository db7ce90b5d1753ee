// SPDX-License-Identifier: BSD-3-Clause
#include "../mesh/mesh_repair.h"
#include "chain_stages.h"
#include "sedr_filters/src/rays/sight_lines.h"
#include "sedr_segmentation/src/scan/scan_check.h"
#include "sedr_segmentation/src/scan/scan_up.h"

#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_surface/impl/indoor_structure_reconstruction.hpp>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <chrono>
#include <cmath>
#include <numeric>

namespace pcl::sedr {
namespace {

/** @brief Returns the centre of the bounding box of the finite points. */
Eigen::Vector3d
middleOf(const StructureModel::Cloud& cloud)
{
  Eigen::AlignedBox3d box;
  for (const auto& p : cloud)
    if (p.getVector3fMap().allFinite())
      box.extend(p.getVector3fMap().cast<double>().eval());
  return box.isEmpty() ? Eigen::Vector3d::Zero().eval() : box.center();
}

} // namespace

StructureChain::StructureChain()
{
  stages_.voxel_grid.setRemoveStrays(true);
}

StructureChain::~StructureChain() = default;

void
StructureChain::setVoxelSize(float size)
{
  stages_.voxel_grid.setLeafSize(size, size, size);
  stages_.wall_growing.setDistanceThreshold(2 * getGridSize() + size);
}

void
StructureChain::setGridSize(double size)
{
  setCells(stages_, size);
  stages_.wall_growing.setDistanceThreshold(2 * size + getVoxelSize());
  enlarged_from_ = 0;
}

void
StructureChain::setNumberOfThreads(unsigned threads)
{
  threads_ = threads;
  stages_.voxel_grid.setNumberOfThreads(threads);
  stages_.room_segmentation.setNumberOfThreads(threads);
  stages_.wall_growing.setNumberOfThreads(threads);
  stages_.floorplan_fitting.setNumberOfThreads(threads);
  stages_.opening_detection.setNumberOfThreads(threads);
  stages_.refinement.setNumberOfThreads(threads);
  stages_.hole_repair.setNumberOfThreads(threads);
  stages_.poisson.setNumberOfThreads(threads);
}

void
StructureChain::setPriors(const Priors& priors)
{
  stages_.room_segmentation.setHeadroom(priors.min_headroom);
  stages_.room_segmentation.setPriors(priors);
  stages_.floorplan_fitting.setPriors(priors);
  stages_.opening_detection.setPriors(priors);
}

void
StructureChain::reset()
{
  if (enlarged_from_ > 0)
    enlargeCells(stages_, enlarged_from_); // back to smaller cells
  enlarged_from_ = 0;
  model_ = StructureModel();
  model_.stays_level = known_.keep_levelled;
  seems_in_feet_ = false;
  up_doubt_.clear();
  missing_.clear();
}

void
StructureChain::setCloud(const Cloud::ConstPtr& thinned)
{
  model_.cloud.reset(new Cloud(*thinned));
  model_.labels.assign(thinned->size(), 0);
  model_.rooms.assign(thinned->size(), 0);
  model_.owners.assign(thinned->size(), 0);
}

bool
StructureChain::stop(const std::string& stage, const std::string& reason)
{
  model_.failed_stage = stage;
  model_.problem =
      missing_.empty() || reason == missing_ ? reason : missing_ + " (" + reason + ")";
  const std::string doubt = inchProblem(PointView(*model_.cloud), 0);
  if (!doubt.empty())
    model_.problem += "; " + doubt;
  if (!up_doubt_.empty() && reason != up_doubt_)
    model_.problem += "; " + up_doubt_;
  return false;
}

bool
StructureChain::refuse(const std::string& reason)
{
  return stop("input", reason);
}

/** @brief Calls a stage and stores its report, unless the run is cancelled.
 * @param step returns why it failed, a sentence; empty after success, or if it refused
 * the scan */
bool
StructureChain::runStage(const std::string& name,
                         std::size_t points_in,
                         const std::function<std::string(StageReport&)>& step)
{
  model_.failed_stage.clear();
  model_.problem.clear();
  if (callback_ && !callback_(name)) {
    model_.failed_stage = name;
    model_.problem = "cancelled before " + name;
    return false;
  }
  StageReport report{name, points_in, 0, 0};
  const auto start = std::chrono::steady_clock::now();
  const std::string problem = step(report);
  report.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  model_.reports.push_back(report);
  if (!problem.empty())
    stop(name, problem);
  return model_.problem.empty();
}

/** @brief Checks priors and which direction is up, and finds how a tilted scan is
 * levelled. */
bool
StructureChain::checkScan(const ScanPositions& positions)
{
  if (const std::string wrong = problemOf(getPriors()); !wrong.empty())
    return refuse(wrong);
  if (known_.trust_up)
    return true;
  std::vector<Eigen::Vector3d> stations;
  for (const ScanPosition& position : positions)
    if (position.isKnown())
      stations.push_back(position.place.cast<double>());
  pcl::Indices all(model_.cloud->size());
  std::iota(all.begin(), all.end(), 0);
  const MissingSurfaces missing =
      missingSurfaces(PointView(*model_.cloud), all, threads_, getPriors());
  missing_ = missing.reason;
  if (missing.is_noisy)
    model_.warnings.push_back({WarningKind::Noise, {100 * missing.scatter}});
  const UpDoubt doubt =
      doubtOfUp(PointView(*model_.cloud), all, stations, threads_, getPriors(),
                {known_.up_is_known, known_.unit_is_known});
  seems_in_feet_ = doubt.is_in_feet;
  if (doubt.isDoubtful())
    up_doubt_ = doubt.reason;
  if (doubt.isCertain())
    return refuse(doubt.reason);
  if (doubt.feet_nats > UpDoubt::certain)
    return refuse(doubt.unit_reason);
  if (doubt.isDoubtful())
    model_.warnings.push_back({WarningKind::Up, {}, 0, 0, doubt.reason});
  if (doubt.tilt.angle > 0) {
    model_.levelling = Levelling::of(doubt.tilt.up, middleOf(*model_.cloud));
    model_.warnings.push_back(warningOf(WarningKind::Levelled,
                                        model_.stays_level
                                            ? "points, mesh and solid stay level"
                                            : "points, mesh and solid are turned back",
                                        {model_.levelling->angle() * 180 / M_PI,
                                         model_.levelling->direction() * 180 / M_PI}));
  }
  return true;
}

bool
StructureChain::findStructure(const Cloud::ConstPtr& thinned)
{
  if (!thinned)
    return refuse("no cloud was given");
  reset();
  setCloud(thinned);
  if (!checkScan({}))
    return false;
  model_.frame = model_.levelFrame();
  moveCloud(model_.frame, *model_.cloud);
  stages_.floorplan_fitting.moveRawPoints(
      [&](const Eigen::Vector3d& p) { return model_.frame.toBuilding(p); });
  return runStages();
}

/** @brief Refuses a scan whose plan is that of a building in feet. */
bool
StructureChain::checkUnit()
{
  if (known_.unit_is_known)
    return true;
  const auto& sight = model_.mirrored.lines;
  const UnitDoubt doubt = footProblem(
      *model_.plan, stages_.room_segmentation.getBuilding().links,
      sight ? sight->places() : std::vector<Eigen::Vector3f>(), getPriors());
  if (doubt.nats > UpDoubt::certain)
    return refuse(doubt.reason);
  model_.unit_doubt = doubt.reason;
  if (!doubt.reason.empty())
    model_.warnings.push_back(warningOf(WarningKind::Unit, doubt.reason));
  return true;
}

bool
StructureChain::runStages()
{
  warnOfInput(stages_.floorplan_fitting.getRawPoints(), model_);
  const double size = getGridSize();
  ChainRun run{stages_, model_, plane_tolerance_,
               seems_in_feet_ && !known_.unit_is_known};
  const auto runOn = [&](const char* name, std::size_t points_in, auto stage) {
    return runStage(name, points_in,
                    [&](StageReport& report) { return (run.*stage)(report); });
  };
  const std::size_t n = model_.cloud->size();
  const bool is_found =
      runOn("RoomSegmentation", n, &ChainRun::partRooms) &&
      runOn("HorizontalPlaneDetection", n, &ChainRun::findPlanes) &&
      runOn("CeilingBoundaryWallGrowing", n, &ChainRun::findWalls) &&
      runOn("FloorplanFitting", n, &ChainRun::fitPlan) && checkUnit() &&
      runOn("OpeningDetection", n, &ChainRun::findOpenings) &&
      runOn("StructureRefinement", n, &ChainRun::refine) &&
      runOn("VerticalHoleRepair", model_.reports.back().points_out, &ChainRun::repair);
  if (getGridSize() > size)
    enlarged_from_ = size;
  model_.coverage = coverageOf(stages_.room_segmentation.getBuilding(), *model_.plan);
  moveBack(model_);
  return is_found &&
         runOn("FloorplanExtrusion", model_.structure->size(), &ChainRun::extrude);
}

bool
StructureChain::makeMesh()
{
  ChainRun run{stages_, model_};
  return runStage("StructuralPoisson", model_.structure->size(),
                  [&](StageReport& report) { return run.makeMesh(report); });
}

TriangleMesh
StructureChain::meshInScanFrame() const
{
  TriangleMesh mesh = model_.inScanFrame(stages_.poisson.getMesh());
  if (model_.isMoved())
    partEqualPositions(mesh); // as floats, two rotated positions may coincide
  return mesh;
}

} // namespace pcl::sedr

PCL_INSTANTIATE(IndoorStructureReconstruction, SEDR_POINT_TYPES)
