// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../sheets/sheet_fit.h"
#include "cell_cracks.h"

#include <Eigen/Core>

#include <vector>

namespace pcl::sedr {

/** @brief The lines between the pieces of a sheet in plan, one of each chain of
 * `cracks`, from its first vertex to its last: where two facets meet, the line above
 * which both have one height; elsewhere straight steps where their riser
 * is, or between the points of both, along the walls' directions where they are nearly
 * so.
 * @param points of the ceiling
 * @param risers points between its heights, see pointsOfRisers()
 * @param directions of the walls, radians */
std::vector<std::vector<Eigen::Vector2d>>
bordersOf(const FacetSheet& sheet,
          const CellCracks& cracks,
          const std::vector<Eigen::Vector3d>& points,
          const std::vector<Eigen::Vector3d>& risers,
          const std::vector<double>& directions);

} // namespace pcl::sedr
