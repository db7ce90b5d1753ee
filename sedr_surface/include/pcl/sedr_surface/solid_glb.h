// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/origin.h>
#include <pcl/sedr_surface/room_layers.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Solids as a binary glTF 2.0: a node a storey, below it a node a room, below
 * that a node an element, named as these are, with the material of its label. Metres; y
 * up, as glTF has it: x, z, -y of the plan. Floats with normals; faces look out of the
 * rooms, and materials have two sides.
 *
 * @param mesh with rooms, labels and elements, as FloorplanExtrusion::getMesh()
 * @param elements what the mesh's elements are, as FloorplanExtrusion::getElements()
 * @param storeys storeysOf() the plan; rooms that none of them lists are left out
 * @param origin told in asset.extras unless it is 0 */
std::string solidToGlb(const TriangleMesh& mesh,
                       const std::vector<SolidElement>& elements,
                       const std::vector<PlanStorey>& storeys,
                       const Origin& origin = {});

} // namespace sedr
} // namespace pcl
