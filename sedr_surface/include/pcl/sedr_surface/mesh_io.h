// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Reads a triangle mesh from a PLY (ascii or binary, any byte order) or OBJ
 * file.
 *
 * Polygons are cut into triangles. The face properties `label`, `room` and `element` of
 * a PLY are kept; other properties and elements are skipped. The format is detected
 * from the content, not from the file name.
 *
 * @return an empty string, or a sentence that says why there is no mesh: the file is
 * missing, truncated, of another format, without triangles, or has indices out of
 * range. `mesh` is then empty. */
std::string loadMesh(const std::string& path, TriangleMesh& mesh);

/** @brief Writes a binary little-endian PLY.
 *
 * x, y and z are floats, or doubles if a coordinate is 256 m or more. Faces have int
 * `label`, `room` and `element` if the mesh has them, and the label's colour. Vertices
 * then have uint `label`, `room` and colour: those with the largest area around them.
 * The file is written beside and renamed, so it is complete or absent.
 *
 * @param comments lines for the header
 * @return an empty string, or a sentence that says why nothing was written */
std::string savePly(const std::string& path,
                    const TriangleMesh& mesh,
                    const std::vector<std::string>& comments = {});

} // namespace pcl::sedr
