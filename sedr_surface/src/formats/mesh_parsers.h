// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/triangle_mesh.h>

#include <string>

namespace pcl {
namespace sedr {

/** @brief Reads the content of a PLY file into `mesh`.
 * @return an empty string or what is wrong with it, to stand behind the file's name */
std::string parsePly(const std::string& content, TriangleMesh& mesh);

/** @brief True if there is a vertex as OBJ writes it before anything that no text
 * holds. */
bool looksLikeObj(const std::string& content);

/** @brief The same for an OBJ file. */
std::string parseObj(const std::string& content, TriangleMesh& mesh);

} // namespace sedr
} // namespace pcl
