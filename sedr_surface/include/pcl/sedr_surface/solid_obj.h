// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/room_layers.h>
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

} // namespace sedr
} // namespace pcl
