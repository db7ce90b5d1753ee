// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <string>

namespace pcl::sedr {

/** @brief Reads the content of a PLY file into `mesh`.
 * @return an empty string or an error message, to follow the file's name */
std::string parsePly(const std::string& content, TriangleMesh& mesh);

} // namespace pcl::sedr
