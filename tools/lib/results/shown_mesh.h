// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colour.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief A surface's colour in the light: a wall facing another way has another
 * brightness, whoever looks. Both sides are alike.
 * @param normal unit length */
Colour litColour(Colour colour, const Eigen::Vector3d& normal);

/** @brief The lines along which a mesh's elements, or where it has none its labels,
 * meet: each its two ends. Edges of one triangle only count. */
std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>
elementEdges(const TriangleMesh& mesh);

} // namespace tools
} // namespace sedr
} // namespace pcl
