// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_filters/priors.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief How a scan stands to z. */
struct ScanLean {
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ(); ///< across its floors, unit
  double angle = 0; ///< between that and z, radians; 0 where the scan does not lean
  double area = 0;  ///< of what stands so and is level in the building, square metres
};

/** @brief Whether a scan leans as a whole, by 3 to 45 degrees: the planes of most of
 * what is more level than upright agree in one direction, few are across z, and the
 * walls stand along that direction rather than along z. A sloping roof between upright
 * walls does not lean. For thinned points; patches of half a metre are looked at,
 * O(n log n).
 * @param threads 0: as many as there are processors */
ScanLean leanOf(const PointView& points,
                const std::vector<int>& indices,
                unsigned threads = 1,
                const Priors& priors = {});

/** @brief What to do about a scan that leans, a sentence with its numbers; empty if it
 * does not. Walls that stand at an angle to z lean too where y or x is up: then the
 * sentence says that, if across that axis two planes at the distance of a floor and a
 * ceiling are half as large again as across the direction that leans; where they are
 * about as large, it names the turns of both.
 * @param threads 0: as many as there are processors */
std::string leanProblem(const PointView& points,
                        const std::vector<int>& indices,
                        unsigned threads = 1,
                        const Priors& priors = {});

} // namespace sedr
} // namespace pcl
