// SPDX-License-Identifier: BSD-3-Clause
#include "level_candidates.h"

#include <pcl/sedr_filters/parallel.h>
#include <pcl/sedr_filters/plane_fit.h>
#include <pcl/sedr_segmentation/ceiling_gap.h>

#include <algorithm>
#include <functional>

namespace pcl {
namespace sedr {

CellBlock
blockAround(const CellSet& cells, std::size_t at)
{
  CellBlock block;
  forEachAround(cells, cells[at], 1, [&](std::size_t i) { block.add(i); });
  return block;
}

ColumnStretch
stretchNear(const LevelColumns& columns,
            std::size_t cell,
            const PlanSlab& slab,
            double low,
            double high)
{
  constexpr double rounding = 1e-4;
  const double up = slab.plane[2];
  const double rise = slab.plane.head<2>().norm() / up * columns.grid().size();
  const double height = slab.heightAt(columns.grid().centre(columns.cells()[cell]));
  const double from = height + low / up - rise - rounding;
  const double to = height + high / up + rise + rounding;
  const auto at = [&](std::size_t k) {
    return columns.all().begin() + static_cast<std::ptrdiff_t>(k);
  };
  const auto first =
      std::lower_bound(at(columns.first(cell)), at(columns.last(cell)), from,
                       [](const Candidate& c, double z) { return c.z < z; });
  const auto last =
      std::upper_bound(first, at(columns.last(cell)), to,
                       [](double z, const Candidate& c) { return z < c.z; });
  return {static_cast<std::size_t>(first - columns.all().begin()),
          static_cast<std::size_t>(last - columns.all().begin())};
}

std::vector<std::uint8_t>
columnsThatGoOn(const LevelColumns& columns,
                const std::vector<std::uint8_t>& asked,
                const PlanSlab& slab,
                double direction,
                double tolerance)
{
  constexpr std::size_t cells_a_block = 4096;
  constexpr std::uint8_t away = 1;
  constexpr std::uint8_t close = 2;
  constexpr std::uint8_t joined = 4;
  constexpr std::uint8_t looked_at = 8;
  const CeilingGap gap = gapBelow(slab);
  const CellSet& cells = columns.cells();
  const double nearest = std::min(1.5 * tolerance, gap.high);
  const double farthest = std::max(4 * tolerance, gap.low);
  const auto look = [&](std::size_t cell) {
    std::uint8_t seen = looked_at;
    const ColumnStretch stretch =
        direction > 0 ? stretchNear(columns, cell, slab, nearest, farthest)
                      : stretchNear(columns, cell, slab, -farthest, -nearest);
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
    parallelBlocks(cells.size(), cells_a_block, columns.threads(),
                   [&](std::size_t begin, std::size_t end) {
                     for (std::size_t i = begin; i < end; ++i)
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

} // namespace sedr
} // namespace pcl
