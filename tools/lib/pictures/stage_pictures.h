// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include <pcl/sedr_filters/floor_projection_recovery.h>
#include <pcl/sedr_filters/grid_region_outlier_removal.h>
#include <pcl/sedr_filters/structure_refinement.h>
#include <pcl/sedr_filters/vertical_hole_repair.h>
#include <pcl/sedr_segmentation/building.h>
#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>
#include <pcl/sedr_segmentation/floorplan_fitting.h>
#include <pcl/sedr_segmentation/grid_slice_detail.h>
#include <pcl/sedr_segmentation/horizontal_plane_detection.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <pcl/point_types.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Draws the result of ParallelVoxelGrid: the number of points per cell of the
 * plan before and after.
 * @param leaf edge of a voxel and of a cell, metres */
Picture drawThinning(const RowSource& before, const PointView& after, double leaf);

/** @brief Draws the rooms of a building, storey by storey: number and area of each
 * room, its hidden parts darker, and the heights of their ceilings. */
Picture drawRooms(const Building& building);

/** @brief Draws the result of HorizontalPlaneDetection: ceilings, floors and others.
 * @param points the cloud of the planes' indices
 * @param cell_size of the maps, metres */
Picture drawPlanes(const std::vector<pcl::HorizontalPlane>& planes,
                   const PointView& points,
                   double cell_size);

/** @brief Draws the result of GridRegionOutlierRemoval (paper, Figure 3b to d): the
 * binary map, the regions with their sizes, and which of them are kept. */
Picture drawRegions(const RegionMap& map);

/** @brief Draws the result of GridSliceDetail (paper, Figure 4), of one room each: a
 * map per trial with the cells of ceiling and slices and the zero-valued regions, and a
 * map of the details.
 * @param cell_size of the analysis, metres */
Picture drawSlices(const std::vector<SliceDetails>& rooms, double cell_size);

/** @brief Classification of the cells of a room's floor. */
struct FloorCells {
  double cell_size = 0; ///< metres
  CellSet seen;
  CellSet recovered; ///< below the ceiling, without a floor point
  CellSet removed;   ///< outside the room
};

/** @brief Returns the cells of the last run of a recovery that extracts removed
 * indices. */
FloorCells floorCellsOf(const pcl::FloorProjectionRecovery<pcl::PointXYZ>& recovery);

/** @brief Draws the result of FloorProjectionRecovery (paper, Figure 5): the floor
 * before, with hidden and outside cells, and after. */
Picture drawFloor(const std::vector<FloorCells>& rooms);

/** @brief The walls of one room, and their seeds; indices into one cloud. */
struct RoomWalls {
  std::uint32_t room = 0;  ///< 0: the only one
  pcl::Indices boundary;   ///< of ceiling and scope, and of the floor below a slice
  pcl::Indices seeds;      ///< the part of it that walls grow from
  pcl::Indices walls;      ///< without details
  pcl::Indices details;    ///< details that joined the walls
  pcl::Indices candidates; ///< points that may be wall
};

/** @brief Returns the result of the last run of a growing. */
RoomWalls roomWallsOf(const pcl::CeilingBoundaryWallGrowing<pcl::PointXYZ>& growing,
                      std::uint32_t room);

/** @brief Draws the result of CeilingBoundaryWallGrowing (paper, Figure 6): boundary
 * and seeds, and the walls with the details that joined them. */
Picture drawWalls(const std::vector<RoomWalls>& rooms, const PointView& points);

/** @brief Draws the result of FloorplanFitting (paper, Figure 7a): boundary points,
 * fitted lines and arcs, corners and rooms. */
Picture drawPlan(const Floorplan& plan, const std::vector<FittedBoundary>& boundaries);

/** @brief A point of a wall, column or riser before and after refinement; metres. */
struct MovedPoint {
  Eigen::Vector2d before;
  Eigen::Vector2d after;
  StructureLabel label = StructureLabel::Wall; ///< of the surface it moved to
};

/** @brief Points of vertical surfaces after refinement. */
struct RefinedWalls {
  std::vector<MovedPoint> moved;
  Places removed; ///< wall and column points too far from the plan
};

/** @brief Appends the walls of the last run of a refinement.
 * @param labels of every input point */
template <typename PointT>
void
addRefinedWalls(const pcl::StructureRefinement<PointT>& refinement,
                const std::vector<std::uint32_t>& labels,
                RefinedWalls& walls)
{
  const auto input = refinement.getInputCloud();
  std::vector<bool> is_kept(input->size(), false);
  const auto placeOf = [&](std::size_t i) -> Eigen::Vector2d {
    return Eigen::Vector2f((*input)[i].x, (*input)[i].y).template cast<double>();
  };
  for (std::size_t k = 0; k < refinement.getSourceIndices().size(); ++k) {
    const auto i = static_cast<std::size_t>(refinement.getSourceIndices()[k]);
    const SurfacePoint& surface = refinement.getSurfacePoints()[k];
    is_kept[i] = true;
    if (std::abs(surface.normal.z()) < 0.5)
      walls.moved.push_back({placeOf(i), surface.position.head<2>(), surface.label});
  }
  for (std::size_t i = 0; i < input->size(); ++i) {
    const auto label = static_cast<StructureLabel>(labels[i]);
    if (!is_kept[i] && placeOf(i).allFinite() &&
        (label == StructureLabel::Wall || label == StructureLabel::Column))
      walls.removed.push_back(placeOf(i));
  }
}

/** @brief Draws the result of StructureRefinement (paper, Figure 7b): wall points in
 * plan before and after. */
Picture drawRefinement(const RefinedWalls& walls, const Floorplan& plan);

/** @brief Result of a hole repair: the vertical surfaces of all rooms, and which of all
 * points were seen. */
struct RepairedSurfaces {
  std::vector<RepairedStrip> strips;
  std::vector<bool> is_seen; ///< per point
};

/** @brief Appends the surfaces of the last run of a repair. */
template <typename PointT>
void
addRepairedSurfaces(const pcl::VerticalHoleRepair<PointT>& repair,
                    RepairedSurfaces& surfaces)
{
  for (RepairedStrip strip : repair.getStrips()) {
    for (auto& column : strip.columns)
      column.first += surfaces.is_seen.size();
    surfaces.strips.push_back(std::move(strip));
  }
  for (const auto source : repair.getSourceIndices())
    surfaces.is_seen.push_back(source >= 0);
}

/** @brief Draws the result of VerticalHoleRepair: the plan, every stretch of a vertical
 * surface coloured by the share of it that was filled. */
Picture drawRepair(const RepairedSurfaces& surfaces, const Floorplan& plan);

/** @brief Draws a mesh of rooms, whose triangles face into them, from above and from
 * below. Back faces, such as ceilings and nearer walls, are omitted. Labels of
 * triangles give the colours. */
Picture drawMesh(const TriangleMesh& mesh);

} // namespace pcl::sedr::tools
