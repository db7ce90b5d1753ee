// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/base/labels.h"
#include "sedr_segmentation/src/plan/room_shares.h"
#include "sedr_segmentation/src/sheets/floor_pieces.h"

#include "chain_run.h"

#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/plane_fit.h"
#include "sedr_segmentation/src/faces/room_cells.h"
#include "sedr_segmentation/src/rooms/room_planes.h"
#include "sedr_segmentation/src/scan/cell_fill.h"
#include "sedr_segmentation/src/scan/unit_check.h"

#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

namespace pcl::sedr {

bool
ChainRun::partRooms(StageReport& report)
{
  chain_.room_segmentation.setInputCloud(chain_.cloud);
  chain_.room_segmentation.setSeenThroughPanes(chain_.mirrored.behind);
  std::vector<pcl::PointIndices> unused;
  if (!chain_.room_segmentation.segment(unused))
    return fail(chain_.room_segmentation.getErrorMessage() +
                (chain_.seems_in_feet_ && !chain_.unit_is_known
                     ? std::string("; ") + if_in_feet
                     : ""));
  if (!inchProblem(PointView(*chain_.cloud), chain_.getBuilding().storeys.size())
           .empty())
    return fail("the storeys that were found are too high for a building");
  const Building& building = chain_.getBuilding();
  for (const LeftOut& thing : building.left_out)
    if (thing.kind == LeftOutKind::Mirror || thing.kind == LeftOutKind::Partial)
      warn({WarningKind::LeftOut, {thing.area}, 0, 0, thing.reason, thing.at});
  for (const BuildingRoom& room : building.rooms)
    if (room.enclosure < chain_.priors_.share_clear)
      warn({WarningKind::Open, {room.unseen_outline}, room.id});
  regions_.assign(building.rooms.size(), {});
  for (std::size_t i = 0; i < building.room_of.size(); ++i)
    if (building.room_of[i] != 0) {
      ChainRoom& room = regions_[building.room_of[i] - 1];
      const bool is_ceiling = building.label_of[i] == valueOf(StructureLabel::Ceiling);
      (is_ceiling ? room.ceiling : room.floor).push_back(static_cast<int>(i));
      ++report.points_out;
    }
  return true;
}

bool
ChainRun::findPlanes(StageReport& report)
{
  const double tolerance = chain_.plane_detection.getDistanceThreshold();
  if (!(tolerance > 0 && 2 * tolerance < chain_.priors_.min_headroom))
    return fail(
        "the distance threshold must be above 0 and below half the headroom, it "
        "is " +
        std::to_string(tolerance) + " m");
  const double tilt = chain_.plane_detection.getMaximumTilt();
  if (!(tilt >= 0 && tilt <= M_PI / 4))
    return fail("the maximum tilt must be within 0 and pi/4 radians, it is " +
                std::to_string(tilt));
  const double size = chain_.plane_detection.getGridSize();
  std::vector<CellSet> ceilings;
  for (const ChainRoom& room : regions_)
    ceilings.emplace_back(CellGrid(size), PointView(*chain_.cloud), room.ceiling);
  const double wanted = cellSizeFor(ceilings, size, chain_.priors_);
  if (wanted > size) {
    chain_.enlargeCells(wanted);
    warn({WarningKind::Sparse, {size, wanted}});
  }
  const PointView points(*chain_.cloud);
  RoomPlaneParameters parameters;
  parameters.tolerance = tolerance;
  parameters.maximum_tilt = tilt;
  parameters.seed = chain_.plane_detection.getSeed();
  parameters.threads = chain_.room_segmentation.getNumberOfThreads();
  parallelBlocks(
      regions_.size(), 1, parameters.threads, [&](std::size_t r, std::size_t) {
        ChainRoom& room = regions_[r];
        const BuildingRoom& found = chain_.getBuilding().rooms[r];
        room.ceiling_slab = mainPlane(points, room.ceiling, found.ceiling, parameters);
        room.floor_slab = mainPlane(points, room.floor, found.floor, parameters);
      });
  const CellGrid grid(chain_.plane_detection.getGridSize());
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    ChainRoom& room = regions_[r];
    for (const int i : room.ceiling)
      give(i, StructureLabel::Ceiling, r + 1);
    report.points_out += room.ceiling.size();
    const CellSet seen(grid, PointView(*chain_.cloud), room.ceiling);
    const Building& building = chain_.getBuilding();
    room.hidden.ceiling = hiddenCeiling(building.rooms[r].columns, building.grid, grid,
                                        seen, room.ceiling_slab);
    room.scope = unite(seen, cellsOf(grid, room.hidden.ceiling));
  }
  findOwners();
  parallelBlocks(
      regions_.size(), 1, parameters.threads, [&](std::size_t r, std::size_t) {
        const PointView all(*chain_.cloud);
        ChainRoom& room = regions_[r]; // restricted to what is no furniture
        room.floor =
            floorPoints(all, seenPoints(all, grid, room.floor, true), *owned_[r],
                        room.floor_slab, tolerance, chain_.priors_);
      });
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    report.points_out += labelFloor(r);
    if (regions_[r].scope.empty())
      warn(static_cast<std::uint32_t>(r + 1),
           "no point of its ceiling was found: it is left out");
  }
  return true;
}

