// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_surface/room_jobs.h>
#include <pcl/sedr_surface/structure_chain.h>

#include <pcl/sedr_filters/impl/refinement.h>

#include <algorithm>
#include <cstdio>

namespace pcl::sedr {

namespace {

std::shared_ptr<const Floorplan>
planOf(const PlanRoom& room)
{
  return std::make_shared<const Floorplan>(Floorplan{{room}});
}

} // namespace

StructureChain::StructureCloud::Ptr
StructureChain::labelledCloud(std::uint32_t room) const
{
  StructureCloud::Ptr points(new StructureCloud);
  points->reserve(shares_[room].size());
  for (const int i : shares_[room]) {
    const auto at = static_cast<std::size_t>(i);
    pcl::PointStructure p;
    p.getVector3fMap() = (*cloud)[at].getVector3fMap();
    p.label = labels[at];
    p.room = room;
    if (p.label != 0)
      points->push_back(p);
  }
  return points;
}

bool
StructureChain::refine(StageReport& report)
{
  if (room_workers)
    return refineElsewhere(report);
  shareOut();
  for (const PlanRoom& room : straight_plan_->rooms) {
    refined_.emplace_back(new StructureCloud);
    refinement.setInputCloud(labelledCloud(room.id));
    refinement.setFloorplan(planOf(room));
    refinement.filter(*refined_.back());
    if (!refinement.getErrorMessage().empty())
      return fail(refinement.getErrorMessage());
    tellResult("StructureRefinement", room.id);
    report.points_out += refined_.back()->size();
  }
  refinement.setFloorplan(straight_plan_);
  return report.points_out > 0 || fail("no labelled point lies on the floor plan");
}

bool
StructureChain::repair(StageReport& report)
{
  const double size = hole_repair.getGridSize();
  const std::string excess = size > 0 ? surfaceCellsProblem(*straight_plan_, size) : "";
  if (!excess.empty())
    return fail(excess);
  for (std::size_t r = 0; r < refined_.size(); ++r) { // empty if done elsewhere
    const PlanRoom& room = straight_plan_->rooms[r];
    StructureCloud whole;
    hole_repair.setInputCloud(refined_[r]);
    hole_repair.setFloorplan(planOf(room));
    refined_[r].reset(); // points kept twice would be most of the memory
    hole_repair.filter(whole);
    if (!hole_repair.getErrorMessage().empty())
      return fail(hole_repair.getErrorMessage());
    tellResult("VerticalHoleRepair", room.id);
    for (const auto& [id, shares] : hole_repair.getUnseenShares())
      unseen_[id] = shares;
    if (!whole.empty())
      repaired_shares_[room.id] =
          static_cast<double>(hole_repair.getRepairedIndices().size()) /
          static_cast<double>(whole.size());
    *structure += whole;
  }
  hole_repair.setFloorplan(straight_plan_);
  report.points_out = structure->size();
  tiltStructure();
  warnOfGuesses();
  return true;
}

void
StructureChain::warnOfGuesses()
{
  constexpr double most = 0.45;
  for (const auto& [room, unseen] : unseen_) {
    if (std::max(unseen.surface, unseen.walls) <= most)
      continue;
    const bool is_surface = unseen.surface > most;
    char text[120];
    std::snprintf(text, sizeof text,
                  "%.0f %% of its %s were filled in, not seen: its walls may be "
                  "elsewhere",
                  100 * (is_surface ? unseen.surface : unseen.walls),
                  is_surface ? "surface" : "walls");
    warn(room, text);
  }
}

bool
StructureChain::extrude(StageReport& report)
{
  extrusion.setFloorplan(plan);
  extrusion.setTilts(tilts);
  pcl::PolygonMesh unused;
  extrusion.reconstruct(unused);
  tellResult("FloorplanExtrusion");
  report.points_out = extrusion.getMesh().vertices.size();
  warnings.insert(warnings.end(), extrusion.getWarnings().begin(),
                  extrusion.getWarnings().end());
  // The mesh does not need the solids: rooms without one are reported, the run
  // continues.
  if (!extrusion.getErrorMessage().empty())
    warnings.push_back(extrusion.getErrorMessage());
  return true;
}

} // namespace pcl::sedr
