// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/structure_label.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {

struct PolygonMesh;

namespace sedr {

/** @brief A face of a room's solid: its floor, a wall, the underside of a detail. */
struct SolidElement {
  std::uint32_t room = 0; ///< PlanRoom::id
  StructureLabel label = StructureLabel::Other;
  /** @brief Where it stands in the plan, counted from 1: room_1_floor, room_1_wall_3,
   * room_1_column_2_face_1, room_1_detail_1, room_1_detail_1_edge_4,
   * room_1_detail_1_hole_1_edge_2, the same of room_1_floor_detail_1, and
   * room_1_niche_1_bottom, room_1_niche_1_top, room_1_niche_1_side_2. */
  std::string name;
};

/** @brief Three indices into the vertices; seen from the side that the normal points to
 * they run counter-clockwise. */
using Triangle = std::array<std::uint32_t, 3>;

/** @brief An indexed triangle mesh: the plain structure that every mesh algorithm of
 * this library works on. Vertices in metres, z up.
 *
 * @code
 * pcl::sedr::TriangleMesh mesh;
 * mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
 * mesh.triangles = {{0, 1, 2}};
 * @endcode */
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> labels; ///< a StructureLabel a triangle, or empty
  std::vector<std::uint32_t> rooms;  ///< a room a triangle (0 none), or empty
  std::vector<std::uint32_t>
      elements; ///< a number a triangle (0 none), or empty: which
                ///< part of a plan it is, of FloorplanExtrusion

  /** @brief True without triangles. */
  bool empty() const { return triangles.empty(); }

  /** @brief Corner `i` (0, 1 or 2) of triangle `t`. */
  const Eigen::Vector3d& corner(std::size_t t, int i) const
  {
    return vertices[triangles[t][static_cast<std::size_t>(i)]];
  }

  /** @brief Normal of triangle `t`, its length twice the area (square metres). */
  Eigen::Vector3d scaledNormal(std::size_t t) const
  {
    const Eigen::Vector3d& a = corner(t, 0);
    return (corner(t, 1) - a).cross(corner(t, 2) - a);
  }

  /** @brief Surface area, square metres. O(triangles). */
  double area() const;

  /** @brief Enclosed volume, cubic metres: positive if the normals point outwards,
   * negative if they point inwards, without meaning if the mesh is not closed.
   * O(triangles). */
  double signedVolume() const;

  /** @brief Box around the vertices that triangles use; empty for an empty mesh. */
  Eigen::AlignedBox3d bounds() const;

  /** @brief Turns every normal round. */
  void flip();

  /** @brief The labels, rooms and elements: whatever is kept of every triangle. */
  std::array<std::vector<std::uint32_t>*, 3> attributes()
  {
    return {&labels, &rooms, &elements};
  }

  /** @brief Adds `other` behind the triangles of this mesh. Labels, rooms and elements
   * are kept; where only one of the two has them, the other's triangles get 0. */
  void append(const TriangleMesh& other);

  /** @brief Keeps the triangles with `keep[t]` true, in their order, with label, room
   * and element; vertices stay. `keep` has one entry a triangle.
   * @return the number of triangles removed */
  std::size_t keepTriangles(const std::vector<bool>& keep);

  /** @brief Removes vertices that no triangle uses; the others keep their order.
   * @return the number of vertices removed */
  std::size_t removeUnusedVertices();

  /** @brief What makes this structure no mesh, in a sentence ("triangle 3 uses vertex
   * 9, there are 8"), or empty: indices out of range, coordinates that are not finite,
   * labels, rooms or elements of another length than the triangles. O(n). */
  std::string problem() const;
};

/** @brief Splits a polygon into triangles by cutting ears; concave polygons come out
 * right if they are planar, and a polygon that cannot be cut (crossing itself, flat)
 * becomes a fan.
 *
 * @param vertices the coordinates that the polygon points into
 * @param polygon three or more indices; fewer give nothing
 * @param triangles the polygon.size() - 2 triangles are added to its end
 *
 * O(n^3) at worst, for n corners; three and four corners are quick. */
void triangulatePolygon(const std::vector<Eigen::Vector3d>& vertices,
                        const std::vector<std::uint32_t>& polygon,
                        std::vector<Triangle>& triangles);

/** @brief Reads a PCL mesh: x, y and z (float or double) of the cloud, polygons cut
 * into triangles.
 * @return an empty string, or why it is no mesh, with `mesh` left empty */
std::string fromPolygonMesh(const pcl::PolygonMesh& polygon_mesh, TriangleMesh& mesh);

/** @brief The mesh as PCL has it: a cloud with float x, y, z and one polygon a
 * triangle. Labels and rooms have no place there. */
void toPolygonMesh(const TriangleMesh& mesh, pcl::PolygonMesh& polygon_mesh);

} // namespace sedr
} // namespace pcl
