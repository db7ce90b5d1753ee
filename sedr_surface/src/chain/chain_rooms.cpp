// SPDX-License-Identifier: BSD-3-Clause
#include "chain_stages.h"
#include "sedr_filters/src/base/labels.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/plane_fit.h"
#include "sedr_filters/src/plan/plan_surfaces.h"
#include "sedr_filters/src/walls/plan_walls.h"
#include "sedr_segmentation/src/faces/room_cells.h"
#include "sedr_segmentation/src/plan/room_shares.h"
#include "sedr_segmentation/src/sheets/floor_pieces.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace pcl::sedr {

std::vector<ChainRoom>
roomsOf(const Building& building)
{
  std::vector<ChainRoom> rooms(building.rooms.size());
  for (std::size_t i = 0; i < building.room_of.size(); ++i)
    if (building.room_of[i] != 0) {
      ChainRoom& room = rooms[building.room_of[i] - 1];
      const bool is_ceiling = building.label_of[i] == valueOf(StructureLabel::Ceiling);
      (is_ceiling ? room.ceiling : room.floor).push_back(static_cast<int>(i));
    }
  for (std::size_t i = 0; i < building.owner_of.size(); ++i)
    if (const PointOwner& owner = building.owner_of[i];
        owner.room != 0 && !owner.beyond)
      rooms[owner.room - 1].owned.push_back(static_cast<int>(i));
  return rooms;
}

void
findCeilings(const ScannedBuilding& scan, std::vector<ChainRoom>& rooms)
{
  parallelBlocks(rooms.size(), 1, scan.planes.threads, [&](std::size_t r, std::size_t) {
    ChainRoom& room = rooms[r];
    const BuildingRoom& found = scan.building.rooms[r];
    room.ceiling_slab =
        mainPlane(scan.points, room.ceiling, found.ceiling, scan.planes);
    room.floor_slab = mainPlane(scan.points, room.floor, found.floor, scan.planes);
    const CellSet seen(scan.grid, scan.points, room.ceiling);
    room.hidden.ceiling = hiddenCeiling(found.columns, scan.building.grid, scan.grid,
                                        seen, room.ceiling_slab);
    room.scope = unite(seen, cellsOf(scan.grid, room.hidden.ceiling));
  });
}

void
findFloors(const ScannedBuilding& scan, std::vector<ChainRoom>& rooms)
{
  parallelBlocks(rooms.size(), 1, scan.planes.threads, [&](std::size_t r, std::size_t) {
    ChainRoom& room = rooms[r];
    room.floor =
        floorPoints(scan.points, seenPoints(scan.points, scan.grid, room.floor, true),
                    room.owned, room.floor_slab, scan.planes.tolerance, scan.priors);
    const CellSet hidden =
        subtract(room.scope, CellSet(scan.grid, scan.points, room.floor));
    for (std::size_t k = 0; k < hidden.size(); ++k) {
      const Eigen::Vector2d at = scan.grid.centre(hidden[k]);
      const double z = room.floor_slab.inliers > 0 ? room.floor_slab.heightAt(at)
                                                   : scan.building.rooms[r].floor;
      room.hidden.floor.push_back(Eigen::Vector3d(at.x(), at.y(), z).cast<float>());
    }
  });
}

pcl::IndicesPtr
labelled(const StructureModel& model, StructureLabel label)
{
  pcl::IndicesPtr indices(new pcl::Indices);
  for (std::size_t i = 0; i < model.labels.size(); ++i)
    if (model.labels[i] == valueOf(label))
      indices->push_back(static_cast<int>(i));
  return indices;
}

std::vector<pcl::Indices>
pointsByRoom(const StructureModel& model, std::size_t rooms)
{
  std::vector<pcl::Indices> points(rooms + 1);
  for (std::size_t i = 0; i < model.rooms.size(); ++i)
    points[model.rooms[i]].push_back(static_cast<int>(i));
  return points;
}

void
labelSlabs(const std::vector<ChainRoom>& rooms,
           const CellGrid& grid,
           StructureModel& model)
{
  for (std::size_t r = 0; r < rooms.size(); ++r)
    for (const int i : rooms[r].ceiling)
      assign(model, i, StructureLabel::Ceiling, r + 1);
  for (std::size_t r = 0; r < rooms.size(); ++r)
    for (const int i : rooms[r].floor)
      if (const auto& p = (*model.cloud)[static_cast<std::size_t>(i)];
          rooms[r].scope.contains(grid.at(p.x, p.y)))
        assign(model, i, StructureLabel::Floor, r + 1);
}

namespace {

/** @brief Returns the points that a room owns but those well below its ceiling, seen or
 * hidden: none of them is of a wall. */
pcl::IndicesPtr
nearRim(const ChainRoom& room,
        const CellGrid& grid,
        double reach,
        const StructureModel& model)
{
  const CellMask inner = eroded(CellMask(room.scope, boxOf(room.scope)), reach);
  pcl::IndicesPtr near(new pcl::Indices);
  for (const int i : room.owned)
    if (const auto& p = (*model.cloud)[static_cast<std::size_t>(i)];
        model.labels[static_cast<std::size_t>(i)] == 0 && !inner.at(grid.at(p.x, p.y)))
      near->push_back(i);
  return near;
}

/** @brief Returns those of the points that are beside hidden cells of a ceiling. */
pcl::Indices
besideHidden(const CellSet& hidden,
             const CellGrid& grid,
             double reach,
             const StructureModel::Cloud& cloud,
             const pcl::Indices& points)
{
  if (hidden.empty())
    return {};
  const CellMask beside = dilated(
      CellMask(hidden, grown(boxOf(hidden), static_cast<int>(std::ceil(reach)))),
      reach);
  pcl::Indices found;
  std::copy_if(points.begin(), points.end(), std::back_inserter(found), [&](int i) {
    const auto& p = cloud[static_cast<std::size_t>(i)];
    return beside.at(grid.at(p.x, p.y));
  });
  return found;
}

} // namespace

