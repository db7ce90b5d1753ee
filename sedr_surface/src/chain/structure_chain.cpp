// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_surface/room_jobs.h>
#include <pcl/sedr_surface/structure_chain.h>

#include "sedr_filters/src/base/large_memory.h"
#include "sedr_segmentation/src/scan/unit_check.h"

#include <chrono>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace pcl::sedr {

namespace {

double
secondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
      .count();
}

} // namespace

StructureChain::StructureChain()
{
  reset(Cloud::ConstPtr(new Cloud));
  // In a round room, facets of 0.5 mm would dominate the distance from solid to truth.
  extrusion.setChordTolerance(0.00025);
}

void
StructureChain::setGridSize(double size)
{
  restoreCells();
  setCells(size);
}

void
StructureChain::setPriors(const Priors& priors)
{
  priors_ = priors;
  room_segmentation.setHeadroom(priors.min_headroom);
  room_segmentation.setWidestDoor(priors.max_door_width);
  plane_detection.setPriors(priors);
  slice_detail.setPriors(priors);
  floorplan_fitting.setPriors(priors);
}

void
StructureChain::setCells(double size)
{
  plane_detection.setGridSize(size);
  room_segmentation.setGridSize(size);
  slice_detail.setGridSize(size);
  floor_recovery.setGridSize(size);
  floorplan_fitting.setGridSize(size);
  hole_repair.setGridSize(size);
}

/** @brief Enlarges the cells of the stages that analyse the scan; repaired points keep
 * their density. */
void
StructureChain::enlargeCells(double size)
{
  const double least = plane_detection.getGridSize();
  const double repaired = hole_repair.getGridSize();
  setCells(size);
  hole_repair.setGridSize(repaired);
  wall_growing.setDistanceThreshold(wall_growing.getDistanceThreshold() +
                                    2 * (size - least));
  enlarged_from_ = least;
}

void
StructureChain::restoreCells()
{
  if (enlarged_from_ > 0)
    enlargeCells(enlarged_from_); // back to smaller cells
  enlarged_from_ = 0;
}

void
StructureChain::reset(const Cloud::ConstPtr& thinned)
{
  restoreCells();
  // Points are added where a ceiling is hidden: usually at most a thirtieth.
  cloud.reset(new Cloud);
  reserveLarge(cloud->points, thinned->size() + thinned->size() / 30,
               room_segmentation.getNumberOfThreads());
  *cloud = *thinned;
  scanned_points_ = cloud->size();
  labels.clear();
  rooms.clear();
  for (auto* const values : {&labels, &rooms}) {
    values->reserve(cloud->points.capacity());
    values->resize(cloud->size(), 0);
  }
  planes.clear();
  plan = std::make_shared<Floorplan>();
  structure.reset(new StructureCloud);
  levelling.reset();
  straightening = Straightening();
  tilts.clear();
  tilted_faces_.clear();
  straight_plan_ = plan;
  straight_structure_ = structure;
  refined_.clear();
  repaired_shares_.clear();
  unseen_.clear();
  reports.clear();
  warnings.clear();
  unit_doubt.clear();
  failed_stage.clear();
  problem.clear();
  regions_.clear();
  territory_.clear();
  slice_height_.clear();
}

template <typename Step>
bool
StructureChain::runStage(const std::string& name, std::size_t points_in, Step step)
{
  if (on_stage)
    on_stage(name);
  StageReport report{name, points_in, 0, 0};
  failed_stage = name;
  const auto start = std::chrono::steady_clock::now();
  const bool is_done = step(report);
  report.seconds = secondsSince(start);
  reports.push_back(report);
  if (is_done)
    failed_stage.clear();
  return is_done;
}

bool
StructureChain::fail(const std::string& reason)
{
  problem = reason;
  const std::string doubt = inchProblem(PointView(*cloud), 0);
  if (!doubt.empty())
    problem += "; " + doubt;
  return false;
}

void
StructureChain::tellResult(const char* stage, std::uint32_t room) const
{
  if (on_result)
    on_result(stage, room);
}

void
StructureChain::warn(std::uint32_t room, const std::string& reason)
{
  warnings.push_back("room " + std::to_string(room) + ": " + reason);
}

bool
StructureChain::findStructure(const Cloud::ConstPtr& thinned)
{
  if (!thinned)
    return fail("no cloud was given");
  reset(thinned);
  sight_ = mirrored.lines;
  if (stray_limit > 0)
    warnings.push_back(
        "points are scattered all over the air of the scan: voxels of fewer than " +
        std::to_string(stray_limit) + " points were left out");
  if (mirrored.untrue > 0)
    warnings.push_back(std::to_string(mirrored.untrue) + " of " +
                       std::to_string(mirrored.positions) +
                       " positions of the scanner are not where the points were taken "
                       "from: rays from there go through walls that were seen; what "
                       "they would tell was left out");
  if (mirrored.points > 0)
    warnings.push_back(
        std::to_string(mirrored.mirrors) +
        (mirrored.mirrors == 1 ? " surface mirrors" : " surfaces mirror") +
        ", as the scanner's positions tell: " + std::to_string(mirrored.points) +
        " thinned points seen in them were left out");
  if (!checkScan())
    return false;
  levelScan();
  straightenScan();
  const std::size_t n = cloud->size();
  return runStage("RoomSegmentation", n, [&](auto& r) { return partRooms(r); }) &&
         runStage("HorizontalPlaneDetection", n,
                  [&](auto& r) { return findPlanes(r); }) &&
         runStage("GridSliceDetail", n, [&](auto& r) { return findDetails(r); }) &&
         runStage("FloorProjectionRecovery", n,
                  [&](auto& r) { return recoverFloors(r); }) &&
         runStage("CeilingBoundaryWallGrowing", n,
                  [&](auto& r) { return growWalls(r); }) &&
         runStage("FloorplanFitting", cloud->size(),
                  [&](auto& r) { return fitPlan(r); }) &&
         runStage("StructureRefinement", cloud->size(),
                  [&](auto& r) { return refine(r); }) &&
         runStage("VerticalHoleRepair", reports.back().points_out,
                  [&](auto& r) { return repair(r); }) &&
         runStage("FloorplanExtrusion", structure->size(),
                  [&](auto& r) { return extrude(r); });
}

namespace {

/** @brief Returns freed memory to the system. Each thread keeps its own, and other
 * threads run the next stage. */
void
giveFreedMemoryBack()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

} // namespace

bool
StructureChain::makeMesh()
{
  return runStage("StructuralPoisson", structure->size(), [&](StageReport& report) {
    poisson.setInputCloud(straight_structure_);
    poisson.setFloorplan(mesh_from_plan ? straight_plan_ : nullptr);
    poisson.setRoomWorkers(room_workers);
    const bool is_made = poisson.makeMesh();
    giveFreedMemoryBack();
    report.points_out = poisson.getMesh().vertices.size();
    if (!is_made)
      return fail(poisson.getErrorMessage());
    tellResult("StructuralPoisson");
    if (!poisson.getErrorMessage().empty())
      warnings.push_back(poisson.getErrorMessage());
    return true;
  });
}

} // namespace pcl::sedr
