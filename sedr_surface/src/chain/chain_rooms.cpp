// SPDX-License-Identifier: BSD-3-Clause
#include "chain_rooms.h"

#include "sedr_filters/src/base/labels.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/plane_fit.h"
#include "sedr_segmentation/src/faces/room_cells.h"
#include "sedr_segmentation/src/plan/room_gaps.h"
#include "sedr_segmentation/src/plan/room_shares.h"
#include "sedr_segmentation/src/sheets/floor_pieces.h"

#include <algorithm>
#include <limits>
#include <map>
#include <unordered_map>

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

namespace {

/** @brief Returns the height of the floor of a room by its profiles. Beside a wall
 * there are none: as at that which is nearest. */
float
floorAt(const std::unordered_map<CellKey, float>& floors,
        const CellGrid& grid,
        const Eigen::Vector2d& at,
        double usual)
{
  const Cell middle = grid.at(at.x(), at.y());
  const auto here = floors.find(keyOf(middle));
  if (here != floors.end())
    return here->second;
  auto floor = static_cast<float>(usual);
  double nearest = std::numeric_limits<double>::infinity();
  for (int y = middle.y - 1; y <= middle.y + 1; ++y)
    for (int x = middle.x - 1; x <= middle.x + 1; ++x)
      if (const auto beside = floors.find(keyOf({x, y})); beside != floors.end())
        if (const double off = (grid.centre({x, y}) - at).norm(); off < nearest) {
          nearest = off;
          floor = beside->second;
        }
  return floor;
}

/** @brief Appends the gaps of a room, from its ceiling, seen or hidden, down to its
 * floor. */
void
addGaps(const ScannedBuilding& scan,
        const ChainRoom& room,
        const BuildingRoom& found,
        std::vector<RoomGap>& all)
{
  std::map<CellKey, RoomGap> gaps;
  const auto add = [&](const Eigen::Vector3f& p) {
    const Cell cell = scan.grid.at(p.x(), p.y());
    RoomGap& gap = gaps.try_emplace(keyOf(cell), RoomGap{cell, found.id, 0, p.z(), 0})
                       .first->second;
    gap.high = std::max(gap.high, p.z());
  };
  for (const int i : room.ceiling)
    add(scan.points[static_cast<std::size_t>(i)]);
  for (const Eigen::Vector3f& place : room.hidden.ceiling)
    add(place);
  std::unordered_map<CellKey, float> floors;
  for (const RoomColumn& column : found.columns)
    floors[keyOf(column.cell)] = column.floor;
  for (auto& [key, gap] : gaps) {
    gap.low =
        floorAt(floors, scan.building.grid, scan.grid.centre(gap.cell), found.floor);
    gap.lowest = std::min(gap.low, static_cast<float>(found.floor));
    all.push_back(gap);
  }
}

} // namespace

std::vector<PointOwner>
findOwners(const ScannedBuilding& scan, std::vector<ChainRoom>& rooms)
{
  std::vector<RoomGap> gaps;
  for (std::size_t r = 0; r < rooms.size(); ++r)
    addGaps(scan, rooms[r], scan.building.rooms[r], gaps);
  std::vector<PointOwner> owners =
      RoomGaps(scan.grid, gaps, scan.priors).ownersOf(scan.points, scan.planes.threads);
  for (std::size_t i = 0; i < owners.size(); ++i)
    if (owners[i].room != 0 && !owners[i].beyond)
      rooms[owners[i].room - 1].owned.push_back(static_cast<int>(i));
  return owners;
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

} // namespace pcl::sedr
