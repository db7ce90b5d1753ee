// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>
#include <pcl/types.h>

#include <string>

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

/** @brief Seeds of walls: indices of finite points, increasing. */
struct WallSeeds {
  pcl::Indices above; ///< all seeds if there is no slice height
  pcl::Indices below;
};

/** @brief The candidates that are near a seed in plan. O((n + s) log s) for n
 * candidates and s seeds. */
pcl::Indices growWalls(const PointView& points,
                       const WallParts& parts,
                       const WallSeeds& seeds,
                       const WallGrowingOptions& options);

} // namespace pcl::sedr
