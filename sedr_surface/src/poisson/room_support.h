// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_poisson.h"

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Formats a number with few digits, for messages. */
std::string shortNumber(double value);

/** @brief Returns the mean of the points; at least one. */
Eigen::Vector3d centroidOf(const std::vector<OrientedPoint>& points);

/** @brief Orients the surface like the points' normals and measures its area, volume
 * and unsupported share.
 * @param nearest for each triangle the index of the point nearest to its centre */
void compareWithPoints(const std::vector<OrientedPoint>& points,
                       const RoomPoissonParameters& parameters,
                       TriangleMesh& mesh,
                       std::vector<std::uint32_t>& nearest,
                       RoomPoissonReport& report);

} // namespace pcl::sedr
