// SPDX-License-Identifier: BSD-3-Clause
#include "chain_run.h"

#include "sedr_filters/src/rays/sight_lines.h"
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

template <typename Step>
bool
ChainRun::runStage(const std::string& name, std::size_t points_in, Step step)
{
  if (chain_.on_stage)
    chain_.on_stage(name);
  StageReport report{name, points_in, 0, 0};
  chain_.failed_stage = name;
  const auto start = std::chrono::steady_clock::now();
  const bool is_done = step(report);
  report.seconds = secondsSince(start);
  chain_.reports.push_back(report);
  if (is_done)
    chain_.failed_stage.clear();
  return is_done;
}

bool
ChainRun::fail(const std::string& reason)
{
  chain_.problem = reason;
  const std::string doubt = inchProblem(PointView(*chain_.cloud), 0);
  if (!doubt.empty())
    chain_.problem += "; " + doubt;
  return false;
}

void
ChainRun::tellResult(const char* stage, std::uint32_t room) const
{
  if (chain_.on_result)
    chain_.on_result(stage, room);
}

void
ChainRun::warn(std::uint32_t room, const std::string& reason)
{
  chain_.warnings.push_back("room " + std::to_string(room) + ": " + reason);
}

/** @brief Warns if half of the scanned points and more are not finite. */
void
ChainRun::warnOfLostPoints()
{
  const PointView raw = chain_.floorplan_fitting.getRawPoints();
  std::size_t lost = 0;
  for (std::size_t i = 0; i < raw.size(); ++i)
    lost += raw.isFinite(i) ? 0 : 1;
  if (lost > 0 && 2 * lost >= raw.size())
    chain_.warnings.push_back(std::to_string(100 * lost / raw.size()) +
                              " % of the points are not finite: they were left out");
}

bool
ChainRun::findStructure()
{
  warnOfLostPoints();
  if (chain_.stray_limit > 0)
    chain_.warnings.push_back(
        "points are scattered all over the air of the scan: voxels of fewer than " +
        std::to_string(chain_.stray_limit) + " points were left out");
  if (chain_.mirrored.untrue > 0)
    chain_.warnings.push_back(
        std::to_string(chain_.mirrored.untrue) + " of " +
        std::to_string(chain_.mirrored.positions) +
        " positions of the scanner are not where the points were taken "
        "from: they lie on a surface, or rays from there go through walls that were "
        "seen; what they would tell was left out");
  if (chain_.mirrored.points > 0)
    chain_.warnings.push_back(
        std::to_string(chain_.mirrored.mirrors) +
        (chain_.mirrored.mirrors == 1 ? " surface mirrors" : " surfaces mirror") +
        ", as the scanner's positions tell: " + std::to_string(chain_.mirrored.points) +
        " thinned points seen in them were left out");
  if (!checkScan())
    return false;
  levelScan();
  straightenScan();
  const std::size_t n = chain_.cloud->size();
  return runStage("RoomSegmentation", n, [&](auto& r) { return partRooms(r); }) &&
         runStage("HorizontalPlaneDetection", n,
                  [&](auto& r) { return findPlanes(r); }) &&
         runStage("FloorProjectionRecovery", n,
                  [&](auto& r) { return recoverFloors(r); }) &&
         runStage("CeilingBoundaryWallGrowing", n,
                  [&](auto& r) { return growWalls(r); }) &&
         runStage("FloorplanFitting", chain_.cloud->size(),
                  [&](auto& r) { return fitPlan(r); }) &&
         runStage("OpeningDetection", chain_.cloud->size(),
                  [&](auto& r) { return findOpenings(r); }) &&
         runStage("StructureRefinement", chain_.cloud->size(),
                  [&](auto& r) { return refine(r); }) &&
         runStage("VerticalHoleRepair", chain_.reports.back().points_out,
                  [&](auto& r) { return repair(r); }) &&
         runStage("FloorplanExtrusion", chain_.structure->size(),
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
ChainRun::makeMesh()
{
  return runStage("StructuralPoisson", chain_.structure->size(),
                  [&](StageReport& report) {
                    chain_.poisson.setInputCloud(chain_.straight_structure_);
                    const bool is_made = chain_.poisson.makeMesh();
                    giveFreedMemoryBack();
                    report.points_out = chain_.poisson.getMesh().vertices.size();
                    if (!is_made)
                      return fail(chain_.poisson.getErrorMessage());
                    tellResult("StructuralPoisson");
                    if (!chain_.poisson.getErrorMessage().empty())
                      chain_.warnings.push_back(chain_.poisson.getErrorMessage());
                    return true;
                  });
}

} // namespace pcl::sedr
