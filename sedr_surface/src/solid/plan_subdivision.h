// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_facets.h"
#include "plan_grid.h"
#include "room_layers.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace pcl {
namespace sedr {

struct SolidParameters;

/** @brief A straight edge of a subdivision, with another region on either side. */
struct SubdivisionEdge {
  std::uint32_t a = 0; ///< index of a vertex
  std::uint32_t b = 0;
  PlanRegion left; ///< of the way from a to b
  PlanRegion right;
  std::vector<std::size_t> elements; ///< SolidElements of the plan that lie on it
};

/** @brief A straight line within a region along which its curved slab is folded. */
struct SubdivisionCrease {
  std::uint32_t a = 0; ///< index of a vertex
  std::uint32_t b = 0;
  int slab = PlanRegion::nothing;
};

/** @brief A room's plan cut into regions with one floor and one ceiling each.
 *
 * Edges have nothing in common but their ends, and around every vertex the regions
 * follow one another without contradiction, so that what is built from the edges fits
 * together without gaps. */
struct PlanSubdivision {
  PlanGrid grid;
  std::vector<GridPoint> vertices; ///< no two the same
  std::vector<SubdivisionEdge> edges;
  std::vector<SubdivisionCrease> creases;
  /// Slabs that cross at a vertex: there they have one height.
  std::map<std::uint32_t, std::pair<int, int>> crossings;

  Eigen::Vector2d placeOf(std::uint32_t vertex) const
  {
    return grid.toPlan(vertices[vertex]);
  }

  /** @brief The way from one vertex to another, grid units. */
  Eigen::Vector2d wayFrom(std::uint32_t from, std::uint32_t to) const
  {
    return Eigen::Vector2d(vertices[to].x, vertices[to].y) -
           Eigen::Vector2d(vertices[from].x, vertices[from].y);
  }

  /** @brief Takes out the edges with `is_dropped[e]` true; one entry an edge. */
  void dropEdges(const std::vector<bool>& is_dropped);
};

/** @brief An edge of a subdivision as it leaves a vertex. */
struct Spoke {
  std::uint32_t edge = 0;
  bool forward = true; ///< whether the vertex is the edge's a
  std::uint32_t end = 0;
  PlanRegion left; ///< the sector from this spoke to the next, counter-clockwise
  PlanRegion right;
};

/** @brief The spokes of every vertex, counter-clockwise. */
std::vector<std::vector<Spoke>> spokesOf(const PlanSubdivision& subdivision);

/** @brief What lies nearer together than this in a solid is one, metres: 0.05 mm, small
 * beside what a scan can tell, large beside the rounding of files with single
 * precision; more only in rooms so large that the grid is coarser. */
double solidSeparation(const PlanGrid& grid);

/** @brief Cuts the plan of a room at all its loops.
 *
 * - Loops are fitted to each other (facetLoops()), then cut exactly where they cross.
 * - Of what overlaps, columns win over the room and later details over earlier ones
 *   (RoomLayers::regionOf()); what leaves the boundary is cut off.
 * - A part of the plan narrower than 2 mm, or than its loops are sure to, goes to what
 *   is beside it.
 * - Details are left out where they leave less than 1 mm between floor and ceiling,
 *   niches that are not open to the room, and both where their floor is as high as the
 *   ceiling beside it.
 *
 * @param layers of a room whose coordinates are finite
 * @param parameters in range
 * @param[out] subdivision the result
 * @param[out] warnings what was done to contradictions of the plan, a sentence each
 * @return an empty string, or why there is none, a sentence */
std::string subdivideRoom(const RoomLayers& layers,
                          const SolidParameters& parameters,
                          PlanSubdivision& subdivision,
                          std::vector<std::string>& warnings);

} // namespace sedr
} // namespace pcl
