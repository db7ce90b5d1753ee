// SPDX-License-Identifier: BSD-3-Clause
#include "chain_run.h"
#include "sedr_filters/src/base/labels.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/plan/plan_surfaces.h"
#include "sedr_filters/src/rays/sight_lines.h"
#include "sedr_filters/src/walls/plan_evidence.h"
#include "sedr_segmentation/src/faces/room_cells.h"
#include "sedr_segmentation/src/niches/niche_fit.h"
#include "sedr_segmentation/src/scan/scan_up.h"
#include "sedr_segmentation/src/scan/unit_check.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/plan_warning.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/tilted_walls.h>
#include <pcl/sedr_segmentation/building.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

namespace pcl::sedr {

pcl::IndicesPtr
ChainRun::labelled(StructureLabel label) const
{
  pcl::IndicesPtr indices(new pcl::Indices);
  for (std::size_t i = 0; i < chain_.labels.size(); ++i)
    if (chain_.labels[i] == valueOf(label))
      indices->push_back(static_cast<int>(i));
  return indices;
}

pcl::IndicesPtr
ChainRun::labelled(StructureLabel label, std::uint32_t room) const
{
  pcl::IndicesPtr indices(new pcl::Indices);
  for (const int i : shares_[room]) {
    const auto at = static_cast<std::size_t>(i);
    if (chain_.labels[at] == valueOf(label) && chain_.rooms[at] == room)
      indices->push_back(i);
  }
  return indices;
}

void
ChainRun::shareOut()
{
  shares_.assign(regions_.size() + 1, {});
  for (std::size_t i = 0; i < chain_.rooms.size(); ++i)
    if (chain_.rooms[i] < shares_.size())
      shares_[chain_.rooms[i]].push_back(static_cast<int>(i));
}

pcl::IndicesPtr
ChainRun::nearRim(std::size_t r) const
{
  const CellGrid grid(chain_.plane_detection.getGridSize());
  const CellSet& scope = regions_[r].scope;
  const CellMask inner =
      eroded(CellMask(scope, boxOf(scope)),
             chain_.wall_growing.getDistanceThreshold() / grid.size());
  pcl::IndicesPtr near(new pcl::Indices);
  for (const int i : *owned_[r])
    if (const auto& p = (*chain_.cloud)[static_cast<std::size_t>(i)];
        chain_.labels[static_cast<std::size_t>(i)] == 0 && !inner.at(grid.at(p.x, p.y)))
      near->push_back(i);
  return near;
}

pcl::Indices
ChainRun::besideHidden(std::size_t r, const pcl::Indices& near_rim) const
{
  const CellGrid grid(chain_.plane_detection.getGridSize());
  const CellSet hidden = cellsOf(grid, regions_[r].hidden.ceiling);
  if (hidden.empty())
    return {};
  const double reach = chain_.wall_growing.getDistanceThreshold() / grid.size();
  const CellMask beside = dilated(
      CellMask(hidden, grown(boxOf(hidden), static_cast<int>(std::ceil(reach)))),
      reach);
  pcl::Indices found;
  std::copy_if(near_rim.begin(), near_rim.end(), std::back_inserter(found), [&](int i) {
    const auto& p = (*chain_.cloud)[static_cast<std::size_t>(i)];
    return beside.at(grid.at(p.x, p.y));
  });
  return found;
}

bool
ChainRun::growWalls(StageReport& report)
{
  chain_.wall_growing.setInputCloud(chain_.cloud);
  shareOut();
  std::string problem = "no point lies within " +
                        std::to_string(chain_.wall_growing.getDistanceThreshold()) +
                        " m in plan of the boundary of the ceilings";
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    const auto room = static_cast<std::uint32_t>(r + 1);
    const pcl::IndicesPtr near = nearRim(r);
    chain_.wall_growing.setIndices(near);
    chain_.wall_growing.setCeilingIndices(labelled(StructureLabel::Ceiling, room));
    pcl::PointIndices walls;
    if (!chain_.wall_growing.segment(walls)) {
      problem = chain_.wall_growing.getErrorMessage();
      warn(room, problem);
      continue;
    }
    for (const int i : chain_.wall_growing.getWallIndices())
      give(i, StructureLabel::Wall, room);
    for (const int i : besideHidden(r, *near))
      give(i, StructureLabel::Wall, room);
  }
  report.points_out = labelled(StructureLabel::Wall)->size();
  return report.points_out > 0 || fail(problem);
}

