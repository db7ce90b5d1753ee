// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_poisson.h"

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief With as many digits as people want to read. */
std::string shortNumber(double value);

/** @brief Mean of the points; there must be one. */
Eigen::Vector3d centroidOf(const std::vector<OrientedPoint>& points);

/** @brief Turns the surface to the side of the points' normals and sees how much of it
 * they bear out: area, volume, what is a guess.
 * @param nearest for each triangle the index of the point nearest to its middle */
void compareWithPoints(const std::vector<OrientedPoint>& points,
                       const RoomPoissonParameters& parameters,
                       TriangleMesh& mesh,
                       std::vector<std::uint32_t>& nearest,
                       RoomPoissonReport& report);

} // namespace sedr
} // namespace pcl
