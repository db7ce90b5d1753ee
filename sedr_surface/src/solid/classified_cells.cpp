// SPDX-License-Identifier: BSD-3-Clause
#include "plan_cells.h"

#include <algorithm>
#include <utility>

namespace pcl::sedr {

ClassifiedCells::ClassifiedCells(const TriangulatedPlan& plan)
    : plan_(plan)
    , region_(plan.triangulation.triangles.size())
{
  classify();
}

void
ClassifiedCells::classify()
{
  using Winding = std::vector<int>;
  const Winding outside(plan_.layers.loops.size(), 0);
  std::vector<Winding> winding(region_.size());
  // Winding numbers inside a triangle's side, given those beyond it.
  const auto inside = [&](std::uint32_t t, std::size_t side, Winding beyond) {
    if (const Arrangement::Edge* edge = edgeAt(t, side))
      for (const SegmentUse& use : edge->uses) {
        if (plan_.sources[use.segment].loop == SegmentSource::no_loop)
          continue;
        const bool is_left = use.forward == (corner(t, side) == edge->a);
        beyond[plan_.sources[use.segment].loop] += is_left ? 1 : -1;
      }
    return beyond;
  };
  std::vector<std::uint32_t> waiting;
  const auto reach = [&](std::uint32_t t, Winding turns) {
    region_[t] = plan_.layers.regionOf(turns);
    winding[t] = std::move(turns);
    waiting.push_back(t);
  };
  for (std::uint32_t t = 0; t < region_.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      if (plan_.triangulation.neighbours[t][i] == none && winding[t].empty())
        reach(t, inside(t, i, outside));
  while (!waiting.empty()) {
    const std::uint32_t t = waiting.back();
    waiting.pop_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t n = plan_.triangulation.neighbours[t][i];
      if (n == none || !winding[n].empty())
        continue;
      std::size_t back = 0;
      while (plan_.triangulation.neighbours[n][back] != t)
        ++back;
      reach(n, inside(n, back, winding[t]));
    }
  }
}

PlanRegion
ClassifiedCells::across(std::uint32_t t, std::size_t side) const
{
  const std::uint32_t n = plan_.triangulation.neighbours[t][side];
  return n == none ? PlanRegion() : region_[n];
}

const Arrangement::Edge*
ClassifiedCells::edgeAt(std::uint32_t t, std::size_t side) const
{
  const std::pair<std::uint32_t, std::uint32_t> ends =
      std::minmax(corner(t, side), corner(t, side + 1));
  const auto edge =
      std::lower_bound(plan_.arrangement.edges.begin(), plan_.arrangement.edges.end(),
                       ends, [](const Arrangement::Edge& e, const auto& wanted) {
                         return std::make_pair(e.a, e.b) < wanted;
                       });
  const bool is_edge = edge != plan_.arrangement.edges.end() && edge->a == ends.first &&
                       edge->b == ends.second;
  return is_edge ? &*edge : nullptr;
}

double
ClassifiedCells::areaOf(std::uint32_t t) const
{
  const auto& points = plan_.arrangement.vertices;
  return 0.5 * plan_.grid.unit() * plan_.grid.unit() *
         static_cast<double>(
             turn(points[corner(t, 0)], points[corner(t, 1)], points[corner(t, 2)]));
}

double
ClassifiedCells::heightOf(int slab, std::uint32_t vertex) const
{
  return plan_.layers.slabs[static_cast<std::size_t>(slab)].slab.heightAt(
      plan_.grid.toPlan(plan_.arrangement.vertices[vertex]));
}

} // namespace pcl::sedr