bool
ChainRun::fitPlan(StageReport& report)
{
  chain_.floorplan_fitting.setInputCloud(chain_.cloud);
  chain_.floorplan_fitting.setCeilingIndices(labelled(StructureLabel::Ceiling));
  chain_.floorplan_fitting.setFloorIndices(labelled(StructureLabel::Floor));
  chain_.floorplan_fitting.setWallIndices(labelled(StructureLabel::Wall));
  chain_.floorplan_fitting.setRooms(chain_.rooms);
  std::map<std::uint32_t, HiddenCells> hidden;
  for (std::size_t r = 0; r < regions_.size(); ++r)
    hidden[static_cast<std::uint32_t>(r + 1)] = std::move(regions_[r].hidden);
  chain_.floorplan_fitting.setHiddenCells(std::move(hidden));
  chain_.floorplan_fitting.setOwners(owners_);
  if (!chain_.floorplan_fitting.segment(*chain_.plan))
    return fail(chain_.floorplan_fitting.getErrorMessage());
  if (sight_) {                        // rays prove openings
    constexpr double tolerance = 0.05; // metres; points within lie on a wall
    measureEvidence(*chain_.plan, PointView(*chain_.cloud),
                    *allIndices(chain_.cloud->size()), tolerance,
                    chain_.room_segmentation.getNumberOfThreads(), sight_.get());
  }
  chain_.warnings.insert(chain_.warnings.end(),
                         chain_.floorplan_fitting.getWarnings().begin(),
                         chain_.floorplan_fitting.getWarnings().end());
  giveStoreys(chain_.getBuilding(), *chain_.plan);
  if (!chain_.unit_is_known) {
    const UnitDoubt doubt = footProblem(
        *chain_.plan, chain_.getBuilding().links,
        sight_ ? sight_->places() : std::vector<Eigen::Vector3f>(), chain_.priors_);
    if (doubt.nats > UpDoubt::certain)
      return refuse(doubt.reason);
    chain_.unit_doubt = doubt.reason;
  }
  if (!chain_.unit_doubt.empty())
    warn(warningOf(WarningKind::Unit, chain_.unit_doubt));
  for (const auto& room : chain_.plan->rooms)
    for (const auto& element : room.boundary.elements)
      report.points_out += element.inliers;
  giveUpRoomsWithoutPlan();
  for (const PlanRoom& room : chain_.plan->rooms)
    labelRisers(room);
  labelNiches();
  return true;
}

bool
ChainRun::findOpenings(StageReport& report)
{
  const PointView raw = chain_.floorplan_fitting.getRawPoints();
  const bool has_raw = raw.size() > 0;
  const PointView points = has_raw ? raw : PointView(*chain_.cloud);
  report.points_in = points.size();
  chain_.opening_detection.setSightLines(sight_);
  if (!chain_.opening_detection.segment(
          points, has_raw ? chain_.floorplan_fitting.getRawIndices() : nullptr,
          *chain_.plan))
    return fail(chain_.opening_detection.getErrorMessage());
  numberOpenings(*chain_.plan);
  for (PlanWarning& warning : linksWithoutOpening(chain_.getBuilding(), *chain_.plan))
    warn(std::move(warning));
  for (PlanWarning& warning :
       unexplainedSurfaces(PointView(*chain_.cloud), chain_.getBuilding(), *chain_.plan,
                           chain_.priors_))
    warn(std::move(warning));
  report.points_out = chain_.plan->openings.size();
  return true;
}

void
ChainRun::giveUpRoomsWithoutPlan()
{
  shareOut();
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    const auto id = static_cast<std::uint32_t>(r + 1);
    if (!findRoom(*chain_.plan, id))
      for (const int i : shares_[id]) {
        const auto at = static_cast<std::size_t>(i);
        if (chain_.rooms[at] == id)
          chain_.labels[at] = chain_.rooms[at] = 0;
      }
  }
}

void
ChainRun::labelRisers(const PlanRoom& room)
{
  const bool is_tilted = isTilted(room);
  if (room.details.empty() && room.floor_details.empty() && !is_tilted)
    return;
  const RoomSurfaces surfaces(room, chain_.refinement.getMaximumDistance());
  SurfacePoint snapped;
  for (const int i : *owned_[room.id - 1]) {
    const auto at = static_cast<std::size_t>(i);
    const Eigen::Vector3d p = (*chain_.cloud)[at].getVector3fMap().cast<double>();
    const bool is_ceiling = is_tilted &&
                            chain_.labels[at] == valueOf(StructureLabel::Ceiling) &&
                            !surfaces.snap(p, StructureLabel::Ceiling, snapped);
    if (chain_.labels[at] != 0 && !is_ceiling)
      continue;
    if (surfaces.snap(p, StructureLabel::Detail, snapped) && snapped.normal.z() == 0)
      give(i, StructureLabel::Detail, room.id);
    else if (is_tilted && surfaces.snap(p, StructureLabel::Wall, snapped))
      give(i, StructureLabel::Wall, room.id);
  }
}

void
ChainRun::labelNiches()
{
  const double reach = chain_.refinement.getMaximumDistance();
  std::vector<const PlanRoom*> recessed(regions_.size(), nullptr);
  std::vector<std::optional<RoomSurfaces>> surfaces(regions_.size());
  for (const PlanRoom& room : chain_.plan->rooms)
    if (!room.niches.empty()) {
      recessed[room.id - 1] = &room;
      surfaces[room.id - 1].emplace(room, reach);
    }
  if (!std::any_of(recessed.begin(), recessed.end(), [](auto* room) { return room; }))
    return;
  for (std::size_t at = 0; at < chain_.cloud->size(); ++at) {
    if (owners_[at].room == 0 || !recessed[owners_[at].room - 1])
      continue;
    const std::size_t region = owners_[at].room - 1;
    const Eigen::Vector3f place = (*chain_.cloud)[at].getVector3fMap();
    const PlanRoom& room = *recessed[region];
    const Eigen::Vector3d p = place.cast<double>();
    SurfacePoint snapped;
    if (room.nicheAt(p.head<2>()) >= 0 && !room.boundary.contains(p.head<2>()) &&
        surfaces[region]->snap(p, StructureLabel::Detail, snapped))
      give(static_cast<int>(at), StructureLabel::Detail, room.id);
  }
}

} // namespace pcl::sedr
