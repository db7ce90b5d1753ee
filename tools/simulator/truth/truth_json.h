// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scene/scene.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <string>

namespace pcl::sedr::sim {

/** @brief Returns rooms, storeys, openings and links of a scene as JSON, in the
 * frame of the files, metres: see doc/pcl_simulate_indoor_scan.md.
 *
 * Loops, areas and perimeters are exact. Height and volume are those of the
 * mesh.
 * @param truth truthMesh() of the scene
 * @throw std::invalid_argument as meshOf() */
std::string truthToJson(const Scene& scene, const TriangleMesh& truth);

} // namespace pcl::sedr::sim
