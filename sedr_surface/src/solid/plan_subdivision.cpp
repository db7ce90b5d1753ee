// SPDX-License-Identifier: BSD-3-Clause
#include "plan_cells.h"
#include "subdivision_mending.h"
#include "visible_creases.h"

#include <pcl/sedr_surface/room_solid.h>

#include <algorithm>

namespace pcl::sedr {

namespace {

PlanGrid
gridOf(const std::vector<FacetChain>& chains)
{
  Eigen::AlignedBox2d bounds;
  for (const FacetChain& chain : chains)
    for (const Eigen::Vector2d& corner : chain.corners)
      bounds.extend(corner);
  return bounds.isEmpty() ? PlanGrid() : PlanGrid(bounds);
}

void
collectSegments(const std::vector<FacetChain>& chains,
                const PlanGrid& grid,
                std::vector<GridSegment>& segments,
                std::vector<SegmentSource>& sources)
{
  for (std::size_t l = 0; l < chains.size(); ++l) {
    const auto& corners = chains[l].corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      segments.push_back(
          {grid.toGrid(corners[i]), grid.toGrid(corners[(i + 1) % corners.size()])});
      sources.push_back({l, chains[l].elements[i]});
    }
  }
}

/** @brief Adds the creases of curved slabs. */
void
collectCreases(const RoomLayers& layers,
               const std::vector<FacetChain>& chains,
               const PlanGrid& grid,
               double tolerance,
               std::vector<GridSegment>& segments,
               std::vector<SegmentSource>& sources)
{
  const VisibleCreases creases(layers, chains);
  for (std::size_t slab = 0; slab < layers.slabs.size(); ++slab)
    for (const auto& [from, to] : creases.of(slab, tolerance)) {
      segments.push_back({grid.toGrid(from), grid.toGrid(to)});
      sources.push_back({SegmentSource::no_loop, layers.slabs[slab].element});
    }
}

FacetCorners
cornersOf(const std::vector<GridSegment>& segments,
          const std::vector<SegmentSource>& sources)
{
  FacetCorners corners;
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (const GridPoint& end : {segments[i].from, segments[i].to})
      if (sources[i].loop != SegmentSource::no_loop)
        corners.insert({sources[i].element, end});
  return corners;
}

std::vector<double>
tolerancesOf(const RoomLayers& layers, double fixed)
{
  std::vector<double> tolerances(layers.elements.size(), 0);
  for (const auto& loop : layers.loops)
    for (std::size_t i = 0; i < loop.loop->elements.size(); ++i)
      tolerances[loop.first_element + i] = snapTolerance(loop.loop->elements[i], fixed);
  return tolerances;
}

/** @brief Returns whether a direction lies in the half plane from east to just before
 * west. */
bool
isUpper(const GridPoint& from, const GridPoint& to)
{
  return to.y != from.y ? to.y > from.y : to.x > from.x;
}

} // namespace

double
solidSeparation(const PlanGrid& grid)
{
  constexpr double separation = 5e-5;
  return std::max(separation, 4 * grid.unit());
}

void
PlanSubdivision::dropEdges(const std::vector<bool>& is_dropped)
{
  std::size_t kept = 0;
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (!is_dropped[e])
      edges[kept++] = edges[e];
  edges.resize(kept);
}

std::vector<std::vector<Spoke>>
spokesOf(const PlanSubdivision& plan)
{
  std::vector<std::vector<Spoke>> spokes(plan.vertices.size());
  for (std::uint32_t e = 0; e < plan.edges.size(); ++e) {
    const SubdivisionEdge& edge = plan.edges[e];
    spokes[edge.a].push_back({e, true, edge.b, edge.left, edge.right});
    spokes[edge.b].push_back({e, false, edge.a, edge.right, edge.left});
  }
  for (std::uint32_t v = 0; v < spokes.size(); ++v) {
    const GridPoint& centre = plan.vertices[v];
    std::sort(spokes[v].begin(), spokes[v].end(), [&](const Spoke& s, const Spoke& t) {
      const GridPoint& a = plan.vertices[s.end];
      const GridPoint& b = plan.vertices[t.end];
      const bool a_is_upper = isUpper(centre, a);
      if (a_is_upper != isUpper(centre, b))
        return a_is_upper;
      return turn(centre, a, b) > 0;
    });
  }
  return spokes;
}

std::string
subdivideRoom(const RoomLayers& layers,
              const SolidParameters& parameters,
              PlanSubdivision& subdivision,
              std::vector<PlanWarning>& warnings)
{
  subdivision = PlanSubdivision();
  const auto chains =
      facetLoops(layers, parameters.chord_tolerance, parameters.snap_tolerance);
  for (std::size_t l = 0; l < chains.size(); ++l)
    if (chains[l].corners.empty())
      warnings.push_back({WarningKind::Contradiction,
                          {},
                          0,
                          0,
                          layers.elements[layers.loops[l].first_element].name +
                              " and the rest of its loop are too small and left out"});
  subdivision.grid = gridOf(chains);
  std::vector<GridSegment> segments;
  std::vector<SegmentSource> sources;
  collectSegments(chains, subdivision.grid, segments, sources);
  collectCreases(layers, chains, subdivision.grid, parameters.chord_tolerance, segments,
                 sources);

  Arrangement arrangement;
  arrangeSegments(segments, solidSeparation(subdivision.grid) / subdivision.grid.unit(),
                  arrangement);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
  for (const auto& edge : arrangement.edges)
    ends.emplace_back(edge.a, edge.b);
  PlanTriangulation triangulation;
  if (!triangulateConstrained(arrangement.vertices, ends, triangulation))
    return "its plan of " + std::to_string(ends.size()) +
           " edges could not be triangulated";

  const std::vector<double> tolerances =
      tolerancesOf(layers, parameters.snap_tolerance);
  PlanCells cells(layers, subdivision.grid, arrangement, triangulation, sources,
                  tolerances);
  cells.mergeSlivers();
  cells.dropUnbuildable(warnings);
  cells.checkPieces(warnings);
  subdivision.vertices = arrangement.vertices;
  subdivision.edges = cells.edges();
  subdivision.creases = cells.creases();
  if (subdivision.edges.empty())
    return "its plan encloses no room";

  dropNeedlessVertices(cornersOf(segments, sources), subdivision);
  splitWhereHeightsCross(layers, subdivision);
  const std::size_t cuts = cutTouchingCorners(layers, subdivision);
  // Cutting corners may change heights that coincided.
  if (cuts > 0)
    splitWhereHeightsCross(layers, subdivision);
  if (cuts > 0)
    warnings.push_back(
        {WarningKind::Contradiction,
         {},
         0,
         0,
         std::to_string(cuts) +
             (cuts == 1 ? " corner that touches another is cut off by 1 mm"
                        : " corners that touch others are cut off by 1 mm")});
  return {};
}

} // namespace pcl::sedr
