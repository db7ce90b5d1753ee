// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "viewed_result.h"

#include <Eigen/Core>

#include <string>

namespace pcl::sedr::tools {

/** @brief Describes a place in a line: coordinates, label and room of the nearest
 * structure point (or face, without points), element of the solid, distance from the
 * mesh. */
std::string reportPoint(const ViewedResult& result, const Eigen::Vector3d& place);

} // namespace pcl::sedr::tools
