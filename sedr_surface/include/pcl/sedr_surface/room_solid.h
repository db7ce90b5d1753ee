// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/wall_tilts.h>
#include <pcl/sedr_surface/mesh_topology.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief How a room becomes a solid. */
struct SolidParameters {
  double chord_tolerance = 0.0005; ///< metres that facets may be off their arc
  double snap_tolerance =
      0; ///< metres; 0: from the elements' residuals, snapTolerance()
};

/** @brief What became of a room. */
struct RoomSolidReport {
  std::uint32_t room = 0; ///< PlanRoom::id
  std::size_t triangles = 0;
  MeshTopology topology;
  bool closed = false;     ///< closed, manifold at edges and vertices, oriented
  double area = 0;         ///< of the whole surface, square metres
  double floor_area = 0;   ///< at all its heights, square metres, as the next three
  double ceiling_area = 0; ///< with the undersides of details
  double wall_area = 0;    ///< of walls and columns
  double riser_area = 0;   ///< between two heights of floor or ceiling, and in niches
  double volume = 0;       ///< cubic metres
  std::string problem;     ///< why there is no closed solid, or empty
  std::vector<std::string> warnings; ///< what was done to contradictions of the plan
};

/** @brief The solid that a room's walls, floor, ceiling, columns and details enclose.
 *
 * @code
 * pcl::sedr::TriangleMesh solid;
 * std::vector<pcl::sedr::SolidElement> elements;
 * const auto report = pcl::sedr::extrudeRoom(plan.rooms[0], {}, solid, elements);
 * @endcode
 *
 * Floor and ceilings are planes, walls and risers upright, arcs in facets; every corner
 * of the plan is a vertex. Triangles face outwards, as those of the simulator's truth
 * do, so that the volume is positive. The surface is closed, manifold at edges and
 * vertices and does not meet itself: plan and heights are on a grid of less than a
 * micrometre, on which nothing is computed with rounding but where edges cross.
 *
 * @param room any; what is contradictory in it is mended (subdivideRoom()) and told
 * @param parameters tolerances, in range
 * @param[out] solid triangles with label, room and element; empty if nothing could be
 * built, which RoomSolidReport::problem tells
 * @param[in,out] elements those of the room are added; a triangle's element is an index
 * into it plus 1
 * @param tilts of walls that lean: their corners are where three surfaces meet
 *
 * Milliseconds for a room of some hundred edges. */
RoomSolidReport extrudeRoom(const PlanRoom& room,
                            const SolidParameters& parameters,
                            TriangleMesh& solid,
                            std::vector<SolidElement>& elements,
                            const WallTilts& tilts = {});

/** @brief What makes a room none that can be built, in a sentence, or empty: a boundary
 * without elements, numbers that are not finite or beyond 1e6 m, upright slabs. */
std::string roomProblem(const PlanRoom& room);

} // namespace sedr
} // namespace pcl
