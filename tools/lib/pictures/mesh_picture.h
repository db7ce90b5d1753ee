// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include <pcl/sedr_surface/triangle_mesh.h>

namespace pcl::sedr::tools {

/** @brief Draws a mesh of rooms, whose triangles face into them, from above and from
 * below. Back faces, such as ceilings and nearer walls, are omitted. Labels of
 * triangles give the colours. */
Picture drawMesh(const TriangleMesh& mesh);

} // namespace pcl::sedr::tools
