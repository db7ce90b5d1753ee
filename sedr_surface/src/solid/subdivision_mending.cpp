// SPDX-License-Identifier: BSD-3-Clause
#include "plan_subdivision.h"
#include "sedr_filters/src/grids/disjoint_sets.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pcl::sedr {
namespace {

/** @brief Smaller steps between two facets of a ceiling are ignored, metres. */
constexpr double facet_step = 0.002;

} // namespace

VertexLevels::VertexLevels(const RoomLayers& layers,
                           const PlanSubdivision& subdivision,
                           std::uint32_t vertex,
                           const std::vector<Spoke>& spokes)
{
  const Eigen::Vector2d place = subdivision.placeOf(vertex);
  const double unit = subdivision.grid.unit();
  const double separation = solidSeparation(subdivision.grid);
  const auto isFacet = [&](int slab) {
    return layers.slabs[static_cast<std::size_t>(slab)].is_facet;
  };
  // Borders of adjacent facets are accurate to some tenths of a millimetre.
  const auto sameFor = [&](int slab, int other) {
    return static_cast<std::int64_t>((isFacet(slab) && isFacet(other)
                                          ? std::max(separation, facet_step)
                                          : separation) /
                                     unit);
  };
  std::vector<std::pair<std::int64_t, int>> heights;
  for (const Spoke& spoke : spokes)
    for (const int slab : {spoke.left.floor, spoke.left.ceiling})
      if (slab != PlanRegion::nothing) {
        const PlanSlab& plane = layers.slabs[static_cast<std::size_t>(slab)].slab;
        heights.emplace_back(std::llround(plane.heightAt(place) / unit), slab);
      }
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  std::int64_t level = 0;
  int first = 0; // slab that defines the level
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const auto [height, slab] = heights[i];
    if (i == 0 || height - level >= sameFor(first, slab)) {
      level = height;
      first = slab;
    }
    of_slab_.emplace_back(slab, level);
  }
  const auto crossing = subdivision.crossings.find(vertex);
  if (crossing != subdivision.crossings.end())
    join(crossing->second.first, crossing->second.second);
  for (const auto& [slab, at] : of_slab_) {
    const bool ends_here =
        std::any_of(spokes.begin(), spokes.end(),
                    [s = slab](const Spoke& spoke) { return !spoke.left.has(s); });
    if (ends_here && (levels_.empty() || levels_.back() != at))
      levels_.push_back(at);
  }
}

void
VertexLevels::join(int slab, int other)
{
  const std::int64_t low = std::min(levelOf(slab), levelOf(other));
  const std::int64_t high = std::max(levelOf(slab), levelOf(other));
  for (auto& entry : of_slab_)
    if (entry.second >= low && entry.second <= high)
      entry.second = low;
}

std::int64_t
VertexLevels::levelOf(int slab, std::int64_t otherwise) const
{
  const auto found = std::find_if(of_slab_.begin(), of_slab_.end(),
                                  [slab](const auto& s) { return s.first == slab; });
  return found == of_slab_.end() ? otherwise : found->second;
}

std::vector<VertexLevels>
levelsOf(const RoomLayers& layers, const PlanSubdivision& plan)
{
  const auto spokes = spokesOf(plan);
  std::vector<VertexLevels> levels;
  for (std::uint32_t v = 0; v < spokes.size(); ++v)
    levels.emplace_back(layers, plan, v, spokes[v]);
  return levels;
}

namespace {

/** @brief Height range of the solid above a sector of a vertex. */
struct SolidSpan {
  std::int64_t low = 0;
  std::int64_t high = 0; ///< equal to low outside the room
};

/** @brief Returns the number of connected pieces of cells of one kind.
 * @param cells above a level, sector by sector around a line, then likewise below it */
std::size_t
piecesOf(const std::vector<bool>& cells, bool kind)
{
  const auto n = static_cast<std::uint32_t>(cells.size() / 2);
  DisjointSets<> sets(cells.size());
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    if (cells[a] == kind && cells[b] == kind)
      sets.join(a, b);
  };
  for (std::uint32_t sector = 0; sector < n; ++sector) {
    const std::uint32_t next = (sector + 1) % n;
    join(sector, next);
    join(n + sector, n + next);
    join(sector, n + sector);
  }
  std::size_t pieces = 0;
  for (std::uint32_t cell = 0; cell < 2 * n; ++cell)
    pieces += cells[cell] == kind && sets.find(cell) == cell ? 1 : 0;
  return pieces;
}

