// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief What is wrong with the options, a sentence; empty if nothing is. */
std::string problemOf(const WallGrowingOptions& options);

/** @brief The parts of a room: finite points, ascending, each in one part only. */
struct WallParts {
  pcl::Indices ceiling;
  pcl::Indices floor;
  pcl::Indices details;    ///< none without a slice
  pcl::Indices candidates; ///< for walls: what no other part holds
};

/** @brief Sorts the indices a user gave into parts. Null pointers stand for no points.
 */
WallParts wallParts(const PointView& points,
                    const pcl::Indices& candidates,
                    const pcl::Indices* ceiling,
                    const pcl::Indices* floor,
                    const pcl::Indices* details,
                    const WallGrowingOptions& options);

/** @brief What a run with these options misses among the parts, a sentence; empty if
 * nothing. */
std::string problemOf(const WallParts& parts, const WallGrowingOptions& options);

/** @brief The elements of two ascending lists, each once. */
pcl::Indices unite(const pcl::Indices& a, const pcl::Indices& b);

/** @brief The seeds that are left when those of rims with less than the minimum support
 * have gone. */
WallSeeds seedsWithSupport(const PointView& points,
                           const WallParts& parts,
                           const WallSeeds& seeds,
                           const WallGrowingOptions& options);

/** @brief The candidates that are near a seed in plan. O((n + s) log s) for n
 * candidates and s seeds. */
pcl::Indices growWalls(const PointView& points,
                       const WallParts& parts,
                       const WallSeeds& seeds,
                       const WallGrowingOptions& options);

/** @brief The grid of cells of `size` or, where coordinates are too large for 32-bit
 * cells of that size, of the least size above it whose cells reach all points of the
 * parts. O(n). */
CellGrid gridOver(const PointView& points, const WallParts& parts, double size);

} // namespace pcl::sedr
