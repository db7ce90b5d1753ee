// SPDX-License-Identifier: BSD-3-Clause
#include "label_values.h"

#include <pcl/sedr_surface/structure_chain.h>

#include <pcl/sedr_segmentation/cell_fill.h>
#include <pcl/sedr_segmentation/hanging_furniture.h>
#include <pcl/sedr_segmentation/plane_list.h>
#include <pcl/sedr_segmentation/room_territory.h>
#include <pcl/sedr_segmentation/scan_check.h>
#include <pcl/sedr_segmentation/scan_lean.h>

#include <algorithm>
#include <cstdio>
#include <numeric>

namespace pcl {
namespace sedr {

namespace {

pcl::IndicesPtr
allIndices(std::size_t n)
{
  pcl::IndicesPtr indices(new pcl::Indices(n));
  std::iota(indices->begin(), indices->end(), 0);
  return indices;
}

/** @brief A plane as a level without cells. */
Level
levelOf(const pcl::HorizontalPlane& plane)
{
  Level level;
  level.slab = plane.slab;
  level.height = plane.height;
  level.kind = plane.kind;
  level.inliers = plane.inliers.indices;
  return level;
}

} // namespace

bool
StructureChain::checkScan()
{
  failed_stage = "input";
  if (trust_up)
    return true;
  const PointView points(*cloud);
  const pcl::IndicesPtr all = allIndices(cloud->size());
  std::string reason = upProblem(points, *all);
  if (reason.empty())
    reason = leanProblem(points, *all);
  return reason.empty() || fail(reason);
}

bool
StructureChain::detectPlanes()
{
  plane_detection.setInputCloud(cloud);
  if (!plane_detection.segment(planes))
    return fail(plane_detection.getErrorMessage());
  const pcl::Indices reflections = plane_detection.getReflections();
  if (reflections.empty())
    return true;
  removePoints(reflections);
  char text[160];
  std::snprintf(
      text, sizeof text,
      "%zu of %zu thinned points are below a floor what the room is above it: "
      "reflections, which were left out",
      reflections.size(), reflections.size() + cloud->size());
  warnings.push_back(text);
  return detectPlanes();
}

void
StructureChain::removePoints(const pcl::Indices& indices)
{
  Cloud::Ptr rest(new Cloud);
  rest->header = cloud->header;
  std::size_t next = 0;
  for (std::size_t i = 0; i < cloud->size(); ++i)
    if (next < indices.size() && static_cast<std::size_t>(indices[next]) == i)
      ++next;
    else
      rest->push_back((*cloud)[i]);
  cloud = rest;
  scanned_points_ -= static_cast<std::size_t>(
      std::count_if(indices.begin(), indices.end(), [&](int i) {
        return static_cast<std::size_t>(i) < scanned_points_;
      }));
  labels.assign(cloud->size(), 0);
  rooms.assign(cloud->size(), 0);
}

std::vector<Level>
StructureChain::levelsOfPlanes(double cell_size) const
{
  const CellGrid grid(cell_size);
  const PointView points(*cloud);
  std::vector<Level> levels;
  for (const auto& plane : planes) {
    Level level = levelOf(plane);
    if (level.kind != LevelKind::Other)
      level.cells = CellSet(grid, points, level.inliers);
    levels.push_back(std::move(level));
  }
  return levels;
}

bool
StructureChain::leaveOutHangingFurniture()
{
  const double size = plane_detection.getGridSize();
  const HangingFurniture hanging = hangingFurnitureBelow(
      levelsOfPlanes(size), PointView(*cloud), size, room_segmentation.minimum_height);
  if (hanging.points.empty())
    return false;
  removePoints(hanging.points);
  for (const Eigen::Vector3f& p : hanging.behind)
    cloud->push_back({p.x(), p.y(), p.z()});
  labels.assign(cloud->size(), 0);
  rooms.assign(cloud->size(), 0);
  char text[200];
  std::snprintf(text, sizeof text,
                "%zu thinned points of what hangs before walls up to the ceiling, as "
                "cupboards do, were left out, and the walls behind continued by %zu",
                hanging.points.size(), hanging.behind.size());
  warnings.push_back(text);
  return true;
}

double
StructureChain::cellSizeThatFills() const
{
  const double size = plane_detection.getGridSize();
  std::vector<CellSet> ceilings;
  for (const auto& plane : planes)
    if (plane.kind == LevelKind::Ceiling)
      ceilings.emplace_back(CellGrid(size), PointView(*cloud), plane.inliers.indices);
  return cellSizeFor(ceilings, size);
}

bool
StructureChain::findPlanes(StageReport& report)
{
  if (!detectPlanes())
    return false;
  const double size = plane_detection.getGridSize();
  const double wanted = adapts_grid ? cellSizeThatFills() : size;
  if (wanted > size) {
    enlargeCells(wanted);
    if (!detectPlanes())
      return false;
    constexpr double uneven = 1.2; // what fills at random fills no square quite alike
    const bool is_filled = cellSizeThatFills() < uneven * wanted;
    char text[200];
    std::snprintf(text, sizeof text,
                  "the scan is too sparse for cells of %.2f m, its ceilings leave some "
                  "empty: cells of %.2f m are used%s",
                  size, wanted,
                  is_filled ? ""
                            : ", of which some are still empty: walls may be guesses");
    warnings.push_back(text);
  }
  if (leaveOutHangingFurniture() && !detectPlanes())
    return false;
  tellResult("HorizontalPlaneDetection");
  for (const auto& plane : planes)
    if (plane.kind != LevelKind::Other)
      report.points_out += plane.inliers.indices.size();
  const std::string missing =
      missingKind(planes, plane_detection.getMinimumRoomHeight());
  if (missing.empty()) {
    const std::string doubt =
        trust_up ? std::string()
                 : upProblem(PointView(*cloud), *allIndices(cloud->size()),
                             RoomsAlongZ::Found, areaOfRooms(planes));
    return doubt.empty() || fail(doubt);
  }
  const std::string turned =
      upProblem(PointView(*cloud), *allIndices(cloud->size()), RoomsAlongZ::None);
  return fail(missing + (turned.empty() ? "" : "; " + turned));
}

bool
StructureChain::removeOutliers(StageReport& report)
{
  pcl::IndicesPtr floors(new pcl::Indices);
  for (const auto& plane : planes)
    if (plane.kind == LevelKind::Floor)
      floors->insert(floors->end(), plane.inliers.indices.begin(),
                     plane.inliers.indices.end());
  outlier_removal.setInputCloud(cloud);
  outlier_removal.setSupportIndices(floors);
  const CellGrid grid(outlier_removal.getGridSize());
  const PointView points(*cloud);
  for (const auto& plane : planes) {
    Level level = levelOf(plane);
    if (level.kind == LevelKind::Ceiling) {
      outlier_removal.setIndices(pcl::IndicesConstPtr(new pcl::Indices(level.inliers)));
      outlier_removal.filter(level.inliers);
      if (!outlier_removal.getErrorMessage().empty())
        return fail(outlier_removal.getErrorMessage());
      tellResult("GridRegionOutlierRemoval");
    }
    if (level.kind != LevelKind::Other) {
      level.cells = CellSet(grid, points, level.inliers);
      report.points_out += level.inliers.size();
    }
    levels_.push_back(std::move(level));
  }
  return true;
}

bool
StructureChain::partRooms(StageReport& report)
{
  const RoomParameters& parameters = room_segmentation;
  const PointView points(*cloud);
  std::string reason;
  regions_ =
      segmentRooms(points, *allIndices(cloud->size()), levels_, parameters, reason);
  if (!reason.empty())
    return fail(reason);
  if (regions_.empty()) {
    char text[240];
    std::snprintf(
        text, sizeof text,
        "no room of at least %.1f square metres with a floor below %.0f %% of its "
        "ceiling and walls around it, along %.0f %% more of its outline than is open; "
        "planes: ",
        parameters.minimum_area, 100 * parameters.minimum_floor_share,
        100 * parameters.minimum_enclosure);
    return fail(text + listOf(planes));
  }
  const CellGrid grid(parameters.cell_size);
  for (std::size_t r = 0; r < regions_.size(); ++r)
    for (const int i : levels_[regions_[r].ceiling_level].inliers) {
      const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
      if (!regions_[r].ceiling.contains(grid.at(p.x(), p.y())))
        continue;
      labels[static_cast<std::size_t>(i)] = valueOf(StructureLabel::Ceiling);
      rooms[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(r + 1);
      ++report.points_out;
    }
  for (std::size_t r = 0; r < regions_.size(); ++r)
    report.points_out += addHiddenCeiling(r);
  territory_ = territories();
  tellResult("RoomSegmentation");
  return true;
}

std::size_t
StructureChain::addHiddenCeiling(std::size_t region)
{
  const CellGrid grid(room_segmentation.cell_size);
  const CellSet& hidden = regions_[region].hidden;
  const PlanSlab& slab = levels_[regions_[region].ceiling_level].slab;
  for (std::size_t i = 0; i < hidden.size(); ++i) {
    const Eigen::Vector2d place = grid.centre(hidden[i]);
    cloud->push_back({static_cast<float>(place.x()), static_cast<float>(place.y()),
                      static_cast<float>(slab.heightAt(place))});
    labels.push_back(valueOf(StructureLabel::Ceiling));
    rooms.push_back(static_cast<std::uint32_t>(region + 1));
  }
  return hidden.size();
}

std::vector<CellSet>
StructureChain::scopes() const
{
  std::vector<CellSet> scopes;
  for (const auto& region : regions_)
    scopes.push_back(region.scope);
  return scopes;
}

std::vector<pcl::IndicesPtr>
StructureChain::territories() const
{
  const RoomTerritory territory(CellGrid(outlier_removal.getGridSize()), scopes());
  std::vector<pcl::IndicesPtr> result;
  for (std::size_t r = 0; r < regions_.size(); ++r)
    result.emplace_back(new pcl::Indices);
  const PointView points(*cloud);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::int32_t room = territory.roomAt(points[i]);
    if (room >= 0)
      result[static_cast<std::size_t>(room)]->push_back(static_cast<int>(i));
  }
  return result;
}

} // namespace sedr
} // namespace pcl
