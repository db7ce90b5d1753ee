// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/base/labels.h"
#include "sedr_segmentation/src/plan/room_shares.h"
#include "sedr_segmentation/src/plan/room_territory.h"
#include "sedr_segmentation/src/planes/floor_parts.h"

#include "chain_run.h"

#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/plane_fit.h"
#include "sedr_segmentation/src/rooms/room_planes.h"
#include "sedr_segmentation/src/scan/cell_fill.h"
#include "sedr_segmentation/src/scan/unit_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace pcl::sedr {

bool
ChainRun::partRooms(StageReport& report)
{
  chain_.room_segmentation.setInputCloud(chain_.cloud);
  chain_.room_segmentation.setSeenThroughPanes(chain_.mirrored.behind);
  std::vector<pcl::PointIndices> unused;
  if (!chain_.room_segmentation.segment(unused))
    return fail(chain_.room_segmentation.getErrorMessage() +
                (up_doubt_.reason.empty() ? "" : "; " + up_doubt_.reason) +
                (up_doubt_.is_in_feet && !chain_.unit_is_known
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
    const pcl::Indices on_slab =
        pointsOn(PointView(*chain_.cloud), room.ceiling, room.ceiling_slab, tolerance);
    for (const int i : on_slab)
      give(i, StructureLabel::Ceiling, r + 1);
    report.points_out += on_slab.size() + addHiddenCeiling(r);
    room.scope = CellSet(grid, PointView(*chain_.cloud), room.ceiling);
  }
  const RoomTerritory of_rooms = territory(wallReach(chain_.priors_));
  if (!of_rooms.problem().empty())
    return fail(of_rooms.problem());
  territory_ = territories(of_rooms);
  parallelBlocks(
      regions_.size(), 1, parameters.threads, [&](std::size_t r, std::size_t) {
        const PointView all(*chain_.cloud);
        ChainRoom& room = regions_[r]; // restricted to what is no furniture
        room.floor =
            floorPoints(all, seenPoints(all, grid, room.floor, true), *territory_[r],
                        room.floor_slab, tolerance, chain_.priors_);
      });
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    report.points_out += regions_[r].floor.size();
    slice_height_.push_back(std::numeric_limits<double>::quiet_NaN());
    if (regions_[r].scope.empty())
      warn(static_cast<std::uint32_t>(r + 1),
           "no point of its ceiling was found: it is left out");
    report.points_out += labelLowerCeilings(r);
  }
  return true;
}

std::size_t
ChainRun::addHiddenCeiling(std::size_t r)
{
  const Building& building = chain_.getBuilding();
  const CellGrid grid(chain_.plane_detection.getGridSize());
  ChainRoom& room = regions_[r];
  const CellSet seen(grid, PointView(*chain_.cloud), room.ceiling);
  const std::vector<HiddenCeiling> hidden = hiddenCeiling(
      building.rooms[r].columns, building.grid, grid, seen, room.ceiling_slab);
  for (const HiddenCeiling& place : hidden) {
    room.ceiling.push_back(static_cast<int>(chain_.cloud->size()));
    chain_.cloud->push_back({place.at.x(), place.at.y(), place.at.z()});
    chain_.labels.push_back(place.is_main ? valueOf(StructureLabel::Ceiling) : 0);
    chain_.rooms.push_back(place.is_main ? static_cast<std::uint32_t>(r + 1) : 0);
  }
  return hidden.size();
}

RoomTerritory
ChainRun::territory(double reach) const
{
  std::vector<RoomHeights> heights;
  std::vector<CellSet> scopes;
  for (const ChainRoom& room : regions_)
    scopes.push_back(room.scope);
  for (const BuildingRoom& room : chain_.getBuilding().rooms) {
    std::vector<float> ceilings;
    for (const RoomColumn& column : room.columns)
      ceilings.push_back(column.ceiling);
    heights.push_back(heightsFrom(room.floor, std::move(ceilings), chain_.priors_));
  }
  return RoomTerritory(CellGrid(chain_.plane_detection.getGridSize()), scopes, heights,
                       reach, chain_.priors_);
}

