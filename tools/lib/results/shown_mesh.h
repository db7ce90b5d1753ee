// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colour.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Returns the lit colour of a surface, by its orientation and independent of
 * the viewer. Both sides are equal.
 * @param normal unit length */
Colour litColour(Colour colour, const Eigen::Vector3d& normal);

/** @brief Returns the lines between elements of a mesh, or between labels if it has no
 * elements, each by its two ends. Edges with a single triangle count. */
std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>
elementEdges(const TriangleMesh& mesh);

} // namespace pcl::sedr::tools
