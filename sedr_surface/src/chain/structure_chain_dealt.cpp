// SPDX-License-Identifier: BSD-3-Clause
#include "../formats/labels.h"
#include <pcl/sedr_surface/room_jobs.h>

#include <pcl/sedr_surface/structure_chain.h>

#include "sedr_segmentation/src/walls/wall_growing.h"
#include <pcl/sedr_filters/impl/refinement.h>

#include <algorithm>

namespace pcl::sedr {

namespace {

/** @brief Returns the places of `part` within `all`, a superset; both increasing. */
pcl::Indices
placesOf(const pcl::Indices& part, const pcl::Indices& all)
{
  pcl::Indices places;
  places.reserve(part.size());
  auto at = all.begin();
  for (const int i : part) {
    at = std::lower_bound(at, all.end(), i);
    places.push_back(static_cast<int>(at - all.begin()));
  }
  return places;
}

} // namespace

pcl::Indices
StructureChain::wallPoints(std::size_t region) const
{
  const auto room = static_cast<std::uint32_t>(region + 1);
  pcl::Indices points = *territory_[region];
  for (const StructureLabel label :
       {StructureLabel::Ceiling, StructureLabel::Floor, StructureLabel::Detail})
    points = unite(points, *labelled(label, room));
  return points;
}

WallJob
StructureChain::wallJob(std::size_t region) const
{
  const auto room = static_cast<std::uint32_t>(region + 1);
  const pcl::Indices points = wallPoints(region);
  WallJob job;
  job.room = room;
  job.points.reserve(points.size());
  for (const int i : points)
    job.points.emplace_back((*cloud)[static_cast<std::size_t>(i)].getVector3fMap());
  job.candidates = placesOf(*territory_[region], points);
  job.ceiling = placesOf(*labelled(StructureLabel::Ceiling, room), points);
  job.floor = placesOf(*labelled(StructureLabel::Floor, room), points);
  job.details = placesOf(*labelled(StructureLabel::Detail, room), points);
  job.boundary.neighbours = wall_growing.getNumberOfNeighbors();
  job.boundary.angle = wall_growing.getAngleThreshold();
  job.growing.distance = wall_growing.getDistanceThreshold();
  job.growing.slice_height = slice_height_[region];
  job.growing.floor_height = wall_growing.getFloorHeight();
  job.growing.minimum_support = wall_growing.getMinimumSupport();
  return job;
}

void
StructureChain::growWallsElsewhere(StageReport& report)
{
  std::vector<std::size_t> sizes;
  for (const auto& territory : territory_)
    sizes.push_back(territory->size());
  std::vector<RoomResult> results(regions_.size());
  room_workers->work(
      sizes, [this](std::size_t r) { return RoomJob(wallJob(r)); },
      [&](std::size_t r, RoomResult result) { results[r] = std::move(result); });
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    const auto room = static_cast<std::uint32_t>(r + 1);
    if (const auto* lost = std::get_if<LostRoom>(&results[r])) {
      giveUp(room);
      warn(room, "it is left out: " + lost->reason);
      continue;
    }
    const auto& found = std::get<FoundWalls>(results[r]);
    if (!found.problem.empty()) {
      warn(room, found.problem);
      continue;
    }
    const pcl::Indices points = wallPoints(r);
    pcl::Indices walls;
    for (const int i : found.walls)
      walls.push_back(points[static_cast<std::size_t>(i)]);
    report.points_out += labelWalls(room, walls);
  }
}

void
StructureChain::giveUp(std::uint32_t room)
{
  for (const int i : shares_[room]) {
    const auto at = static_cast<std::size_t>(i);
    if (rooms[at] == room)
      labels[at] = rooms[at] = 0;
  }
}

RepairJob
StructureChain::repairJob(const PlanRoom& room) const
{
  RepairJob job;
  job.plan = room;
  const StructureCloud::Ptr points = labelledCloud(room.id);
  for (const auto& p : *points) {
    job.points.emplace_back(p.getVector3fMap());
    job.labels.push_back(p.label);
  }
  job.maximum_distance = refinement.getMaximumDistance();
  job.grid_size = hole_repair.getGridSize();
  return job;
}

bool
StructureChain::refineElsewhere(StageReport& report)
{
  const std::string excess =
      surfaceCellsProblem(*straight_plan_, hole_repair.getGridSize());
  if (!excess.empty())
    return fail(excess);
  shareOut();
  std::vector<std::size_t> sizes;
  for (const PlanRoom& room : straight_plan_->rooms)
    sizes.push_back(shares_[room.id].size());
  std::vector<RoomResult> results(straight_plan_->rooms.size());
  room_workers->work(
      sizes,
      [this](std::size_t r) { return RoomJob(repairJob(straight_plan_->rooms[r])); },
      [&](std::size_t r, RoomResult result) { results[r] = std::move(result); });
  for (std::size_t r = 0; r < results.size(); ++r) {
    const std::uint32_t room = straight_plan_->rooms[r].id;
    if (const auto* lost = std::get_if<LostRoom>(&results[r])) {
      warn(room, "it has no points and no mesh: " + lost->reason);
      continue;
    }
    const auto& repaired = std::get<RepairedRoom>(results[r]);
    if (!repaired.problem.empty())
      return fail(repaired.problem);
    report.points_out += repaired.refined;
    addStructure(room, repaired);
    results[r] = LostRoom(); // points kept twice would be most of the memory
  }
  return report.points_out > 0 || fail("no labelled point lies on the floor plan");
}

void
StructureChain::addStructure(std::uint32_t room, const RepairedRoom& repaired)
{
  *structure += cloudOf(room, repaired);
  unseen_[room] = repaired.unseen;
  if (!repaired.points.empty())
    repaired_shares_[room] = static_cast<double>(repaired.filled) /
                             static_cast<double>(repaired.points.size());
}

} // namespace pcl::sedr
