// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "viewed_result.h"

#include <Eigen/Core>

#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What is at a place, in a line: coordinates, label and room of the nearest
 * point of the structure (of the nearest face where there are no points), element of
 * the solid, distance from the mesh. */
std::string reportPoint(const ViewedResult& result, const Eigen::Vector3d& place);

} // namespace tools
} // namespace sedr
} // namespace pcl