std::string
growWalls(const std::vector<ChainRoom>& rooms,
          const CellGrid& grid,
          pcl::CeilingBoundaryWallGrowing<pcl::PointXYZ>& growing,
          StructureModel& model)
{
  const double reach = growing.getDistanceThreshold() / grid.size();
  std::string problem = "no point lies within " +
                        std::to_string(growing.getDistanceThreshold()) +
                        " m in plan of the boundary of the ceilings";
  std::vector<pcl::Indices> ceilings(rooms.size());
  const pcl::IndicesPtr ceiling = labelled(model, StructureLabel::Ceiling);
  for (const int i : *ceiling)
    ceilings[model.rooms[static_cast<std::size_t>(i)] - 1].push_back(i);
  growing.setInputCloud(model.cloud);
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    const pcl::IndicesPtr near = nearRim(rooms[r], grid, reach, model);
    growing.setIndices(near);
    growing.setCeilingIndices(std::move(ceilings[r]));
    pcl::PointIndices unused;
    if (!growing.segment(unused)) {
      problem = growing.getErrorMessage();
      model.warnings.push_back(
          {WarningKind::Stage, {}, static_cast<std::uint32_t>(r + 1), 0, problem});
      continue;
    }
    const pcl::Indices beside = besideHidden(cellsOf(grid, rooms[r].hidden.ceiling),
                                             grid, reach, *model.cloud, *near);
    for (const pcl::Indices* found : {&growing.getWallIndices(), &beside})
      for (const int i : *found)
        assign(model, i, StructureLabel::Wall, r + 1);
  }
  return labelled(model, StructureLabel::Wall)->empty() ? problem : std::string();
}

namespace {

void
giveUpRoomsWithoutPlan(std::size_t rooms, StructureModel& model)
{
  std::vector<bool> has_plan(rooms + 1);
  for (const PlanRoom& room : model.plan->rooms)
    has_plan[room.id] = true;
  for (std::size_t i = 0; i < model.rooms.size(); ++i)
    if (model.rooms[i] != 0 && !has_plan[model.rooms[i]])
      model.labels[i] = model.rooms[i] = 0;
}

void
labelRisers(const PlanRoom& room,
            const pcl::Indices& owned,
            double reach,
            StructureModel& model)
{
  const bool is_tilted = isTilted(room);
  if (room.details.empty() && room.floor_details.empty() && !is_tilted)
    return;
  const RoomSurfaces surfaces(room, reach);
  SurfacePoint snapped;
  for (const int i : owned) {
    const auto at = static_cast<std::size_t>(i);
    const Eigen::Vector3d p = (*model.cloud)[at].getVector3fMap().cast<double>();
    const bool is_ceiling = is_tilted &&
                            model.labels[at] == valueOf(StructureLabel::Ceiling) &&
                            !surfaces.snap(p, StructureLabel::Ceiling, snapped);
    if (model.labels[at] != 0 && !is_ceiling)
      continue;
    if (surfaces.snap(p, StructureLabel::Detail, snapped) && snapped.normal.z() == 0)
      assign(model, i, StructureLabel::Detail, room.id);
    else if (is_tilted && surfaces.snap(p, StructureLabel::Wall, snapped))
      assign(model, i, StructureLabel::Wall, room.id);
  }
}

/** @brief Labels the points in the niches of a room, also those beyond its walls. */
void
labelNichesOf(const PlanRoom& room,
              const std::vector<PointOwner>& owners,
              double reach,
              StructureModel& model)
{
  if (room.niches.empty())
    return;
  const RoomSurfaces surfaces(room, reach);
  SurfacePoint snapped;
  for (std::size_t at = 0; at < owners.size(); ++at) {
    if (owners[at].room != room.id)
      continue;
    const Eigen::Vector3d p = (*model.cloud)[at].getVector3fMap().cast<double>();
    if (room.nicheAt(p.head<2>()) >= 0 && !room.boundary.contains(p.head<2>()) &&
        surfaces.snap(p, StructureLabel::Detail, snapped))
      assign(model, static_cast<int>(at), StructureLabel::Detail, room.id);
  }
}

} // namespace

void
labelByPlan(const std::vector<ChainRoom>& rooms, double reach, StructureModel& model)
{
  giveUpRoomsWithoutPlan(rooms.size(), model);
  for (const PlanRoom& room : model.plan->rooms)
    labelRisers(room, rooms[room.id - 1].owned, reach, model);
}

void
labelNiches(const std::vector<PointOwner>& owners, double reach, StructureModel& model)
{
  for (const PlanRoom& room : model.plan->rooms)
    labelNichesOf(room, owners, reach, model);
}

} // namespace pcl::sedr
