// SPDX-License-Identifier: BSD-3-Clause
#include "plan_subdivision.h"

#include "vertex_levels.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pcl::sedr {

namespace {

/** @brief Returns the elements on both of two edges. */
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
dropNeedlessVertices(const FacetCorners& corners, PlanSubdivision& plan)
{
  constexpr double straight = 4; // grid units, for rounding
  auto spokes = spokesOf(plan);
  std::vector<bool> is_dropped(plan.edges.size(), false);
  std::vector<bool> is_creased(plan.vertices.size(), false);
  for (const SubdivisionCrease& crease : plan.creases)
    is_creased[crease.a] = is_creased[crease.b] = true;
  for (std::uint32_t v = 0; v < plan.vertices.size(); ++v) {
    if (spokes[v].size() != 2 || is_creased[v])
      continue;
    const Spoke in = spokes[v][0];
    const Spoke out = spokes[v][1];
    auto common = commonElements(plan.edges[in.edge], plan.edges[out.edge]);
    common.erase(std::remove_if(common.begin(), common.end(),
                                [&](std::size_t element) {
                                  return corners.count({element, plan.vertices[v]}) > 0;
                                }),
                 common.end());
    const bool is_double =
        std::any_of(spokes[in.end].begin(), spokes[in.end].end(),
                    [&out](const Spoke& spoke) { return spoke.end == out.end; });
    const GridPoint& here = plan.vertices[v];
    const GridPoint& before = plan.vertices[in.end];
    const GridPoint& after = plan.vertices[out.end];
    const double length = distance(before, after);
    const auto off = static_cast<double>(turn(before, after, here));
    const bool is_between = way(here, before).dot(way(here, after)) < 0;
    if (common.empty() || is_double || !is_between || std::abs(off) > straight * length)
      continue;
    // The first edge is extended to the end of the second and keeps its sides.
    plan.edges[in.edge] = {in.end, out.end, in.right, in.left, common};
    is_dropped[out.edge] = true;
    for (const auto& [vertex, other] :
         {std::make_pair(in.end, out.end), std::make_pair(out.end, in.end)})
      for (Spoke& spoke : spokes[vertex])
        if (spoke.edge == in.edge || spoke.edge == out.edge) {
          spoke.edge = in.edge;
          spoke.end = other;
        }
  }
  std::vector<SubdivisionEdge> kept;
  for (std::size_t e = 0; e < plan.edges.size(); ++e)
    if (!is_dropped[e])
      kept.push_back(plan.edges[e]);
  plan.edges.swap(kept);
}

namespace {

/** @brief Splits edges where heights cross, judged by the levels that will be built. */
class CrossingCutter {
public:
  CrossingCutter(const RoomLayers& layers, PlanSubdivision& plan)
      : layers_(layers)
      , plan_(plan)
      , levels_(levelsOf(layers, plan))
  {}

  void run()
  {
    // Cut-off parts of edges are appended and visited later.
    for (std::size_t e = 0; e < plan_.edges.size(); ++e)
      while (cutOnce(e))
        continue;
  }

private:
  bool cutOnce(std::size_t e)
  {
    const SubdivisionEdge edge = plan_.edges[e];
    for (const int slab : {edge.left.floor, edge.left.ceiling})
      for (const int other : {edge.right.floor, edge.right.ceiling})
        if (slab != PlanRegion::nothing && other != PlanRegion::nothing &&
            cutAt(e, slab, other))
          return true;
    return false;
  }

  /** @brief Splits an edge where two slabs cross, if they do. */
  bool cutAt(std::size_t e, int slab, int other)
  {
    const SubdivisionEdge edge = plan_.edges[e];
    const auto heightOver = [&](std::uint32_t v) {
      return static_cast<double>(levels_[v].levelOf(slab) - levels_[v].levelOf(other));
    };
    const double at_a = heightOver(edge.a);
    const double at_b = heightOver(edge.b);
    if (!(at_a < 0 && at_b > 0) && !(at_a > 0 && at_b < 0))
      return false;
    const double share = at_a / (at_a - at_b);
    const GridPoint place = plan_.grid.toGrid(plan_.placeOf(edge.a) * (1 - share) +
                                              plan_.placeOf(edge.b) * share);
    if (place == plan_.vertices[edge.a] || place == plan_.vertices[edge.b])
      return false;
    const auto middle = static_cast<std::uint32_t>(plan_.vertices.size());
    plan_.vertices.push_back(place);
    plan_.crossings[middle] = {slab, other};
    plan_.edges.push_back(edge);
    plan_.edges[e].b = plan_.edges.back().a = middle;
    Spoke ahead;
    ahead.left = edge.left;
    Spoke back;
    back.left = edge.right;
    levels_.emplace_back(layers_, plan_, middle, std::vector<Spoke>{ahead, back});
    return true;
  }

  const RoomLayers& layers_;
  PlanSubdivision& plan_;
  std::vector<VertexLevels> levels_;
};

} // namespace

void
splitWhereHeightsCross(const RoomLayers& layers, PlanSubdivision& plan)
{
  CrossingCutter(layers, plan).run();
}

} // namespace pcl::sedr
