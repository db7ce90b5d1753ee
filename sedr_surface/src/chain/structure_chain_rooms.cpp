// SPDX-License-Identifier: BSD-3-Clause
#include "../formats/labels.h"
#include "all_indices.h"
#include "sedr_filters/src/plan/plan_surfaces.h"
#include <pcl/sedr_surface/room_jobs.h>

#include <pcl/sedr_surface/structure_chain.h>

#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/plan/plan_evidence.h"
#include "sedr_filters/src/rays/sight_lines.h"
#include "sedr_segmentation/src/niches/niche_fit.h"
#include "sedr_segmentation/src/plan/doorway_reveals.h"
#include "sedr_segmentation/src/plan/room_territory.h"
#include "sedr_segmentation/src/scan/scan_check.h"

#include <algorithm>

namespace pcl::sedr {

pcl::IndicesPtr
StructureChain::labelled(StructureLabel label) const
{
  pcl::IndicesPtr indices(new pcl::Indices);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] == valueOf(label))
      indices->push_back(static_cast<int>(i));
  return indices;
}

pcl::IndicesPtr
StructureChain::labelled(StructureLabel label, std::uint32_t room) const
{
  pcl::IndicesPtr indices(new pcl::Indices);
  for (const int i : shares_[room]) {
    const auto at = static_cast<std::size_t>(i);
    if (labels[at] == valueOf(label) && rooms[at] == room)
      indices->push_back(i);
  }
  return indices;
}

void
StructureChain::shareOut()
{
  shares_.assign(regions_.size() + 1, {});
  for (std::size_t i = 0; i < rooms.size(); ++i)
    if (rooms[i] < shares_.size())
      shares_[rooms[i]].push_back(static_cast<int>(i));
}

bool
StructureChain::findDetails(StageReport& report)
{
  using Detection = decltype(slice_detail);
  slice_detail.setInputCloud(cloud);
  shareOut();
  std::vector<Detection> detections(regions_.size(), slice_detail);
  std::vector<pcl::PointIndices> details(regions_.size());
  const CellGrid grid(plane_detection.getGridSize());
  const auto detect = [&](std::size_t r, std::size_t) {
    const ChainRoom& region = regions_[r];
    if (region.scope.empty())
      return;
    const Eigen::Vector2d middle = grid.centre(region.scope[region.scope.size() / 2]);
    Detection& own = detections[r];
    own.setIndices(territory_[r]);
    own.setCeilingIndices(
        labelled(StructureLabel::Ceiling, static_cast<std::uint32_t>(r + 1)));
    own.setFloorHeight(region.floor_slab.heightAt(middle));
    own.segment(details[r]);
  };
  parallelBlocks(regions_.size(), 1, room_segmentation.getNumberOfThreads(), detect);

  for (std::size_t r = 0; r < regions_.size(); ++r) {
    const auto room = static_cast<std::uint32_t>(r + 1);
    if (regions_[r].scope.empty())
      warn(room, "no point of its ceiling was found: it is left out");
    slice_detail = std::move(detections[r]);
    if (!slice_detail.getErrorMessage().empty())
      warn(room, slice_detail.getErrorMessage());
    tellResult("GridSliceDetail", room);
    slice_height_.push_back(slice_detail.getSliceHeight());
    // Slices do not apply to vaults and roofs.
    const CellGrid& columns = getBuilding().grid;
    const CellSet level = levelColumns(r);
    for (const int i : details[r].indices) {
      const pcl::PointXYZ& p = (*cloud)[static_cast<std::size_t>(i)];
      if (!anyAround(level, columns.at(p.x, p.y), 1, [](std::size_t) { return true; }))
        continue;
      labels[static_cast<std::size_t>(i)] = valueOf(StructureLabel::Detail);
      rooms[static_cast<std::size_t>(i)] = room;
    }
    report.points_out += details[r].indices.size() + labelLowerCeilings(r);
  }
  return true;
}

bool
StructureChain::recoverFloors(StageReport& report)
{
  shareOut();
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    const auto room = static_cast<std::uint32_t>(r + 1);
    const pcl::IndicesPtr seen(new pcl::Indices(regions_[r].floor));
    pcl::ModelCoefficients::Ptr plane(new pcl::ModelCoefficients);
    for (int k = 0; k < 4; ++k)
      plane->values.push_back(static_cast<float>(regions_[r].floor_slab.plane[k]));
    floor_recovery.setInputCloud(cloud);
    floor_recovery.setIndices(seen);
    floor_recovery.setCeilingIndices(labelled(StructureLabel::Ceiling, room));
    floor_recovery.setDetailIndices(labelled(StructureLabel::Detail, room));
    floor_recovery.setFloorCoefficients(plane);
    Cloud whole;
    floor_recovery.filter(whole);
    if (!floor_recovery.getErrorMessage().empty()) {
      warn(room, floor_recovery.getErrorMessage());
      continue;
    }
    tellResult("FloorProjectionRecovery", room);
    const std::size_t kept = whole.size() - floor_recovery.getNumberOfProjected();
    for (std::size_t k = 0; k < whole.size(); ++k) {
      std::size_t at = cloud->size();
      if (k < kept)
        at = static_cast<std::size_t>(floor_recovery.getProjectedIndices()[k]);
      else {
        cloud->push_back(whole[k]);
        labels.push_back(0);
        rooms.push_back(0);
      }
      labels[at] = valueOf(StructureLabel::Floor);
      rooms[at] = room;
    }
    report.points_out += whole.size();
  }
  return true;
}

