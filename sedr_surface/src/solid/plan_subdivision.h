// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/plan_warning.h>

#include "../triangulation/plan_grid.h"
#include "room_layers.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr {

struct SolidParameters;

/** @brief A straight edge of a subdivision, with different regions on its sides. */
struct SubdivisionEdge {
  std::uint32_t a = 0; ///< index of a vertex
  std::uint32_t b = 0;
  PlanRegion left; ///< on the left from a to b
  PlanRegion right;
  std::vector<std::size_t> elements; ///< SolidElements of the plan on this edge
};

/** @brief A straight fold of a curved slab within a region. */
struct SubdivisionCrease {
  std::uint32_t a = 0; ///< index of a vertex
  std::uint32_t b = 0;
  int slab = PlanRegion::nothing;
};

/** @brief A room's plan divided into regions with one floor and one ceiling each.
 *
 * Edges meet only at their ends, and the regions around every vertex are consistent, so
 * that surfaces built from the edges fit together without gaps. */
struct PlanSubdivision {
  PlanGrid grid;
  std::vector<GridPoint> vertices; ///< all distinct
  std::vector<SubdivisionEdge> edges;
  std::vector<SubdivisionCrease> creases;
  /// Slabs that cross at a vertex, where they have the same height.
  std::map<std::uint32_t, std::pair<int, int>> crossings;

  Eigen::Vector2d placeOf(std::uint32_t vertex) const
  {
    return grid.toPlan(vertices[vertex]);
  }
};

/** @brief An edge of a subdivision, seen from one of its vertices. */
struct Spoke {
  std::uint32_t edge = 0;
  std::uint32_t end = 0;
  PlanRegion left; ///< the sector from this spoke to the next, counter-clockwise
  PlanRegion right;
};

/** @brief Returns the spokes of every vertex, counter-clockwise. */
std::vector<std::vector<Spoke>> spokesOf(const PlanSubdivision& subdivision);

/** @brief Returns the distance below which points of a solid are merged, metres. 0.05
 * mm: small against scans, large against rounding in single-precision files. Larger
 * only in rooms so large that the grid is coarser. */
double solidSeparation(const PlanGrid& grid);

/** @brief Divides the plan of a room along all its loops.
 *
 * - Loops are fitted to each other (facetLoops()), then cut exactly where they cross.
 * - Where they overlap, columns override the room and later details earlier ones
 *   (RoomLayers::regionOf()). Parts beyond the boundary are cut off.
 * - Slivers, narrower than 2 mm or than the tolerance of their loops, are merged into
 *   neighbours.
 * - Left out are details with less than 1 mm between floor and ceiling, niches closed
 *   to the room, and both where their floor meets a neighbour's ceiling.
 * - Where the solid would touch itself along a vertical line, such as at two details
 *   that meet in a corner, a square of 2 mm gets one region, a larger one if its angle
 * is sharp.
 *
 * @param layers of a room with finite coordinates
 * @param parameters in range
 * @param[out] subdivision the result
 * @param[out] warnings each contradiction of the plan that was resolved
 * @return an empty string, or a sentence on why there is no result */
std::string subdivideRoom(const RoomLayers& layers,
                          const SolidParameters& parameters,
                          PlanSubdivision& subdivision,
                          std::vector<PlanWarning>& warnings);

/** @brief Corners of facets, each with the elements of its facets. */
using FacetCorners = std::set<std::pair<std::size_t, GridPoint>>;

/** @brief Removes vertices within a facet at which no edge ends any more. They remain
 * where a loop's corner was fitted to the facet but merged into a neighbour.
 * @param corners of all facets, which are kept */
void dropNeedlessVertices(const FacetCorners& corners, PlanSubdivision& subdivision);

/** @brief Splits edges where the slabs of their two sides cross: the riser faces one
 * way before and the other way behind. */
void splitWhereHeightsCross(const RoomLayers& layers, PlanSubdivision& subdivision);

} // namespace pcl::sedr
