// SPDX-License-Identifier: BSD-3-Clause
#include "vertex_levels.h"

#include "sedr_filters/src/grids/disjoint_sets.h"

#include <algorithm>
#include <cmath>

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

} // namespace pcl::sedr
