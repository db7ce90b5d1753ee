// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include <pcl/sedr_filters/structure_refinement.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace pcl::sedr::tools {

/** @brief A point of a wall, column or riser before and after refinement; metres. */
struct MovedPoint {
  Eigen::Vector2d before;
  Eigen::Vector2d after;
  StructureLabel label = StructureLabel::Wall; ///< of the surface it moved to
};

/** @brief Points of vertical surfaces after refinement. */
struct RefinedWalls {
  std::vector<MovedPoint> moved;
  std::vector<Eigen::Vector2d>
      removed; ///< wall and column points too far from the plan

  /** @brief Appends the points of another room. */
  RefinedWalls& operator+=(const RefinedWalls& other);
};

/** @brief Returns the walls of the last run of a refinement.
 * @param labels of every input point */
template <typename PointT>
RefinedWalls
refinedWallsOf(const pcl::StructureRefinement<PointT>& refinement,
               const std::vector<std::uint32_t>& labels)
{
  const auto input = refinement.getInputCloud();
  RefinedWalls walls;
  std::vector<bool> is_kept(input->size(), false);
  const pcl::Indices& sources = refinement.getSourceIndices();
  for (std::size_t k = 0; k < sources.size(); ++k) {
    const auto i = static_cast<std::size_t>(sources[k]);
    const SurfacePoint& surface = refinement.getSurfacePoints()[k];
    is_kept[i] = true;
    const Eigen::Vector3f before = (*input)[i].getVector3fMap();
    if (std::abs(surface.normal.z()) < 0.5)
      walls.moved.push_back(
          {before.head<2>().cast<double>(), surface.position.head<2>(), surface.label});
  }
  for (std::size_t i = 0; i < input->size(); ++i) {
    const auto label = static_cast<StructureLabel>(labels[i]);
    const Eigen::Vector3f p = (*input)[i].getVector3fMap();
    if (!is_kept[i] && p.allFinite() &&
        (label == StructureLabel::Wall || label == StructureLabel::Column))
      walls.removed.push_back(p.head<2>().cast<double>());
  }
  return walls;
}

/** @brief Draws the result of StructureRefinement (paper, Figure 7b): wall points in
 * plan before and after, overall and enlarged where they moved most, and a histogram of
 * movements. */
Picture drawRefinement(const RefinedWalls& walls, const Floorplan& plan);

} // namespace pcl::sedr::tools
