// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_filters/scan_frame.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pcl {
struct PolygonMesh;
}

namespace pcl::sedr {

/** @brief A face of a room's solid: its floor, a wall, the underside of a detail. */
struct SolidElement {
  std::uint32_t room = 0; ///< PlanRoom::id
  StructureLabel label = StructureLabel::Other;
  /** @brief Name of its place in the plan, counted from 1: room_1_floor, room_1_wall_3,
   * room_1_column_2_face_1, room_1_detail_1, room_1_detail_1_edge_4,
   * room_1_detail_1_hole_1_edge_2, likewise for room_1_floor_detail_1, and
   * room_1_niche_1_bottom, room_1_niche_1_top, room_1_niche_1_side_2. */
  std::string name;
};

/** @brief Three vertex indices, counter-clockwise seen from the side of the normal. */
using Triangle = std::array<std::uint32_t, 3>;

/** @brief An indexed triangle mesh, used by all mesh algorithms of this library.
 * Vertices in metres, z up.
 *
 * @code
 * pcl::sedr::TriangleMesh mesh;
 * mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
 * mesh.triangles = {{0, 1, 2}};
 * @endcode */
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> labels;   ///< StructureLabel per triangle, or empty
  std::vector<std::uint32_t> rooms;    ///< room per triangle (0 none), or empty
  std::vector<std::uint32_t> elements; ///< element of the plan per triangle (0 none),
                                       ///< see FloorplanExtrusion; or empty

  /** @brief Returns true without triangles. */
  bool empty() const { return triangles.empty(); }

  /** @brief Returns corner `i` (0, 1 or 2) of triangle `t`. */
  const Eigen::Vector3d& corner(std::size_t t, int i) const
  {
    return vertices[triangles[t][static_cast<std::size_t>(i)]];
  }

  /** @brief Returns the normal of triangle `t`, whose length is twice the area (square
   * metres). */
  Eigen::Vector3d scaledNormal(std::size_t t) const
  {
    const Eigen::Vector3d& a = corner(t, 0);
    return (corner(t, 1) - a).cross(corner(t, 2) - a);
  }

  /** @brief Returns the surface area, square metres. O(triangles). */
  double area() const;

  /** @brief Returns the enclosed volume, cubic metres: positive if the normals point
   * outwards, negative if inwards, meaningless if the mesh is not closed.
   * O(triangles). */
  double signedVolume() const;

  /** @brief Returns the bounding box of the vertices used by triangles; empty for an
   * empty mesh. */
  Eigen::AlignedBox3d bounds() const;

  /** @brief Reverses every normal. */
  void flip();

  /** @brief Returns labels, rooms and elements, the attributes of triangles. */
  std::array<std::vector<std::uint32_t>*, 3> attributes()
  {
    return {&labels, &rooms, &elements};
  }

  /** @brief Appends `other`. Labels, rooms and elements are kept; if only one mesh has
   * them, the other's triangles get 0. */
  void append(const TriangleMesh& other);

  /** @brief Keeps the triangles with `keep[t]` true, in order and with their
   * attributes; vertices stay. `keep` has one entry per triangle.
   * @return the number of triangles removed */
  std::size_t keepTriangles(const std::vector<bool>& keep);

  /** @brief Removes vertices that no triangle uses; the others keep their order.
   * @return the number of vertices removed */
  std::size_t removeUnusedVertices();

  /** @brief Returns why the mesh is invalid, in a sentence ("triangle 3 uses vertex 9,
   * there are 8"), or empty. Invalid are indices out of range, non-finite coordinates,
   * and labels, rooms or elements of another length than the triangles. O(n). */
  std::string problem() const;
};

/** @brief Splits a polygon into triangles. Concave polygons are handled if planar;
 * polygons that cross themselves or are flat become a fan. O(n log n).
 *
 * @param vertices coordinates that the polygon's indices refer to
 * @param polygon three or more indices; fewer give nothing
 * @param triangles get those of the polygon */
void triangulatePolygon(const std::vector<Eigen::Vector3d>& vertices,
                        const std::vector<std::uint32_t>& polygon,
                        std::vector<Triangle>& triangles);

/** @brief Converts a PCL mesh: x, y and z (float or double) of the cloud, polygons cut
 * into triangles.
 * @return an empty string, or why the mesh is invalid, with `mesh` left empty */
std::string fromPolygonMesh(const pcl::PolygonMesh& polygon_mesh, TriangleMesh& mesh);

/** @brief Converts to a PCL mesh: a cloud with float x, y, z and one polygon per
 * triangle. Labels and rooms are lost. */
void toPolygonMesh(const TriangleMesh& mesh, pcl::PolygonMesh& polygon_mesh);

/** @brief A set of triangles connected across shared edges. */
struct MeshComponent {
  std::size_t triangles = 0;
  double area = 0;          ///< square metres
  double signed_volume = 0; ///< cubic metres; negative if the normals point inwards
  bool closed = false;      ///< no edge has only one triangle
};

/** @brief The connectivity of a mesh, from indices alone: two vertices at the same
 * place are distinct (see weldVertices). */
struct MeshTopology {
  std::size_t vertices = 0; ///< used by triangles
  std::size_t edges = 0;
  std::size_t triangles = 0;
  std::size_t degenerate_triangles = 0;  ///< triangles that use a vertex twice
  std::size_t duplicate_triangles = 0;   ///< with the vertices of an earlier one
  std::size_t boundary_edges = 0;        ///< edges with one triangle
  std::size_t non_manifold_edges = 0;    ///< edges with three or more
  std::size_t inconsistent_edges = 0;    ///< traversed twice in one direction
  std::size_t non_manifold_vertices = 0; ///< with more than one fan of triangles
  std::int64_t euler_characteristic = 0; ///< vertices - edges + triangles
  std::vector<MeshComponent> components; ///< largest area first

  /** @brief Returns true if no edge has only one triangle. */
  bool isClosed() const { return triangles > 0 && boundary_edges == 0; }

  /** @brief Returns true if the mesh bounds a solid: closed, manifold at edges and
   * vertices, consistently oriented, without degenerate or duplicate triangles. */
  bool isClosedManifold() const
  {
    return isClosed() && non_manifold_edges == 0 && non_manifold_vertices == 0 &&
           inconsistent_edges == 0 && degenerate_triangles == 0 &&
           duplicate_triangles == 0;
  }

  /** @brief Returns for users why isClosedManifold() is false: "12 boundary edges, 3
   * non-manifold edges"; empty if it is true. */
  std::string problem() const;
};

/** @brief Computes the connectivity of `mesh`.
 *
 * Triangles are connected where they share an edge. Two cubes that touch at a vertex
 * are two components with one non-manifold vertex. The mesh must be valid
 * (TriangleMesh::problem() empty). O(n log n) for n triangles; deterministic. */
MeshTopology checkTopology(const TriangleMesh& mesh);

/** @brief Returns the component of every triangle. Components are numbered from 0 in
 * the order of their first triangles. */
std::vector<std::uint32_t> labelComponents(const TriangleMesh& mesh);

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
