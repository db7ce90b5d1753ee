// SPDX-License-Identifier: BSD-3-Clause
#include "../formats/labels.h"
#include "all_indices.h"
#include "sedr_segmentation/src/plan/room_territory.h"
#include "sedr_segmentation/src/walls/wall_growing.h"

#include <pcl/sedr_surface/structure_chain.h>

#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/plane_fit.h"
#include "sedr_segmentation/src/rooms/room_planes.h"
#include "sedr_segmentation/src/scan/cell_fill.h"
#include "sedr_segmentation/src/scan/scan_check.h"
#include "sedr_segmentation/src/scan/scan_inclination.h"
#include "sedr_segmentation/src/scan/unit_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace pcl::sedr {

bool
StructureChain::checkScan()
{
  failed_stage = "input";
  if (const std::string wrong = problemOf(priors_); !wrong.empty())
    return fail(wrong);
  if (trust_up)
    return true;
  const PointView points(*cloud);
  const pcl::IndicesPtr all = allIndices(cloud->size());
  const unsigned threads = room_segmentation.getNumberOfThreads();
  std::string reason =
      upProblem(points, *all, RoomsAlongZ::NotLookedFor, 0, threads, priors_);
  if (reason.empty())
    reason = inclinationProblem(points, *all, threads, priors_);
  return reason.empty() || fail(reason);
}

namespace {

/** @brief Returns the largest area of a storey, square metres. Rooms above each other
 * count once as evidence for the up direction. */
double
areaOfLargestStorey(const Building& building)
{
  std::map<std::uint32_t, double> areas;
  double largest = 0;
  for (const BuildingRoom& room : building.rooms)
    largest = std::max(largest, areas[room.storey] += room.area);
  return largest;
}

/** @brief Returns what a warning tells of the parts of a room that nobody saw; empty if
 * there are few. */
std::string
unseenWarning(const BuildingRoom& room, const Priors& priors)
{
  char text[160] = "";
  if (room.inferred >= priors.min_slab_area)
    std::snprintf(text, sizeof text,
                  "%.1f of its %.1f m2 were not seen, behind what stands before them: "
                  "its walls go on until they meet, %.1f m of them unseen",
                  room.inferred, room.area, room.unseen_outline);
  else if (room.enclosure < priors.share_clear)
    std::snprintf(text, sizeof text,
                  "along %.1f m of its outline neither a wall nor an opening was seen: "
                  "it may go on there",
                  room.unseen_outline);
  return text;
}

} // namespace

bool
StructureChain::partRooms(StageReport& report)
{
  room_segmentation.setInputCloud(cloud);
  room_segmentation.setSeenThroughPanes(mirrored.behind);
  std::vector<pcl::PointIndices> unused;
  const auto turned = [&](RoomsAlongZ known, double area) {
    return trust_up ? std::string()
                    : upProblem(PointView(*cloud), *allIndices(cloud->size()), known,
                                area, room_segmentation.getNumberOfThreads(), priors_);
  };
  if (!room_segmentation.segment(unused)) {
    const std::string hint = turned(RoomsAlongZ::None, 0);
    return fail(room_segmentation.getErrorMessage() +
                (hint.empty() ? "" : "; " + hint));
  }
  const std::string doubt =
      turned(RoomsAlongZ::Found, areaOfLargestStorey(getBuilding()));
  if (!doubt.empty())
    return fail(doubt);
  if (!inchProblem(PointView(*cloud), getBuilding().storeys.size()).empty())
    return fail("the storeys that were found are too high for a building");
  const Building& building = getBuilding();
  for (const LeftOut& thing : building.left_out)
    if (thing.kind == LeftOutKind::Mirror || thing.kind == LeftOutKind::Partial) {
      char text[160];
      std::snprintf(text, sizeof text, "%.1f m2 at (%.1f, %.1f) are left out: %s",
                    thing.area, thing.at.x(), thing.at.y(), thing.reason.c_str());
      warnings.push_back(text);
    }
  for (const BuildingRoom& room : building.rooms)
    if (const std::string warning = unseenWarning(room, priors_); !warning.empty())
      warn(room.id, warning);
  regions_.assign(building.rooms.size(), {});
  for (std::size_t i = 0; i < building.room_of.size(); ++i)
    if (building.room_of[i] != 0) {
      ChainRoom& room = regions_[building.room_of[i] - 1];
      const bool is_ceiling = building.label_of[i] == valueOf(StructureLabel::Ceiling);
      (is_ceiling ? room.ceiling : room.floor).push_back(static_cast<int>(i));
      ++report.points_out;
    }
  tellResult("RoomSegmentation");
  return true;
}

