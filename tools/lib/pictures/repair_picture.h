// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include <pcl/sedr_filters/vertical_hole_repair.h>

#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What a hole repair left: the points of all surfaces and which were seen. */
struct RepairedSurfaces {
  std::vector<RepairedStrip> strips;
  std::vector<bool> is_seen;        ///< of every point
  std::size_t repaired_floor = 0;   ///< points that fill holes of floors
  std::size_t repaired_ceiling = 0; ///< likewise of ceilings and undersides

  /** @brief Adds those of another room. */
  RepairedSurfaces& operator+=(const RepairedSurfaces& other);
};

/** @brief The surfaces of the last run of a repair. */
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

/** @brief What VerticalHoleRepair did: a plan with the walls where they were filled,
 * and all upright surfaces unrolled, as they look from inside, seen and filled cells
 * each in their colour. */
Picture drawRepair(const RepairedSurfaces& surfaces, const Floorplan& plan);

} // namespace tools
} // namespace sedr
} // namespace pcl
