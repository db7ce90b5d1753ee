// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/plan_warning.h>
#include <pcl/sedr_surface/mesh_topology.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Parameters of extrudeRoom(). */
struct SolidParameters {
  double chord_tolerance = 0.00025; ///< distance of facets from their arc, metres
  bool cut_openings = false;        ///< of a plan: see FloorplanExtrusion
};

/** @brief Result of extruding a room. */
struct RoomSolidReport {
  std::uint32_t room = 0; ///< PlanRoom::id
  std::size_t triangles = 0;
  MeshTopology topology;
  bool closed = false;     ///< closed, manifold at edges and vertices, oriented, and
                           ///< no triangle without area
  double area = 0;         ///< of the whole surface, square metres
  double floor_area = 0;   ///< at all its heights, square metres, as the next three
  double ceiling_area = 0; ///< with the undersides of details
  double wall_area = 0;    ///< of walls with their niches, and of columns
  double riser_area = 0;   ///< between two heights of floor or ceiling
  double volume = 0;       ///< cubic metres
  std::string problem;     ///< why there is no closed solid, or empty
  std::vector<PlanWarning> warnings; ///< contradictions of the plan that were resolved
};

/** @brief Builds the solid that a room's walls, floor, ceiling, columns and details
 * enclose.
 *
 * @code
 * pcl::sedr::TriangleMesh solid;
 * std::vector<pcl::sedr::SolidElement> elements;
 * const auto report = pcl::sedr::extrudeRoom(plan.rooms[0], {}, solid, elements);
 * @endcode
 *
 * Floor and ceiling are planes, walls and risers vertical, arcs facets. Every corner of
 * the plan is a vertex. Triangles face outwards, as in the simulator's truth, so that
 * the volume is positive. The surface is closed, manifold at edges and vertices and
 * does not intersect itself. To ensure this, plan and heights are snapped to a grid of
 * less than a micrometre; only crossings of edges are rounded.
 *
 * @param room any room; corners of tilted walls are where three surfaces meet;
 * contradictions in it are resolved (subdivideRoom()) and reported
 * @param parameters tolerances, in range
 * @param[out] solid triangles with label, room and element; empty if nothing could be
 * built, with the reason in RoomSolidReport::problem
 * @param[in,out] elements the room's elements are appended; a triangle's element is an
 * index into it plus 1
 *
 * Milliseconds for a room of some hundred edges. */
RoomSolidReport extrudeRoom(const PlanRoom& room,
                            const SolidParameters& parameters,
                            TriangleMesh& solid,
                            std::vector<SolidElement>& elements);

} // namespace pcl::sedr