double
StructureChain::cellSizeThatFills() const
{
  const double size = plane_detection.getGridSize();
  const CellGrid grid(size);
  std::vector<CellSet> ceilings;
  for (const ChainRoom& room : regions_)
    ceilings.emplace_back(grid, PointView(*cloud), room.ceiling);
  return cellSizeFor(ceilings, size, priors_);
}

bool
StructureChain::findPlanes(StageReport& report)
{
  const double tolerance = plane_detection.getDistanceThreshold();
  if (!(tolerance > 0) || !std::isfinite(tolerance))
    return fail("the distance threshold must be above 0 m, it is " +
                std::to_string(tolerance));
  const double tilt = plane_detection.getMaximumTilt();
  if (!(tilt >= 0 && tilt <= M_PI / 4))
    return fail("the maximum tilt must be within 0 and pi/4 radians, it is " +
                std::to_string(tilt));
  const double size = plane_detection.getGridSize();
  const double wanted = adapts_grid ? cellSizeThatFills() : size;
  if (wanted > size) {
    enlargeCells(wanted);
    char text[200];
    std::snprintf(text, sizeof text,
                  "the scan is too sparse for cells of %.2f m, its ceilings leave some "
                  "empty: cells of %.2f m are used",
                  size, wanted);
    warnings.push_back(text);
  }
  const PointView points(*cloud);
  RoomPlaneParameters parameters;
  parameters.tolerance = tolerance;
  parameters.maximum_tilt = tilt;
  parameters.seed = plane_detection.getSeed();
  parameters.threads = room_segmentation.getNumberOfThreads();
  parallelBlocks(
      regions_.size(), 1, parameters.threads, [&](std::size_t r, std::size_t) {
        ChainRoom& room = regions_[r];
        const BuildingRoom& found = getBuilding().rooms[r];
        room.ceiling_slab = mainPlane(points, room.ceiling, found.ceiling, parameters);
        room.floor_slab = mainPlane(points, room.floor, found.floor, parameters);
      });
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    ChainRoom& room = regions_[r];
    for (const int i :
         pointsOn(points, room.ceiling, room.ceiling_slab, parameters.tolerance)) {
      const auto at = static_cast<std::size_t>(i);
      labels[at] = valueOf(StructureLabel::Ceiling);
      rooms[at] = static_cast<std::uint32_t>(r + 1);
      ++report.points_out;
    }
    room.floor = pointsOn(points, room.floor, room.floor_slab, parameters.tolerance);
    report.points_out += room.floor.size();
  }
  const CellGrid grid(plane_detection.getGridSize());
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    ChainRoom& room = regions_[r];
    report.points_out += addHiddenCeiling(r);
    room.scope = CellSet(grid, PointView(*cloud), room.ceiling);
  }
  const RoomTerritory of_rooms = territory();
  if (!of_rooms.problem().empty())
    return fail(of_rooms.problem());
  territory_ = territories(of_rooms);
  findPlatforms();
  listPlanes();
  tellResult("HorizontalPlaneDetection");
  return true;
}

