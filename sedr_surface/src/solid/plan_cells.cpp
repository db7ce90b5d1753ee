// SPDX-License-Identifier: BSD-3-Clause
#include "plan_cells.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

PlanCells::PlanCells(const RoomLayers& layers,
                     const PlanGrid& grid,
                     const Arrangement& arrangement,
                     const PlanTriangulation& triangulation,
                     const std::vector<SegmentSource>& sources,
                     const std::vector<double>& tolerance)
    : layers_(layers)
    , grid_(grid)
    , arrangement_(arrangement)
    , triangulation_(triangulation)
    , sources_(sources)
    , tolerance_(tolerance)
    , region_(triangulation.triangles.size())
{
  classify();
}

const Arrangement::Edge*
PlanCells::edgeAt(std::uint32_t t, std::size_t side) const
{
  const std::pair<std::uint32_t, std::uint32_t> ends =
      std::minmax(corner(t, side), corner(t, side + 1));
  const auto edge =
      std::lower_bound(arrangement_.edges.begin(), arrangement_.edges.end(), ends,
                       [](const Arrangement::Edge& e, const auto& wanted) {
                         return std::make_pair(e.a, e.b) < wanted;
                       });
  const bool is_edge = edge != arrangement_.edges.end() && edge->a == ends.first &&
                       edge->b == ends.second;
  return is_edge ? &*edge : nullptr;
}

void
PlanCells::classify()
{
  using Winding = std::vector<int>;
  const Winding outside(layers_.loops.size(), 0);
  std::vector<Winding> winding(region_.size());
  // Winding numbers inside a triangle's side, given those beyond it.
  const auto inside = [&](std::uint32_t t, std::size_t side, Winding beyond) {
    if (const Arrangement::Edge* edge = edgeAt(t, side))
      for (const SegmentUse& use : edge->uses) {
        if (sources_[use.segment].loop == SegmentSource::no_loop)
          continue;
        const bool is_left = use.forward == (corner(t, side) == edge->a);
        beyond[sources_[use.segment].loop] += is_left ? 1 : -1;
      }
    return beyond;
  };
  std::vector<std::uint32_t> waiting;
  const auto reach = [&](std::uint32_t t, Winding turns) {
    region_[t] = layers_.regionOf(turns);
    winding[t] = std::move(turns);
    waiting.push_back(t);
  };
  for (std::uint32_t t = 0; t < region_.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      if (triangulation_.neighbours[t][i] == none && winding[t].empty())
        reach(t, inside(t, i, outside));
  while (!waiting.empty()) {
    const std::uint32_t t = waiting.back();
    waiting.pop_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t n = triangulation_.neighbours[t][i];
      if (n == none || !winding[n].empty())
        continue;
      std::size_t back = 0;
      while (triangulation_.neighbours[n][back] != t)
        ++back;
      reach(n, inside(n, back, winding[t]));
    }
  }
}

PlanRegion
PlanCells::across(std::uint32_t t, std::size_t side) const
{
  const std::uint32_t n = triangulation_.neighbours[t][side];
  return n == none ? PlanRegion() : region_[n];
}

double
PlanCells::areaOf(std::uint32_t t) const
{
  const auto& points = arrangement_.vertices;
  return 0.5 * grid_.unit() * grid_.unit() *
         static_cast<double>(
             turn(points[corner(t, 0)], points[corner(t, 1)], points[corner(t, 2)]));
}

void
PlanCells::measure(Part& part, std::uint32_t t, std::size_t side) const
{
  const double length =
      grid_.unit() * distance(arrangement_.vertices[corner(t, side)],
                              arrangement_.vertices[corner(t, side + 1)]);
  part.perimeter += length;
  part.beside[across(t, side)] += length;
  if (triangulation_.neighbours[t][side] == none)
    part.is_outside = !part.region.isRoom();
  if (const Arrangement::Edge* edge = edgeAt(t, side))
    for (const SegmentUse& use : edge->uses)
      part.tolerance =
          std::max(part.tolerance, tolerance_[sources_[use.segment].element]);
}

