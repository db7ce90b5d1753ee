// SPDX-License-Identifier: BSD-3-Clause
#include "subdivision_mending.h"

#include <pcl/sedr_surface/vertex_levels.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace pcl {
namespace sedr {

namespace {

/** @brief Elements that lie on both of two edges. */
std::vector<std::size_t>
commonElements(const SubdivisionEdge& e, const SubdivisionEdge& f)
{
  std::vector<std::size_t> common;
  std::set_intersection(e.elements.begin(), e.elements.end(), f.elements.begin(),
                        f.elements.end(), std::back_inserter(common));
  return common;
}

} // namespace

void
dropNeedlessVertices(PlanSubdivision& plan)
{
  constexpr double straight = 4; // grid units: what rounding leaves
  auto spokes = spokesOf(plan);
  std::vector<bool> is_dropped(plan.edges.size(), false);
  for (std::uint32_t v = 0; v < plan.vertices.size(); ++v) {
    if (spokes[v].size() != 2)
      continue;
    const Spoke in = spokes[v][0];
    const Spoke out = spokes[v][1];
    const auto common = commonElements(plan.edges[in.edge], plan.edges[out.edge]);
    const double length = distance(plan.vertices[in.end], plan.vertices[out.end]);
    const auto off = static_cast<double>(
        turn(plan.vertices[in.end], plan.vertices[out.end], plan.vertices[v]));
    const bool is_between = plan.wayFrom(v, in.end).dot(plan.wayFrom(v, out.end)) < 0;
    if (common.empty() || !is_between || std::abs(off) > straight * length)
      continue;
    // The first edge goes on to where the second ends; what was on the left of the way
    // to v stays there.
    plan.edges[in.edge] = {in.end, out.end, in.right, in.left, common};
    is_dropped[out.edge] = true;
    for (const auto& [vertex, other] :
         {std::make_pair(in.end, out.end), std::make_pair(out.end, in.end)})
      for (Spoke& spoke : spokes[vertex])
        if (spoke.edge == in.edge || spoke.edge == out.edge) {
          spoke.edge = in.edge;
          spoke.forward = vertex == in.end;
          spoke.end = other;
        }
  }
  plan.dropEdges(is_dropped);
}

namespace {

/** @brief Where along an edge, from 0 to 1, two slabs have one height; negative if they
 * have not or do at an end. */
double
crossingOf(const RoomLayers& layers,
           const PlanSubdivision& plan,
           const SubdivisionEdge& edge,
           int slab,
           int other)
{
  if (slab == other || slab == PlanRegion::nothing || other == PlanRegion::nothing)
    return -1;
  const auto heightOver = [&](std::uint32_t v) {
    const Eigen::Vector2d p = plan.placeOf(v);
    return layers.slabs[static_cast<std::size_t>(slab)].slab.heightAt(p) -
           layers.slabs[static_cast<std::size_t>(other)].slab.heightAt(p);
  };
  const double at_a = heightOver(edge.a);
  const double at_b = heightOver(edge.b);
  const double same = solidSeparation(plan.grid);
  const bool crosses = std::min(at_a, at_b) < -same && std::max(at_a, at_b) > same;
  return crosses ? at_a / (at_a - at_b) : -1;
}

/** @brief Cuts an edge at a share of its length; the second part is added.
 * @return whether there is a grid point between its ends */
bool
cutEdge(PlanSubdivision& plan, std::size_t e, double share)
{
  SubdivisionEdge& first = plan.edges[e];
  const GridPoint middle = plan.grid.toGrid(plan.placeOf(first.a) * (1 - share) +
                                            plan.placeOf(first.b) * share);
  if (middle == plan.vertices[first.a] || middle == plan.vertices[first.b])
    return false;
  SubdivisionEdge second = first;
  first.b = second.a = static_cast<std::uint32_t>(plan.vertices.size());
  plan.vertices.push_back(middle);
  plan.edges.push_back(std::move(second));
  return true;
}

} // namespace

void
splitWhereHeightsCross(const RoomLayers& layers, PlanSubdivision& plan)
{
  for (std::size_t e = 0; e < plan.edges.size(); ++e) {
    bool is_cut = true;
    while (is_cut) {
      is_cut = false;
      const SubdivisionEdge edge = plan.edges[e];
      for (const int slab : {edge.left.floor, edge.left.ceiling})
        for (const int other : {edge.right.floor, edge.right.ceiling}) {
          const double share = crossingOf(layers, plan, edge, slab, other);
          if (!is_cut && share > 0)
            is_cut = cutEdge(plan, e, share);
        }
    }
  }
}

} // namespace sedr
} // namespace pcl
