// SPDX-License-Identifier: BSD-3-Clause
#include "all_indices.h"

#include <pcl/sedr_surface/structure_chain.h>

#include <pcl/sedr_filters/parallel.h>
#include <pcl/sedr_segmentation/cell_fill.h>
#include <pcl/sedr_segmentation/hanging_furniture.h>
#include <pcl/sedr_segmentation/plane_list.h>
#include <pcl/sedr_segmentation/scan_check.h>
#include <pcl/sedr_segmentation/scan_lean.h>

#include <algorithm>
#include <cstdio>

namespace pcl {
namespace sedr {

namespace {

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
  const unsigned threads = room_segmentation.threads;
  std::string reason = upProblem(points, *all, RoomsAlongZ::NotLookedFor, 0, threads);
  if (reason.empty())
    reason = leanProblem(points, *all, threads);
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
  std::vector<Level> levels(planes.size());
  parallelBlocks(planes.size(), 1, room_segmentation.threads,
                 [&](std::size_t l, std::size_t) {
                   levels[l] = levelOf(planes[l]);
                   if (levels[l].kind != LevelKind::Other)
                     levels[l].cells = CellSet(grid, points, levels[l].inliers);
                 });
  return levels;
}

bool
StructureChain::leaveOutHangingFurniture(const std::vector<Level>& levels)
{
  const double size = plane_detection.getGridSize();
  const HangingFurniture hanging = hangingFurnitureBelow(
      levels, PointView(*cloud), size, room_segmentation.minimum_height,
      room_segmentation.threads);
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
StructureChain::cellSizeThatFills(const std::vector<Level>& levels) const
{
  std::vector<CellSet> ceilings;
  for (const Level& level : levels)
    if (level.kind == LevelKind::Ceiling)
      ceilings.push_back(level.cells);
  return cellSizeFor(ceilings, plane_detection.getGridSize());
}

bool
StructureChain::findPlanes(StageReport& report)
{
  if (!detectPlanes())
    return false;
  const double size = plane_detection.getGridSize();
  std::vector<Level> levels = levelsOfPlanes(size);
  const double wanted = adapts_grid ? cellSizeThatFills(levels) : size;
  if (wanted > size) {
    enlargeCells(wanted);
    if (!detectPlanes())
      return false;
    levels = levelsOfPlanes(wanted);
    constexpr double uneven = 1.2; // what fills at random fills no square quite alike
    const bool is_filled = cellSizeThatFills(levels) < uneven * wanted;
    char text[200];
    std::snprintf(text, sizeof text,
                  "the scan is too sparse for cells of %.2f m, its ceilings leave some "
                  "empty: cells of %.2f m are used%s",
                  size, wanted,
                  is_filled ? ""
                            : ", of which some are still empty: walls may be guesses");
    warnings.push_back(text);
  }
  if (leaveOutHangingFurniture(levels) && !detectPlanes())
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
                             RoomsAlongZ::Found, areaOfRooms(planes),
                             room_segmentation.threads);
    return doubt.empty() || fail(doubt);
  }
  const std::string turned =
      upProblem(PointView(*cloud), *allIndices(cloud->size()), RoomsAlongZ::None);
  return fail(missing + (turned.empty() ? "" : "; " + turned));
}

} // namespace sedr
} // namespace pcl