template <typename Alike>
std::vector<PlanCells::Part>
PlanCells::partsOf(Alike alike) const
{
  std::vector<Part> parts;
  std::vector<bool> is_taken(region_.size(), false);
  for (std::uint32_t first = 0; first < region_.size(); ++first) {
    if (is_taken[first])
      continue;
    Part part;
    part.region = region_[first];
    part.triangles.push_back(first);
    is_taken[first] = true;
    for (std::size_t k = 0; k < part.triangles.size(); ++k) {
      const std::uint32_t t = part.triangles[k];
      part.area += areaOf(t);
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t n = triangulation_.neighbours[t][i];
        if (n == none || !alike(region_[t], region_[n]))
          measure(part, t, i);
        else if (!is_taken[n]) {
          is_taken[n] = true;
          part.triangles.push_back(n);
        }
      }
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

std::vector<PlanCells::Part>
PlanCells::regions() const
{
  return partsOf([](const PlanRegion& a, const PlanRegion& b) { return a == b; });
}

std::vector<PlanCells::Part>
PlanCells::roomPieces() const
{
  auto pieces = partsOf([](const PlanRegion& a, const PlanRegion& b) {
    return a.isRoom() == b.isRoom();
  });
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(),
                              [](const Part& part) { return !part.region.isRoom(); }),
               pieces.end());
  return pieces;
}

PlanRegion
PlanCells::heirOf(const Part& part)
{
  PlanRegion heir;
  double longest = 0;
  for (const auto& [region, length] : part.beside)
    if (region.isRoom() && length > longest) {
      heir = region;
      longest = length;
    }
  return heir;
}

/** @brief Returns the shorter side of the rectangle of the same area and perimeter. */
double
PlanCells::widthOf(const Part& part)
{
  const double sides = part.perimeter / 2;
  return (sides - std::sqrt(std::max(sides * sides - 4 * part.area, 0.0))) / 2;
}

void
PlanCells::assign(const Part& part, const PlanRegion& region)
{
  for (const std::uint32_t t : part.triangles)
    region_[t] = region;
}

void
PlanCells::mergeSlivers()
{
  // One by one, the narrowest first, since a merge widens the other part.
  for (;;) {
    const std::vector<Part> parts = regions();
    const Part* narrowest = nullptr;
    double least = 0;
    for (const Part& part : parts) {
      const double width = widthOf(part);
      if (part.is_outside || width >= part.tolerance)
        continue;
      if (narrowest != nullptr && width >= least)
        continue;
      narrowest = &part;
      least = width;
    }
    if (narrowest == nullptr)
      return;
    assign(*narrowest, heirOf(*narrowest));
  }
}

std::vector<SubdivisionEdge>
PlanCells::edges() const
{
  std::vector<SubdivisionEdge> edges;
  for (std::uint32_t t = 0; t < region_.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const PlanRegion beyond = across(t, i);
      const Arrangement::Edge* edge = edgeAt(t, i);
      const bool is_first = triangulation_.neighbours[t][i] == none ||
                            t < triangulation_.neighbours[t][i];
      if (edge == nullptr || beyond == region_[t] || !is_first)
        continue;
      SubdivisionEdge e{corner(t, i), corner(t, i + 1), region_[t], beyond, {}};
      for (const SegmentUse& use : edge->uses)
        if (sources_[use.segment].loop != SegmentSource::no_loop)
          e.elements.push_back(sources_[use.segment].element);
      std::sort(e.elements.begin(), e.elements.end());
      e.elements.erase(std::unique(e.elements.begin(), e.elements.end()),
                       e.elements.end());
      edges.push_back(std::move(e));
    }
  return edges;
}

std::vector<SubdivisionCrease>
PlanCells::creases() const
{
  std::vector<SubdivisionCrease> creases;
  for (std::uint32_t t = 0; t < region_.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t n = triangulation_.neighbours[t][i];
      const int slab = region_[t].ceiling;
      const Arrangement::Edge* edge = edgeAt(t, i);
      if (n == none || n < t || edge == nullptr || slab == PlanRegion::nothing ||
          region_[n] != region_[t])
        continue;
      const std::size_t element = layers_.slabs[static_cast<std::size_t>(slab)].element;
      if (std::any_of(edge->uses.begin(), edge->uses.end(), [&](const SegmentUse& use) {
            return sources_[use.segment].loop == SegmentSource::no_loop &&
                   sources_[use.segment].element == element;
          }))
        creases.push_back({corner(t, i), corner(t, i + 1), slab});
    }
  return creases;
}

} // namespace pcl::sedr
