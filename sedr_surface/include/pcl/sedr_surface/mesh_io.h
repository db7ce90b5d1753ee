// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Reads a triangle mesh from a PLY (ascii or binary, any byte order) or OBJ
 * file.
 *
 * Polygons are cut into triangles; the face properties `label`, `room` and `element` of
 * a PLY are kept, other properties and elements skipped. Told apart by their content,
 * not by the file's name.
 *
 * @return an empty string, or a sentence that says why there is no mesh: the file is
 * missing, truncated, of another format, has indices out of range, no triangles. `mesh`
 * is empty then. */
std::string loadMesh(const std::string& path, TriangleMesh& mesh);

/** @brief Writes a binary little-endian PLY: x, y, z, floats unless a coordinate of 256
 * m or more calls for doubles; faces with int `label`, `room` and `element` if the mesh
 * has them, and the label's colour; vertices then with uint `label` and `room`, those
 * of most of the area around them, and that label's colour. Written beside and then
 * renamed: the file is whole or not there.
 *
 * @param comments lines for the header
 * @return an empty string, or a sentence that says why nothing was written */
std::string savePly(const std::string& path,
                    const TriangleMesh& mesh,
                    const std::vector<std::string>& comments = {});

} // namespace sedr
} // namespace pcl
