// SPDX-License-Identifier: BSD-3-Clause
#include "chain_run.h"

#include <pcl/sedr_filters/impl/refinement.h>
#include <pcl/sedr_filters/wall_shares.h>

#include <cmath>
#include <map>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace pcl::sedr {

namespace {

std::shared_ptr<const Floorplan>
planOf(const PlanRoom& room)
{
  return std::make_shared<const Floorplan>(Floorplan{{room}});
}

} // namespace

StructureChain::StructureCloud::Ptr
ChainRun::labelledCloud(std::uint32_t room) const
{
  StructureCloud::Ptr points(new StructureCloud);
  points->reserve(shares_[room].size());
  for (const int i : shares_[room]) {
    const auto at = static_cast<std::size_t>(i);
    pcl::PointStructure p;
    p.getVector3fMap() = (*chain_.cloud)[at].getVector3fMap();
    p.label = chain_.labels[at];
    p.room = room;
    if (p.label != 0)
      points->push_back(p);
  }
  return points;
}

bool
ChainRun::refine(StageReport& report)
{
  shareOut();
  std::string problem = "no labelled point lies on the floor plan";
  for (const PlanRoom& room : chain_.plan->rooms) {
    refined_.emplace_back(new StructureCloud);
    chain_.refinement.setInputCloud(labelledCloud(room.id));
    chain_.refinement.setFloorplan(planOf(room));
    chain_.refinement.filter(*refined_.back());
    if (!chain_.refinement.getErrorMessage().empty()) // a room without points is empty
      problem = chain_.refinement.getErrorMessage();
    report.points_out += refined_.back()->size();
  }
  chain_.refinement.setFloorplan(chain_.plan);
  return report.points_out > 0 || fail(problem);
}

bool
ChainRun::repair(StageReport& report)
{
  const double size = chain_.hole_repair.getGridSize();
  const std::string excess = size > 0 ? surfaceCellsProblem(*chain_.plan, size) : "";
  if (!excess.empty())
    return fail(excess);
  for (std::size_t r = 0; r < refined_.size(); ++r) {
    if (refined_[r]->empty())
      continue;
    const PlanRoom& room = chain_.plan->rooms[r];
    StructureCloud whole;
    chain_.hole_repair.setInputCloud(refined_[r]);
    chain_.hole_repair.setFloorplan(planOf(room));
    refined_[r].reset(); // points kept twice would be most of the memory
    chain_.hole_repair.filter(whole);
    if (!chain_.hole_repair.getErrorMessage().empty())
      return fail(chain_.hole_repair.getErrorMessage());
    *chain_.structure += whole;
  }
  chain_.hole_repair.setFloorplan(chain_.plan);
  report.points_out = chain_.structure->size();
  warnOfGuesses();
  return true;
}

void
ChainRun::warnOfGuesses()
{
  constexpr double enough = 0.55;
  constexpr double worth_word = 0.5; // metres; shorter walls follow their neighbours
  const Floorplan& plan = *chain_.plan;
  for (const PlanRoom& room : plan.rooms) {
    const WallShares all = wallShares(plan, room);
    if (all.area > 0 && all.measured < enough)
      warn({WarningKind::FilledIn,
            {100 * (1 - all.measured), 100 * all.inferred, 100 * all.unseen},
            room.id});
    for (std::size_t e = 0; e < room.boundary.elements.size(); ++e) {
      const WallShares shares = wallShares(plan, room, e);
      const double length = room.boundary.elements[e].length();
      if (shares.isGuess() && length >= worth_word)
        warn({WarningKind::GuessedWall,
              {length, 100 * shares.inferred, 100 * shares.unseen},
              room.id,
              e + 1});
    }
  }
}

bool
ChainRun::extrude(StageReport& report)
{
  chain_.extrusion.setFloorplan(chain_.plan);
  pcl::PolygonMesh unused;
  chain_.extrusion.reconstruct(unused);
  report.points_out = chain_.extrusion.getMesh().vertices.size();
  chain_.warnings.insert(chain_.warnings.end(), chain_.extrusion.getWarnings().begin(),
                         chain_.extrusion.getWarnings().end());
  // The mesh does not need the solids: rooms without one are reported, the run
  // continues.
  for (const RoomSolidReport& solid : chain_.extrusion.getReports())
    if (!solid.problem.empty())
      warn({WarningKind::NoSolid, {}, solid.room, 0, solid.problem});
  return true;
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
ChainRun::mesh(StageReport& report)
{
  chain_.poisson.setInputCloud(chain_.structure);
  const bool is_made = chain_.poisson.makeMesh();
  giveFreedMemoryBack();
  report.points_out = chain_.poisson.getMesh().vertices.size();
  if (!is_made)
    return fail(chain_.poisson.getErrorMessage());
  for (const RoomPoissonReport& room : chain_.poisson.getReports())
    for (const std::string* reason : {&room.problem, &room.warning})
      if (!reason->empty())
        warn({WarningKind::Mesh, {}, room.room, 0, *reason});
  compareVolumes();
  return true;
}

} // namespace pcl::sedr
