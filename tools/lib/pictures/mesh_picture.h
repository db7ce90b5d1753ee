// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include <pcl/sedr_surface/triangle_mesh.h>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief A mesh of rooms, triangles facing into them, seen from above without what is
 * turned away from the viewer (the ceilings, the nearer walls), and likewise from
 * below. Its triangles' labels give the colours. */
Picture drawMesh(const TriangleMesh& mesh);

} // namespace tools
} // namespace sedr
} // namespace pcl
