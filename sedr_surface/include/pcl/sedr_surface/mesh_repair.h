// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/mesh_topology.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>

namespace pcl {
namespace sedr {

/** @brief To which side of a closed surface its normals point. */
enum class NormalSide {
  Outward, ///< signed volume above zero
  Inward ///< signed volume below zero: into the room, if the surface is that of a room
};

/** @brief Which spaces stay apart where several sheets touch along one edge. */
enum class KeepApart {
  InFront, ///< the spaces that the normals point into
  Behind   ///< the spaces behind the triangles
};

/** @brief What the repair of a mesh did. */
struct MeshRepairReport {
  std::size_t welded_vertices = 0;
  std::size_t dropped_triangles = 0; ///< degenerate, duplicate or of no thickness
  std::size_t cut_edges = 0;         ///< non-manifold edges whose sheets were cut apart
  std::size_t cut_vertices = 0;      ///< vertices at which fans were cut apart
  std::size_t split_edges = 0; ///< edges that needed a vertex in their middle for it
  std::size_t flipped_triangles = 0; ///< turned to agree with their neighbours
  std::size_t orientation_conflicts =
      0; ///< edges at which that is impossible (one-sided)
  std::size_t filled_holes = 0;
  std::size_t filled_edges = 0; ///< edges of the holes filled
  std::size_t open_holes = 0;   ///< holes left: too long, or not a simple loop
  std::size_t collapsed_edges = 0;
  std::size_t parted_vertices = 0; ///< moved from where another vertex is
  std::size_t removed_components = 0;
  std::size_t removed_triangles = 0; ///< with these components

  /** @brief Adds up the counts of two repairs. */
  MeshRepairReport& operator+=(const MeshRepairReport& other);
};

/** @brief Makes one vertex of those that lie within `tolerance` metres of an earlier
 * one, which they join; 0 joins equal positions only. Triangles may become degenerate.
 * @return the number of vertices that joined another */
std::size_t weldVertices(TriangleMesh& mesh, double tolerance = 0);

/** @brief Removes triangles that use a vertex twice, all but one of those that double
 * another, and both of two that lie back to back.
 * @return the number of triangles removed */
std::size_t dropDegenerateTriangles(TriangleMesh& mesh);

/** @brief Cuts sheets apart that touch in an edge or a vertex, so that both become
 * manifold.
 *
 * At an edge with three or more triangles, neighbours in angle that enclose a space on
 * the side given by `apart` make a sheet. Each sheet gets vertices of its own, and
 * where that is not enough an edge of its own by a vertex in the middle. The copies of
 * a vertex move 2 % of the way towards the middle of their own triangles: no reader
 * that welds equal positions joins them. The triangles must be consistently oriented
 * for `apart` to mean something. O(n log n). Adds to cut_edges, cut_vertices and
 * split_edges. */
void cutNonManifold(TriangleMesh& mesh, KeepApart apart, MeshRepairReport& report);

/** @brief Turns triangles so that neighbours agree; the first triangle of a component
 * decides. Adds to flipped_triangles and orientation_conflicts. O(n log n). */
void orientConsistently(TriangleMesh& mesh, MeshRepairReport& report);

/** @brief Turns every component whose normals do not point to `side`, judged by the
 * sign of its volume; components that enclose nothing stay.
 * @return the number of components turned */
std::size_t orientNormals(TriangleMesh& mesh, NormalSide side);

/** @brief Closes boundary loops of at most `max_edges` edges by a triangle or by a fan
 * about their centre. The vertices must be manifold (cutNonManifold). New triangles
 * take label and room of a neighbour. Adds to filled_holes and filled_edges, sets
 * open_holes. */
void fillHoles(TriangleMesh& mesh, std::size_t max_edges, MeshRepairReport& report);

/** @brief Collapses edges shorter than `length` metres where that changes neither the
 * topology nor the sense of a triangle: slivers go, and no two vertices at one place
 * remain.
 * @return the number of edges collapsed */
std::size_t collapseShortEdges(TriangleMesh& mesh, double length);

/** @brief Moves vertices apart that are at equal positions, as those of two sheets are
 * that both follow one edge: afterwards no two are, also in a file of floats, and a
 * reader that welds equal positions joins no sheets.
 *
 * All positions become what a float holds of them. Of several vertices in one place
 * the first stays; each other one goes 2 % of the way to the middle of its own
 * triangles, or farther or towards one of them where that place is taken. O(n log n).
 * @return the number of vertices moved */
std::size_t partEqualPositions(TriangleMesh& mesh);

/** @brief Keeps the `count` components of the largest area. Adds to removed_components
 * and removed_triangles. */
void
keepLargestComponents(TriangleMesh& mesh, std::size_t count, MeshRepairReport& report);

/** @brief What repairMesh does, and how far it goes. */
struct MeshRepairOptions {
  double weld_tolerance = -1;      ///< metres; negative: vertices are not welded
  double shortest_edge = 0;        ///< metres; 0: no edge is collapsed
  std::size_t max_hole_edges = 64; ///< longer boundary loops stay open
  std::size_t keep_components = 0; ///< the largest so many; 0: all
  KeepApart apart = KeepApart::InFront;
  NormalSide normals = NormalSide::Outward;
};

/** @brief Repairs a mesh as far as it goes: welds, drops degenerate triangles, cuts
 * sheets apart, orients, keeps the largest components, fills small holes, collapses
 * short edges.
 *
 * @param mesh repaired in place; unused vertices are removed
 * @param options how far to go
 * @param report what was done; set anew
 * @return the check of the result: whether all is well now is for the caller to ask
 *
 * Deterministic. O(n log n). */
MeshTopology repairMesh(TriangleMesh& mesh,
                        const MeshRepairOptions& options,
                        MeshRepairReport& report);

} // namespace sedr
} // namespace pcl
