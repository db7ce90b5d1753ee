// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../triangulation/triangulation.h"
#include "room_layers.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/plan_warning.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

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

/** @brief A loop of a plan as straight facets. */
struct FacetChain {
  std::vector<Eigen::Vector2d> corners; ///< metres; the last is followed by the first
  std::vector<std::size_t> elements;    ///< SolidElement of the facet after each corner
};

/** @brief Returns the snap distance, metres: twice the residual of the plan's element,
 * 2 mm to 5 cm. */
double snapTolerance(const PlanElement& element);

/** @brief Converts the loops of a room to facets, one chain per loop, arcs within
 * `chord_tolerance` metres.
 *
 * Noise makes loops of a fitted plan miss shared edges and corners. Each loop is fitted
 * to the previous ones, so that walls stay in place. A corner snaps to a corner within
 * tolerance, else to an edge. The tolerance is the larger one of the two elements. A
 * chain that shrinks below three corners becomes empty. O(n^2) in the facets, a box
 * each unless near. */
std::vector<FacetChain> facetLoops(const RoomLayers& layers, double chord_tolerance);

/** @brief A straight line in plan along which a curved slab is folded. */
using Crease = std::pair<Eigen::Vector2d, Eigen::Vector2d>;

/** @brief Returns the lines in plan that divide a curve into flat pieces within a
 * tolerance: parallels to the axis of a cylinder, rings and rays of a dome, the grid of
 * a relief.
 * @param bounds of the curved area in plan, metres, not empty; creases reach slightly
 * farther
 * @param tolerance metres, above 0 */
std::vector<Crease>
creasesOf(const SlabCurve& curve, const Eigen::AlignedBox2d& bounds, double tolerance);

/** @brief Heights of the floors and ceilings that meet at a vertex of a subdivision,
 * grid units. Heights that cross there or differ by less than solidSeparation() are
 * merged. */
class VertexLevels {
public:
  /** @param spokes of the vertex */
  VertexLevels(const RoomLayers& layers,
               const PlanSubdivision& subdivision,
               std::uint32_t vertex,
               const std::vector<Spoke>& spokes);

  /** @brief Returns the level of a slab at the vertex; `otherwise` if no region there
   * has the slab. */
  std::int64_t levelOf(int slab, std::int64_t otherwise = 0) const;

  /** @brief Returns the distinct levels of slabs that end here, increasing. */
  const std::vector<std::int64_t>& levels() const { return levels_; }

private:
  /** @brief Merges the levels of two slabs and all between them. */
  void join(int slab, int other);

  std::vector<std::pair<int, std::int64_t>> of_slab_;
  std::vector<std::int64_t> levels_;
};

/** @brief Returns the levels at every vertex. */
std::vector<VertexLevels> levelsOf(const RoomLayers& layers,
                                   const PlanSubdivision& subdivision);

/** @brief Returns the vertices at which the solid touches itself along a vertical line:
 * its surface is not manifold there. */
std::vector<GridPoint> touchingVertices(const RoomLayers& layers,
                                        const PlanSubdivision& subdivision);

/** @brief Origin of a segment of an arrangement. */
struct SegmentSource {
  static constexpr std::size_t no_loop = static_cast<std::size_t>(-1);

  std::size_t loop = 0;    ///< index of RoomLayers::loops; no_loop for others
  std::size_t element = 0; ///< of RoomLayers::elements; for a crease, its slab's
};

/** @brief A square in plan, grid units, whose sides are segments of the arrangement. */
struct PlanSquare {
  GridPoint middle;
  std::int32_t half = 0; ///< of a side
};

/** @brief A room's plan, divided along segments and triangulated. */
struct TriangulatedPlan {
  const RoomLayers& layers;
  PlanGrid grid;
  std::vector<double> tolerance; ///< of each SolidElement, metres: parts narrower
                                 ///< than that of the elements around are slivers
  std::vector<SegmentSource> sources{}; ///< of each segment
  std::vector<PlanSquare> squares{};    ///< each gets the region that most of it has
  Arrangement arrangement{};            ///< of the segments
  PlanTriangulation triangulation{};    ///< its edges are sides of triangles

  std::uint32_t corner(std::uint32_t t, std::size_t i) const
  {
    return triangulation.triangles[t][i % 3];
  }

  double areaOf(std::uint32_t t) const
  {
    const auto& points = arrangement.vertices;
    return 0.5 * grid.unit() * grid.unit() *
           static_cast<double>(
               turn(points[corner(t, 0)], points[corner(t, 1)], points[corner(t, 2)]));
  }

  double heightOf(int slab, std::uint32_t vertex) const
  {
    return layers.slabs[static_cast<std::size_t>(slab)].slab.heightAt(
        grid.toPlan(arrangement.vertices[vertex]));
  }

  /** @brief Returns the segments on a triangle's side; empty if it is no edge. */
  const std::vector<SegmentUse>& usesAt(std::uint32_t t, std::size_t side) const
  {
    static const std::vector<SegmentUse> no_edge;
    const std::pair<std::uint32_t, std::uint32_t> ends =
        std::minmax(corner(t, side), corner(t, side + 1));
    const auto& edges = arrangement.edges;
    const auto edge = std::lower_bound(edges.begin(), edges.end(), ends,
                                       [](const auto& e, const auto& wanted) {
                                         return std::make_pair(e.a, e.b) < wanted;
                                       });
    return edge != edges.end() && std::make_pair(edge->a, edge->b) == ends ? edge->uses
                                                                           : no_edge;
  }
};

/** @brief Divides a triangulated plan into regions, and replaces those that cannot be
 * built, see subdivideRoom().
 * @param[out] subdivision gets vertices, edges and creases
 * @param[out] warnings of larger pieces and of details that are removed */
void findRegions(const TriangulatedPlan& plan,
                 PlanSubdivision& subdivision,
                 std::vector<PlanWarning>& warnings);

} // namespace pcl::sedr