/** @param sectors counter-clockwise */
bool
touchesItself(const std::vector<SolidSpan>& sectors)
{
  const std::size_t n = sectors.size();
  std::vector<bool> is_solid(2 * n); // above a level, then below it
  for (const SolidSpan& at : sectors)
    for (const std::int64_t level : {at.low, at.high}) {
      for (std::size_t s = 0; s < n; ++s) {
        is_solid[s] = sectors[s].low <= level && level < sectors[s].high;
        is_solid[n + s] = sectors[s].low < level && level <= sectors[s].high;
      }
      if (piecesOf(is_solid, true) > 1 || piecesOf(is_solid, false) > 1)
        return true;
    }
  return false;
}

} // namespace

std::vector<GridPoint>
touchingVertices(const RoomLayers& layers, const PlanSubdivision& plan)
{
  std::vector<GridPoint> touching;
  const auto spokes = spokesOf(plan);
  for (std::uint32_t v = 0; v < spokes.size(); ++v) {
    if (spokes[v].size() <= 2)
      continue;
    const VertexLevels levels(layers, plan, v, spokes[v]);
    std::vector<SolidSpan> spans;
    for (const Spoke& spoke : spokes[v])
      spans.push_back(spoke.left.isRoom()
                          ? SolidSpan{levels.levelOf(spoke.left.floor),
                                      levels.levelOf(spoke.left.ceiling)}
                          : SolidSpan());
    if (touchesItself(spans))
      touching.push_back(plan.vertices[v]);
  }
  return touching;
}

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

void
splitWhereHeightsCross(const RoomLayers& layers, PlanSubdivision& plan)
{
  std::vector<VertexLevels> levels = levelsOf(layers, plan); // that will be built
  // Splits an edge where two slabs cross, if they do.
  const auto cutAt = [&](std::size_t e, int slab, int other) {
    const SubdivisionEdge edge = plan.edges[e];
    const auto heightOver = [&](std::uint32_t v) {
      return static_cast<double>(levels[v].levelOf(slab) - levels[v].levelOf(other));
    };
    const double at_a = heightOver(edge.a);
    const double at_b = heightOver(edge.b);
    if (!(at_a < 0 && at_b > 0) && !(at_a > 0 && at_b < 0))
      return false;
    const double share = at_a / (at_a - at_b);
    const GridPoint place = plan.grid.toGrid(plan.placeOf(edge.a) * (1 - share) +
                                             plan.placeOf(edge.b) * share);
    if (place == plan.vertices[edge.a] || place == plan.vertices[edge.b])
      return false;
    const auto middle = static_cast<std::uint32_t>(plan.vertices.size());
    plan.vertices.push_back(place);
    plan.crossings[middle] = {slab, other};
    plan.edges.push_back(edge);
    plan.edges[e].b = plan.edges.back().a = middle;
    levels.emplace_back(
        layers, plan, middle,
        std::vector<Spoke>{{0, 0, edge.left, {}}, {0, 0, edge.right, {}}});
    return true;
  };
  const auto cutOnce = [&](std::size_t e) {
    const SubdivisionEdge edge = plan.edges[e];
    for (const int slab : {edge.left.floor, edge.left.ceiling})
      for (const int other : {edge.right.floor, edge.right.ceiling})
        if (slab != PlanRegion::nothing && other != PlanRegion::nothing &&
            cutAt(e, slab, other))
          return true;
    return false;
  };
  // Cut-off parts of edges are appended and visited later.
  for (std::size_t e = 0; e < plan.edges.size(); ++e)
    while (cutOnce(e))
      continue;
}

} // namespace pcl::sedr
