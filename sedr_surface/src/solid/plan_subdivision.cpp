// SPDX-License-Identifier: BSD-3-Clause
#include "plan_subdivision.h"
#include "room_layers.h"

#include "sedr_filters/src/base/number_text.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

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

std::vector<double>
tolerancesOf(const RoomLayers& layers)
{
  std::vector<double> tolerances(layers.elements.size(), 0);
  for (const auto& loop : layers.loops)
    for (std::size_t i = 0; i < loop.loop->elements.size(); ++i)
      tolerances[loop.first_element + i] = snapTolerance(loop.loop->elements[i]);
  return tolerances;
}

/** @brief Divides a plan along its loops and the creases of its slabs, and around
 * squares; see subdivideRoom(). */
class PlanDivider {
public:
  PlanDivider(const RoomLayers& layers,
              const SolidParameters& parameters,
              const std::vector<FacetChain>& chains)
      : plan_{layers, gridOf(chains), tolerancesOf(layers)}
  {
    for (std::size_t l = 0; l < chains.size(); ++l) {
      const auto& corners = chains[l].corners;
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const SegmentSource source{l, chains[l].elements[i]};
        add(plan_.grid.toGrid(corners[i]),
            plan_.grid.toGrid(corners[(i + 1) % corners.size()]), source);
        corners_.insert({source.element, segments_.back().from});
        corners_.insert({source.element, segments_.back().to});
      }
    }
    for (const RoomLayers::Slab& slab : layers.slabs)
      if (slab.slab.curve)
        addCreases(slab, chains, parameters.chord_tolerance);
  }

  /** @brief Gives a square in plan one region. */
  void addSquare(const PlanSquare& square)
  {
    const auto corner = [&](std::int32_t x, std::int32_t y) -> GridPoint {
      return {square.middle.x + x * square.half, square.middle.y + y * square.half};
    };
    const std::array<GridPoint, 4> corners{corner(-1, -1), corner(1, -1), corner(1, 1),
                                           corner(-1, 1)};
    for (std::size_t k = 0; k < 4; ++k)
      add(corners[k], corners[(k + 1) % 4], {SegmentSource::no_loop, 0});
    plan_.squares.push_back(square);
  }

  /** @return an empty string, or a sentence on why there is no result */
  std::string divide(PlanSubdivision& subdivision, std::vector<PlanWarning>& warnings)
  {
    subdivision = PlanSubdivision();
    subdivision.grid = plan_.grid;
    arrangeSegments(segments_, solidSeparation(plan_.grid) / plan_.grid.unit(),
                    plan_.arrangement);
    PlanEdges ends;
    for (const auto& edge : plan_.arrangement.edges)
      ends.emplace_back(edge.a, edge.b);
    if (!triangulateConstrained(plan_.arrangement.vertices, ends, plan_.triangulation))
      return "its plan of " + std::to_string(ends.size()) +
             " edges could not be triangulated";
    findRegions(plan_, subdivision, warnings);
    if (subdivision.edges.empty())
      return "its plan encloses no room";
    dropNeedlessVertices(corners_, subdivision);
    splitWhereHeightsCross(plan_.layers, subdivision);
    return {};
  }

private:
  void add(const GridPoint& from, const GridPoint& to, const SegmentSource& source)
  {
    segments_.push_back({from, to});
    plan_.sources.push_back(source);
  }

  /** @brief Adds the creases of a curved slab, also where another slab replaces it:
   * there they divide no region.
   * @param tolerance of the flat pieces, metres, above 0 */
  void addCreases(const RoomLayers::Slab& slab,
                  const std::vector<FacetChain>& chains,
                  double tolerance)
  {
    Eigen::AlignedBox2d bounds;
    for (std::size_t l = 0; l < chains.size(); ++l)
      if (plan_.layers.loops[l].loop == slab.loop)
        for (const Eigen::Vector2d& corner : chains[l].corners)
          bounds.extend(corner);
    if (bounds.isEmpty())
      return;
    for (const auto& [from, to] : creasesOf(*slab.slab.curve, bounds, tolerance))
      add(plan_.grid.toGrid(from), plan_.grid.toGrid(to),
          {SegmentSource::no_loop, slab.element});
  }

  TriangulatedPlan plan_;
  std::vector<GridSegment> segments_;
  FacetCorners corners_;
};

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

std::vector<std::vector<Spoke>>
spokesOf(const PlanSubdivision& plan)
{
  std::vector<std::vector<Spoke>> spokes(plan.vertices.size());
  for (std::uint32_t e = 0; e < plan.edges.size(); ++e) {
    const SubdivisionEdge& edge = plan.edges[e];
    spokes[edge.a].push_back({e, edge.b, edge.left, edge.right});
    spokes[edge.b].push_back({e, edge.a, edge.right, edge.left});
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
  const auto chains = facetLoops(layers, parameters.chord_tolerance);
  for (std::size_t l = 0; l < chains.size(); ++l)
    if (chains[l].corners.empty())
      warnings.push_back(warningOf(WarningKind::Contradiction,
                                   layers.wordsOf(layers.loops[l].first_element) +
                                       " is too small and left out"));
  PlanDivider divider(layers, parameters, chains);
  std::size_t corners_cut = 0;
  double widest = 0; // metres from a corner
  for (int round = 0;; ++round) {
    std::vector<PlanWarning> found;
    const std::string problem = divider.divide(subdivision, found);
    if (!problem.empty())
      return problem;
    const auto touching = touchingVertices(layers, subdivision);
    if (touching.empty() || round == 8) {
      warnings.insert(warnings.end(), found.begin(), found.end());
      break;
    }
    // About a millimetre; more where the angle is so sharp that its sides would merge.
    const auto half = static_cast<std::int32_t>(std::ldexp(
        20 * solidSeparation(subdivision.grid) / subdivision.grid.unit(), round));
    corners_cut = std::max(corners_cut, touching.size());
    widest = half * subdivision.grid.unit();
    for (const GridPoint& middle : touching)
      divider.addSquare({middle, half});
  }
  if (constexpr double worth_telling = 0.01; widest > worth_telling) // metres
    warnings.push_back(warningOf(
        WarningKind::Contradiction,
        std::to_string(corners_cut) +
            (corners_cut == 1 ? " corner that touches another is cut off by up to "
                              : " corners that touch others are cut off by up to ") +
            numberText(std::ceil(1e3 * widest)) + " mm"));
  return {};
}

} // namespace pcl::sedr
