// SPDX-License-Identifier: BSD-3-Clause
#include "level_candidates.h"

#include "../profiles/ceiling_gap.h"
#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/parallel_for.h"
#include "sedr_filters/src/base/plane_fit.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace pcl::sedr {

CellSet
markedCells(const CellSet& cells, const std::vector<std::uint8_t>& marked)
{
  std::vector<CellKey> keys;
  for (std::size_t i = 0; i < marked.size(); ++i)
    if (marked[i])
      keys.push_back(cells.keys()[i]);
  return CellSet::fromSorted(std::move(keys));
}

CellBlock
blockAround(const CellSet& cells, std::size_t at)
{
  CellBlock block;
  const Cell middle = cells[at];
  const auto addRow = [&](std::size_t first, std::int32_t y) {
    const CellKey last = keyOf({middle.x + 1, y});
    for (std::size_t i = first; i < cells.size() && cells.keys()[i] <= last; ++i)
      block.add(i);
  };
  const bool is_before = at > 0 && cells[at - 1] == Cell{middle.x - 1, middle.y};
  addRow(cells.firstFrom({middle.x - 1, middle.y - 1}), middle.y - 1);
  addRow(is_before ? at - 1 : at, middle.y);
  addRow(cells.firstFrom({middle.x - 1, middle.y + 1}), middle.y + 1);
  return block;
}

StretchesNear::StretchesNear(const LevelColumns& columns,
                             const PlanSlab& slab,
                             double low,
                             double high)
    : columns_(columns)
    , slab_(slab)
    , rise_(slab.plane.head<2>().norm() / slab.plane[2] * columns.grid().size())
    , low_(low / slab.plane[2])
    , high_(high / slab.plane[2])
{}

ColumnStretch
StretchesNear::operator()(std::size_t cell) const
{
  const double height = slab_.heightAt(columns_.grid().centre(columns_.cells()[cell]));
  const double from = height + low_ - rise_ - same_corner;
  const double to = height + high_ + rise_ + same_corner;
  const float* const all = columns_.heights().data();
  const float* first = all + columns_.first(cell);
  const float* last = all + columns_.last(cell);
  if (first == last || *first > to || last[-1] < from) // the usual case
    return {};
  first = std::lower_bound(first, last, from);
  last = std::upper_bound(first, last, to);
  return {static_cast<std::size_t>(first - all), static_cast<std::size_t>(last - all)};
}

HeightRange
heightsNear(const LevelColumns& columns, const PlanSlab& slab, double reach)
{
  const CellBox box = grown(columns.box(), 1); // margin for rounding at the edge
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (const std::int32_t x : {box.low.x, box.high.x})
    for (const std::int32_t y : {box.low.y, box.high.y}) {
      const double height = slab.heightAt(columns.grid().centre({x, y}));
      lowest = std::min(lowest, height);
      highest = std::max(highest, height);
    }
  return {lowest - reach / slab.plane[2] - same_corner,
          highest + reach / slab.plane[2] + same_corner};
}

HeightStretch
stretchNear(const LevelColumns& columns,
            const std::vector<Candidate>& sorted,
            const PlanSlab& slab,
            double reach)
{
  const auto [low, high] = heightsNear(columns, slab, reach);
  const Candidate* const end = sorted.data() + sorted.size();
  const Candidate* const first = std::lower_bound(
      sorted.data(), end, low, [](const Candidate& c, double z) { return c.z < z; });
  return {first, std::upper_bound(first, end, high, [](double z, const Candidate& c) {
            return z < c.z;
          })};
}

std::vector<std::uint8_t>
columnsThatGoOn(const LevelColumns& columns,
                const std::vector<std::uint8_t>& asked,
                const PlanSlab& slab,
                double direction,
                double tolerance)
{
  constexpr std::uint8_t away = 1;
  constexpr std::uint8_t close = 2;
  constexpr std::uint8_t joined = 4;
  constexpr std::uint8_t looked_at = 8;
  const CeilingGap gap = gapBelow(slab);
  const CellSet& cells = columns.cells();
  const double nearest = std::min(1.5 * tolerance, gap.high);
  const double farthest = std::max(4 * tolerance, gap.low);
  const StretchesNear stretchOf(columns, slab, direction > 0 ? nearest : -farthest,
                                direction > 0 ? farthest : -nearest);
  const auto look = [&](std::size_t cell) {
    std::uint8_t seen = looked_at;
    const ColumnStretch stretch = stretchOf(cell);
    for (std::size_t k = stretch.first; k < stretch.last; ++k) {
      const double d = direction * distanceAbove(slab, columns.all()[k].position());
      if (d > 1.5 * tolerance && d < 4 * tolerance)
        seen |= d < 2.25 * tolerance ? away | close : away;
      if (direction > 0 || (d > gap.high && d < gap.low))
        seen |= joined;
    }
    return seen;
  };
  std::vector<std::uint8_t> seen(cells.size(), 0);
  const auto forAsked = [&](const std::function<void(std::size_t)>& see) {
    parallelFor(cells.size(), cells_a_block, columns.threads(), [&](std::size_t i) {
      if (asked[i])
        see(i);
    });
  };
  forAsked([&](std::size_t i) { seen[i] = look(i); });
  std::vector<std::uint8_t> goes_on(cells.size(), 0);
  forAsked([&](std::size_t i) {
    if ((seen[i] & away) == 0)
      return;
    std::uint8_t around = 0;
    for (const std::size_t b : blockAround(cells, i))
      around |= seen[b] != 0 ? seen[b] : look(b);
    goes_on[i] = (around & close) != 0 && (around & joined) != 0 ? 1 : 0;
  });
  return goes_on;
}

} // namespace pcl::sedr