bool
StructureChain::growWalls(StageReport& report)
{
  wall_growing.setInputCloud(cloud);
  shareOut();
  if (room_workers)
    growWallsElsewhere(report);
  for (std::size_t r = 0; r < regions_.size() && !room_workers; ++r) {
    const auto room = static_cast<std::uint32_t>(r + 1);
    wall_growing.setIndices(territory_[r]);
    wall_growing.setCeilingIndices(labelled(StructureLabel::Ceiling, room));
    wall_growing.setFloorIndices(labelled(StructureLabel::Floor, room));
    wall_growing.setDetailIndices(labelled(StructureLabel::Detail, room));
    wall_growing.setSliceHeight(slice_height_[r]);
    pcl::PointIndices walls;
    if (!wall_growing.segment(walls)) {
      warn(room, wall_growing.getErrorMessage());
      continue;
    }
    tellResult("CeilingBoundaryWallGrowing", room);
    report.points_out += labelWalls(room, wall_growing.getWallIndices());
  }
  return report.points_out > 0 ||
         fail("no point lies within " +
              std::to_string(wall_growing.getDistanceThreshold()) +
              " m in plan of the boundary of the ceilings");
}

std::size_t
StructureChain::labelWalls(std::uint32_t room, const pcl::Indices& walls)
{
  std::size_t labelled = 0;
  for (const int i : walls) {
    const auto at = static_cast<std::size_t>(i);
    if (labels[at] != 0)
      continue;
    labels[at] = valueOf(StructureLabel::Wall);
    rooms[at] = room;
    ++labelled;
  }
  return labelled;
}

bool
StructureChain::fitPlan(StageReport& report)
{
  floorplan_fitting.setInputCloud(cloud);
  floorplan_fitting.setCeilingIndices(labelled(StructureLabel::Ceiling));
  floorplan_fitting.setFloorIndices(labelled(StructureLabel::Floor));
  floorplan_fitting.setDetailIndices(labelled(StructureLabel::Detail));
  floorplan_fitting.setWallIndices(labelled(StructureLabel::Wall));
  floorplan_fitting.setSheetIndices(sheetPoints());
  floorplan_fitting.setRooms(rooms);
  if (!floorplan_fitting.segment(*plan))
    return fail(floorplan_fitting.getErrorMessage());
  if (sight_) {                        // rays prove openings
    constexpr double tolerance = 0.05; // metres; points within lie on a wall
    measureEvidence(*plan, PointView(*cloud), *allIndices(cloud->size()), tolerance,
                    room_segmentation.getNumberOfThreads(), sight_.get());
  }
  tellResult("FloorplanFitting");
  warnings.insert(warnings.end(), floorplan_fitting.getWarnings().begin(),
                  floorplan_fitting.getWarnings().end());
  giveStoreys(getBuilding(), *plan);
  closeReveals(*plan, priors_);
  warnOfCeilings();
  if (!unit_is_known)
    unit_doubt = footProblem(
        *plan, sight_ ? sight_->places() : std::vector<Eigen::Vector3f>(), priors_);
  if (!unit_doubt.empty())
    warnings.push_back(unit_doubt);
  for (const auto& room : plan->rooms)
    for (const auto& element : room.boundary.elements)
      report.points_out += element.inliers;
  giveUpRoomsWithoutPlan();
  tiltPlan();
  labelNiches();
  return true;
}

void
StructureChain::giveUpRoomsWithoutPlan()
{
  shareOut();
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    const auto id = static_cast<std::uint32_t>(r + 1);
    if (std::none_of(plan->rooms.begin(), plan->rooms.end(),
                     [&](const PlanRoom& room) { return room.id == id; }))
      giveUp(id);
  }
}

void
StructureChain::labelNiches()
{
  const double reach = refinement.getMaximumDistance();
  std::vector<const PlanRoom*> recessed(regions_.size(), nullptr);
  std::vector<std::optional<RoomSurfaces>> surfaces(regions_.size());
  for (const PlanRoom& room : straight_plan_->rooms)
    if (!room.niches.empty()) {
      recessed[room.id - 1] = &room;
      surfaces[room.id - 1].emplace(room, reach);
    }
  if (std::count(recessed.begin(), recessed.end(), nullptr) ==
      static_cast<std::ptrdiff_t>(recessed.size()))
    return;
  const RoomTerritory niches = territory(nicheReach({priors_}));
  for (std::size_t at = 0; at < cloud->size(); ++at) {
    const Eigen::Vector3f place = (*cloud)[at].getVector3fMap();
    const std::int32_t region = niches.roomAt(place);
    if (region < 0 || !recessed[static_cast<std::size_t>(region)])
      continue;
    const PlanRoom& room = *recessed[static_cast<std::size_t>(region)];
    const Eigen::Vector3d p = place.cast<double>();
    SurfacePoint snapped;
    if (room.nicheAt(p.head<2>()) >= 0 && !room.boundary.contains(p.head<2>()) &&
        surfaces[static_cast<std::size_t>(region)]->snap(p, StructureLabel::Detail,
                                                         snapped)) {
      labels[at] = valueOf(StructureLabel::Detail);
      rooms[at] = room.id;
    }
  }
}

} // namespace pcl::sedr