void
StructureChain::findPlatforms()
{
  constexpr double highest = 1;   // metres above the floor
  constexpr double largest = 200; // square metres; halls would take too long
  const PointView points(*cloud);
  parallelBlocks(
      regions_.size(), 1, room_segmentation.getNumberOfThreads(),
      [&](std::size_t r, std::size_t) {
        ChainRoom& room = regions_[r];
        if (getBuilding().rooms[r].area > largest || room.floor.empty())
          return;
        pcl::IndicesPtr near(new pcl::Indices);
        for (const int i : *territory_[r]) {
          const auto at = static_cast<std::size_t>(i);
          const bool is_ceiling =
              labels[at] == valueOf(StructureLabel::Ceiling) && rooms[at] == r + 1;
          if (is_ceiling || distanceAbove(room.floor_slab, points[at]) < highest)
            near->push_back(i);
        }
        pcl::HorizontalPlaneDetection<pcl::PointXYZ> detection = plane_detection;
        detection.setInputCloud(cloud);
        detection.setIndices(near);
        std::vector<pcl::HorizontalPlane> found;
        if (!detection.segment(found))
          return;
        for (const pcl::HorizontalPlane& plane : found)
          if (plane.kind == LevelKind::Floor)
            room.floor = unite(room.floor, plane.inliers.indices);
      });
}

void
StructureChain::listPlanes()
{
  const CellGrid grid(plane_detection.getGridSize());
  const PointView points(*cloud);
  const auto add = [&](const PlanSlab& slab, LevelKind kind, pcl::Indices inliers) {
    pcl::HorizontalPlane plane =
        listedPlane(kind, slab, std::move(inliers), points, grid);
    if (plane.cells > 0)
      planes.push_back(std::move(plane));
  };
  for (std::size_t r = 0; r < regions_.size(); ++r) {
    pcl::Indices of_slab;
    for (const int i : regions_[r].ceiling)
      if (labels[static_cast<std::size_t>(i)] == valueOf(StructureLabel::Ceiling))
        of_slab.push_back(i);
    add(regions_[r].ceiling_slab, LevelKind::Ceiling, std::move(of_slab));
    add(regions_[r].floor_slab, LevelKind::Floor, regions_[r].floor);
  }
}

std::size_t
StructureChain::addHiddenCeiling(std::size_t r)
{
  const Building& building = getBuilding();
  const CellGrid grid(plane_detection.getGridSize());
  ChainRoom& room = regions_[r];
  const CellSet seen(grid, PointView(*cloud), room.ceiling);
  const std::vector<HiddenCeiling> hidden = hiddenCeiling(
      building.rooms[r].columns, building.grid, grid, seen, room.ceiling_slab);
  for (const HiddenCeiling& place : hidden) {
    room.ceiling.push_back(static_cast<int>(cloud->size()));
    cloud->push_back({place.at.x(), place.at.y(), place.at.z()});
    labels.push_back(place.is_main ? valueOf(StructureLabel::Ceiling) : 0);
    rooms.push_back(place.is_main ? static_cast<std::uint32_t>(r + 1) : 0);
  }
  return hidden.size();
}

std::vector<CellSet>
StructureChain::scopes() const
{
  std::vector<CellSet> scopes;
  for (const ChainRoom& room : regions_)
    scopes.push_back(room.scope);
  return scopes;
}

RoomTerritory
StructureChain::territory() const
{
  return territory(wallReach(priors_));
}

RoomTerritory
StructureChain::territory(double reach) const
{
  std::vector<RoomHeights> heights;
  for (const BuildingRoom& room : getBuilding().rooms) {
    std::vector<float> ceilings;
    for (const RoomColumn& column : room.columns)
      ceilings.push_back(column.ceiling);
    heights.push_back(heightsFrom(room.floor, std::move(ceilings), priors_));
  }
  return RoomTerritory(CellGrid(plane_detection.getGridSize()), scopes(), heights,
                       reach, priors_);
}

std::vector<pcl::IndicesPtr>
StructureChain::territories(const RoomTerritory& of_rooms) const
{
  std::vector<pcl::IndicesPtr> result;
  for (std::size_t r = 0; r < regions_.size(); ++r)
    result.emplace_back(new pcl::Indices);
  const PointView points(*cloud);
  const std::vector<std::int32_t> room =
      of_rooms.roomsAt(points, room_segmentation.getNumberOfThreads());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (room[i] >= 0)
      result[static_cast<std::size_t>(room[i])]->push_back(static_cast<int>(i));
  return result;
}

} // namespace pcl::sedr