std::vector<pcl::IndicesPtr>
ChainRun::territories(const RoomTerritory& of_rooms) const
{
  std::vector<pcl::IndicesPtr> result;
  for (std::size_t r = 0; r < regions_.size(); ++r)
    result.emplace_back(new pcl::Indices);
  const PointView points(*chain_.cloud);
  const std::vector<std::int32_t> room =
      of_rooms.roomsAt(points, chain_.room_segmentation.getNumberOfThreads());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (room[i] >= 0)
      result[static_cast<std::size_t>(room[i])]->push_back(static_cast<int>(i));
  return result;
}

std::size_t
ChainRun::labelLowerCeilings(std::size_t region)
{
  const PointView points(*chain_.cloud);
  const CellGrid& columns = chain_.getBuilding().grid;
  std::vector<CellKey> level_keys;
  for (const RoomColumn& column : chain_.getBuilding().rooms[region].columns)
    if (column.is_level)
      level_keys.push_back(keyOf(column.cell));
  const CellSet level(std::move(level_keys));
  std::size_t found = 0;
  double lowest = std::numeric_limits<double>::infinity();
  for (const int i : regions_[region].ceiling) {
    const auto at = static_cast<std::size_t>(i);
    if (chain_.labels[at] != 0)
      continue;
    if (!level.contains(columns.at(points[at].x(), points[at].y()))) {
      give(i, StructureLabel::Ceiling, region + 1); // vault or roof
      continue;
    }
    give(i, StructureLabel::Detail, region + 1);
    ++found;
    lowest = std::min<double>(lowest, points[at].z());
  }
  labelRisers(region);
  // Below a soffit, walls grow from the floor's boundary, as below any detail.
  double& slice = slice_height_[region];
  if (found > 0 && !(slice < lowest))
    slice = lowest - chain_.plane_detection.getGridSize();
  return found;
}

void
ChainRun::labelRisers(std::size_t region)
{
  constexpr double below = 0.4; // metres: what goes on so far down is a wall
  constexpr double rim = 0.1;   // metres, of noise
  const PointView points(*chain_.cloud);
  const CellGrid& grid = chain_.getBuilding().grid;
  std::map<CellKey, float> lowest; // of the parts of the ceiling, near each cell
  for (const int i : regions_[region].ceiling) {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    if (chain_.labels[static_cast<std::size_t>(i)] != valueOf(StructureLabel::Detail))
      continue;
    const Cell cell = grid.at(p.x(), p.y());
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const auto known =
            lowest.emplace(keyOf({cell.x + dx, cell.y + dy}), p.z()).first;
        known->second = std::min(known->second, p.z());
      }
  }
  if (lowest.empty())
    return;
  std::map<CellKey, pcl::Indices> risers;
  std::set<CellKey> walls;
  for (const int i : *territory_[region]) {
    const auto at = static_cast<std::size_t>(i);
    const Eigen::Vector3f p = points[at];
    if (chain_.labels[at] != 0)
      continue;
    const auto low = lowest.find(keyOf(grid.at(p.x(), p.y())));
    if (low == lowest.end())
      continue;
    if (p.z() > low->second - rim &&
        distanceAbove(regions_[region].ceiling_slab, p) < 0)
      risers[low->first].push_back(i);
    else if (p.z() < low->second - rim && p.z() > low->second - below)
      walls.insert(low->first);
  }
  for (const auto& [cell, own] : risers)
    if (walls.count(cell) == 0)
      for (const int i : own)
        give(i, StructureLabel::Detail, region + 1);
}

pcl::IndicesPtr
ChainRun::sheetPoints() const
{
  pcl::IndicesPtr sheets(new pcl::Indices);
  for (std::size_t r = 0; r < regions_.size(); ++r)
    for (const int i : regions_[r].ceiling)
      if (const auto at = static_cast<std::size_t>(i);
          at < chain_.scanned_points_ && // others fill hidden ceilings
          chain_.rooms[at] == r + 1)     // else floor of the one above
        sheets->push_back(i);
  std::sort(sheets->begin(), sheets->end());
  return sheets;
}

} // namespace pcl::sedr
