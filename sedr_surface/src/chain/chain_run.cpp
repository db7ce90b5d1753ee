// SPDX-License-Identifier: BSD-3-Clause
#include "chain_run.h"

#include "sedr_filters/src/rays/sight_lines.h"
#include "sedr_segmentation/src/scan/unit_check.h"

#include <chrono>
#include <cmath>
#include <map>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace pcl::sedr {

template <typename Step>
bool
ChainRun::runStage(const std::string& name, std::size_t points_in, Step step)
{
  if (chain_.on_stage)
    chain_.on_stage(name);
  StageReport report{name, points_in, 0, 0};
  chain_.failed_stage = name;
  if (chain_.is_cancelled && chain_.is_cancelled()) {
    chain_.problem = "cancelled before " + name;
    return false;
  }
  const auto start = std::chrono::steady_clock::now();
  const bool is_done = step(report);
  report.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
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
ChainRun::warn(std::uint32_t room, const std::string& reason)
{
  warn({WarningKind::Stage, {}, room, 0, reason});
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
    warn({WarningKind::LostPoints,
          {100.0 * static_cast<double>(lost) / static_cast<double>(raw.size())}});
}

bool
ChainRun::findStructure()
{
  warnOfLostPoints();
  if (chain_.stray_limit > 0)
    warn({WarningKind::Strays, {static_cast<double>(chain_.stray_limit)}});
  const MirrorFigures& mirrored = chain_.mirrored;
  if (mirrored.untrue > 0)
    warn({WarningKind::Positions,
          {static_cast<double>(mirrored.untrue),
           static_cast<double>(mirrored.positions)}});
  if (mirrored.points > 0)
    warn({WarningKind::Mirrors,
          {static_cast<double>(mirrored.mirrors),
           static_cast<double>(mirrored.points)}});
  if (!checkScan())
    return false;
  levelScan();
  makeWallsVertical();
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

void
ChainRun::compareVolumes()
{
  constexpr double exact = 0.2; // of a cell: how exact the surface of a mesh is
  if (chain_.extrusion.getCutOpenings())
    return; // the mesh has none

  std::map<std::uint32_t, double> volumes; // of closed solids, by room
  for (const RoomSolidReport& solid : chain_.extrusion.getReports())
    if (solid.closed)
      volumes[solid.room] = solid.volume;
  for (const RoomPoissonReport& mesh : chain_.poisson.getReports()) {
    const auto solid = volumes.find(mesh.room);
    if (mesh.closed && solid != volumes.end() &&
        std::abs(mesh.volume - solid->second) > exact * mesh.cell * mesh.area)
      warn({WarningKind::MeshVolume, {mesh.volume, solid->second}, mesh.room});
  }
}

bool
ChainRun::makeMesh()
{
  return runStage("StructuralPoisson", chain_.structure->size(),
                  [&](StageReport& report) {
                    chain_.poisson.setInputCloud(chain_.structure);
                    const bool is_made = chain_.poisson.makeMesh();
                    giveFreedMemoryBack();
                    report.points_out = chain_.poisson.getMesh().vertices.size();
                    if (!is_made)
                      return fail(chain_.poisson.getErrorMessage());
                    for (const RoomPoissonReport& mesh : chain_.poisson.getReports())
                      for (const std::string* reason : {&mesh.problem, &mesh.warning})
                        if (!reason->empty())
                          warn({WarningKind::Mesh, {}, mesh.room, 0, *reason});
                    compareVolumes();
                    return true;
                  });
}

} // namespace pcl::sedr
