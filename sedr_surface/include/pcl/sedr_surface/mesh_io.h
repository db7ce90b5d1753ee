// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/scan_frame.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief A colour of a surface, channels from 0 to 255. */
struct SeenColour {
  std::array<std::uint8_t, 3> rgb{}; ///< red, green, blue
  bool is_seen = false;              ///< else it was filled in from beside
};

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
 * With given colours, faces have none, and vertices have uchar `seen`, 0 or 1.
 *
 * @param mesh valid: its problem() is empty
 * @param comments lines for the header
 * @param colours of the vertices; empty: those of the labels
 * @return the bytes of the file */
std::string meshToPly(const TriangleMesh& mesh,
                      const std::vector<std::string>& comments = {},
                      const std::vector<SeenColour>& colours = {});

/** @brief Writes solids as OBJ: one object per room, materials by label, and groups
 * named by element, room and, where known, storey. Metres, z up, seven decimals.
 *
 * @param mesh with rooms, labels and elements, as FloorplanExtrusion::getMesh()
 * @param elements the mesh's elements, as FloorplanExtrusion::getElements()
 * @param material_file name of the file that holds solidMaterials(), without a folder;
 * empty for none
 * @param storey_of storey of each room, as from storeyOfRooms() */
std::string solidToObj(const TriangleMesh& mesh,
                       const std::vector<SolidElement>& elements,
                       const std::string& material_file,
                       const std::map<std::uint32_t, std::uint32_t>& storey_of = {});

/** @brief Returns the materials of solidToObj() as an MTL file: ceiling, floor, wall,
 * detail, column. */
std::string solidMaterials();

/** @brief Returns comment lines for a PLY header, "element 3 room_1_wall_1", for each
 * element that has triangles. The number is that stored with the triangles. */
std::vector<std::string> elementComments(const TriangleMesh& mesh,
                                         const std::vector<SolidElement>& elements);

/** @brief Writes solids as binary glTF 2.0. A node per storey contains a node per room,
 * which contains a node per element, with its name and the material of its label.
 * Metres; y up, as glTF requires: x, z, -y of the plan. Faces point out of the rooms.
 * Without normals glTF shades them flat; materials are two-sided.
 *
 * @param mesh with rooms, labels and elements, as FloorplanExtrusion::getMesh()
 * @param elements the mesh's elements, as FloorplanExtrusion::getElements()
 * @param storeys from storeysOf(); rooms that none of them lists are left out
 * @param origin written to asset.extras unless it is 0
 * @param colours of the elements, whose materials have `seen` in their extras; empty:
 * those of the labels */
std::string solidToGlb(const TriangleMesh& mesh,
                       const std::vector<SolidElement>& elements,
                       const std::vector<PlanStorey>& storeys,
                       const Origin& origin = {},
                       const std::vector<SeenColour>& colours = {});

} // namespace pcl::sedr
