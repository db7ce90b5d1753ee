// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/mesh/scene_mesh.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace pcl::sedr::sim {

/** @brief Returns rooms, storeys, openings and links of a scene as JSON, in the frame
 * of the files, metres: see doc/pcl_simulate_indoor_scan.md.
 *
 * Loops, areas and perimeters are exact. Height and volume are those of the mesh.
 * @param truth truthOf() of the scene
 * @throw std::invalid_argument as meshOf() */
std::string truthToJson(const Scene& scene, const TriangleMesh& truth);

/** @brief Writes truth.ply and truth.json to a folder, in the frame of the files.
 * @param mesh meshOf() the scene
 * @return the number of triangles
 * @throw std::runtime_error if a file cannot be written */
std::size_t writeTruth(const std::filesystem::path& folder,
                       const Scene& scene,
                       const SceneMesh& mesh);

} // namespace pcl::sedr::sim
