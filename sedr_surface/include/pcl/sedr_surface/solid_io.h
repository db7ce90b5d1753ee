// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/scan_frame.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Solids as OBJ: an object a room, groups of the element, its room and, where
 * it is known, its storey, and materials by label. Metres, z up, seven decimals.
 *
 * @param mesh with rooms, labels and elements, as FloorplanExtrusion::getMesh()
 * @param elements what the mesh's elements are, as FloorplanExtrusion::getElements()
 * @param material_file name of the file that holds solidMaterials(), without a folder;
 * empty for none
 * @param storey_of numbers of the storeys of rooms, as storeyOfRooms() has them */
std::string solidToObj(const TriangleMesh& mesh,
                       const std::vector<SolidElement>& elements,
                       const std::string& material_file,
                       const std::map<std::uint32_t, std::uint32_t>& storey_of = {});

/** @brief The materials of solidToObj(), as an MTL file: ceiling, floor, wall, detail,
 * column. */
std::string solidMaterials();

/** @brief Lines for the header of a PLY: "element 3 room_1_wall_1" for each element
 * that has triangles, the number being that of the triangles. */
std::vector<std::string> elementComments(const TriangleMesh& mesh,
                                         const std::vector<SolidElement>& elements);

/** @brief Solids as a binary glTF 2.0: a node a storey, below it a node a room, below
 * that a node an element, named as these are, with the material of its label. Metres; y
 * up, as glTF has it: x, z, -y of the plan. Faces look out of the rooms, are shaded flat
 * as glTF has it without normals, and materials have two sides.
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
