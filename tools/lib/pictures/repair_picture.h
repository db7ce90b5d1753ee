// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include <pcl/sedr_filters/vertical_hole_repair.h>

#include <vector>

namespace pcl::sedr::tools {

/** @brief Result of a hole repair: the points of all surfaces and whether they were
 * seen. */
struct RepairedSurfaces {
  std::vector<RepairedStrip> strips;
  std::vector<bool> is_seen;        ///< per point
  std::size_t repaired_floor = 0;   ///< points added in holes of floors
  std::size_t repaired_ceiling = 0; ///< points added in ceilings and undersides

  /** @brief Appends the surfaces of another room. */
  RepairedSurfaces& operator+=(const RepairedSurfaces& other);
};

/** @brief Returns the surfaces of the last run of a repair. */
template <typename PointT>
RepairedSurfaces
repairedSurfacesOf(const pcl::VerticalHoleRepair<PointT>& repair)
{
  RepairedSurfaces surfaces;
  surfaces.strips = repair.getStrips();
  const pcl::Indices& sources = repair.getSourceIndices();
  for (std::size_t k = 0; k < sources.size(); ++k) {
    const SurfacePoint& point = repair.getSurfacePoints()[k];
    surfaces.is_seen.push_back(sources[k] >= 0);
    if (sources[k] >= 0 || std::abs(point.normal.z()) < 0.5)
      continue;
    ++(point.normal.z() > 0 ? surfaces.repaired_floor : surfaces.repaired_ceiling);
  }
  return surfaces;
}

/** @brief Draws the result of VerticalHoleRepair: a plan with the filled walls, and all
 * vertical surfaces unrolled, seen from inside. Seen and filled cells have different
 * colours. */
Picture drawRepair(const RepairedSurfaces& surfaces, const Floorplan& plan);

} // namespace pcl::sedr::tools