void
ChainRun::findOwners()
{
  std::vector<RoomGap> gaps;
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    const std::vector<RoomGap> own = gapsOf(r);
    gaps.insert(gaps.end(), own.begin(), own.end());
  }
  owners_ =
      RoomGaps(CellGrid(chain_.plane_detection.getGridSize()), gaps, chain_.priors_)
          .ownersOf(PointView(*chain_.cloud),
                    chain_.room_segmentation.getNumberOfThreads());
  owned_.clear();
  for (std::size_t r = 0; r < regions_.size(); ++r)
    owned_.emplace_back(new pcl::Indices);
  for (std::size_t i = 0; i < owners_.size(); ++i)
    if (owners_[i].room != 0 && !owners_[i].beyond)
      owned_[owners_[i].room - 1]->push_back(static_cast<int>(i));
}

std::size_t
ChainRun::labelFloor(std::size_t r)
{
  ChainRoom& room = regions_[r];
  const CellGrid grid(chain_.plane_detection.getGridSize());
  const PointView points(*chain_.cloud);
  const CellSet floor(grid, points, room.floor);
  for (const int i : room.floor)
    if (const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
        room.scope.contains(grid.at(p.x(), p.y())))
      give(i, StructureLabel::Floor, r + 1);
  const CellSet hidden = subtract(room.scope, floor);
  for (std::size_t k = 0; k < hidden.size(); ++k) {
    const Eigen::Vector2d at = grid.centre(hidden[k]);
    const double z = room.floor_slab.inliers > 0 ? room.floor_slab.heightAt(at)
                                                 : chain_.getBuilding().rooms[r].floor;
    room.hidden.floor.push_back(Eigen::Vector3d(at.x(), at.y(), z).cast<float>());
  }
  return room.floor.size();
}

std::vector<RoomGap>
ChainRun::gapsOf(std::size_t r) const
{
  const CellGrid grid(chain_.plane_detection.getGridSize());
  const Building& building = chain_.getBuilding();
  const BuildingRoom& room = building.rooms[r];
  std::unordered_map<CellKey, float> floors; // by the profiles of the room
  for (const RoomColumn& column : room.columns)
    floors[keyOf(column.cell)] = column.floor;
  const auto id = static_cast<std::uint32_t>(r + 1);
  std::map<CellKey, RoomGap> gaps;
  const auto add = [&](const Eigen::Vector3f& p) {
    const Cell cell = grid.at(p.x(), p.y());
    RoomGap& gap =
        gaps.try_emplace(keyOf(cell), RoomGap{cell, id, 0, p.z(), 0}).first->second;
    gap.high = std::max(gap.high, p.z());
  };
  for (const int i : regions_[r].ceiling)
    add((*chain_.cloud)[static_cast<std::size_t>(i)].getVector3fMap());
  for (const Eigen::Vector3f& place : regions_[r].hidden.ceiling)
    add(place);
  const auto floorAt = [&](const Eigen::Vector2d& at) {
    const Cell middle = building.grid.at(at.x(), at.y());
    const auto here = floors.find(keyOf(middle));
    if (here != floors.end())
      return here->second;
    // Beside a wall there are no profiles: as that which is nearest.
    auto floor = static_cast<float>(room.floor);
    double nearest = std::numeric_limits<double>::infinity();
    for (int y = middle.y - 1; y <= middle.y + 1; ++y)
      for (int x = middle.x - 1; x <= middle.x + 1; ++x)
        if (const auto beside = floors.find(keyOf({x, y})); beside != floors.end())
          if (const double off = (building.grid.centre({x, y}) - at).norm();
              off < nearest) {
            nearest = off;
            floor = beside->second;
          }
    return floor;
  };
  std::vector<RoomGap> all;
  for (auto& [key, gap] : gaps) {
    gap.low = floorAt(grid.centre(gap.cell));
    gap.lowest = std::min(gap.low, static_cast<float>(room.floor));
    all.push_back(gap);
  }
  return all;
}

} // namespace pcl::sedr
