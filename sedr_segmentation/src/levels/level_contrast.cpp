// SPDX-License-Identifier: BSD-3-Clause
#include "level_contrast.h"

#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/plane_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pcl::sedr {

namespace {

/** @brief Numbers of points at a slab, above and below it. */
struct Contrast {
  std::size_t at_slab = 0;
  std::size_t above = 0;
  std::size_t below = 0;
};

/** @brief Counts the points at, above and below a slab, weighted per cell. */
Contrast
contrastOf(const LevelColumns& columns,
           const std::vector<std::uint8_t>& weights,
           const PlanSlab& slab,
           double tolerance)
{
  const StretchesNear stretchOf(columns, slab, -2 * tolerance, 2 * tolerance);
  std::vector<Contrast> parts(weights.size() / cells_a_block + 1);
  const auto look = [&](std::size_t begin, std::size_t end) {
    Contrast& contrast = parts[begin / cells_a_block];
    for (std::size_t cell = begin; cell < end; ++cell) {
      const std::size_t weight = weights[cell];
      if (weight == 0)
        continue;
      const ColumnStretch near = stretchOf(cell);
      for (std::size_t k = near.first; k < near.last; ++k) {
        const double d = distanceAbove(slab, columns.all()[k].position());
        contrast.at_slab += std::abs(d) <= tolerance / 2 ? weight : 0;
        contrast.above += d > tolerance && d <= 2 * tolerance ? weight : 0;
        contrast.below += d < -tolerance && d >= -2 * tolerance ? weight : 0;
      }
    }
  };
  parallelBlocks(weights.size(), cells_a_block, columns.threads(), look);
  Contrast contrast;
  for (const Contrast& part : parts) {
    contrast.at_slab += part.at_slab;
    contrast.above += part.above;
    contrast.below += part.below;
  }
  return contrast;
}

/** @brief Returns for each cell the number of marked cells up to `reach` cells away,
 * without itself. */
std::vector<std::uint8_t>
markedAround(const CellSet& cells, const std::vector<std::uint8_t>& marked, int reach)
{
  std::vector<std::uint8_t> around(marked.size(), 0);
  for (std::size_t i = 0; i < marked.size(); ++i)
    if (marked[i])
      forEachAround(cells, cells[i], reach,
                    [&](std::size_t k) { around[k] += k != i ? 1 : 0; });
  return around;
}

/** @brief Returns the marked cells and their neighbours, by runs of cells in a row. */
std::vector<std::uint8_t>
withNeighbours(const CellSet& cells, const std::vector<std::uint8_t>& marked)
{
  std::vector<std::uint8_t> result(marked.size(), 0);
  for (std::size_t i = 0; i < marked.size(); ++i) {
    if (!marked[i])
      continue;
    const Cell first = cells[i];
    Cell last = first;
    for (; i + 1 < marked.size() && marked[i + 1] &&
           cells[i + 1] == Cell{last.x + 1, last.y};
         ++i)
      ++last.x;
    for (const std::int32_t y : {first.y - 1, first.y, first.y + 1}) {
      const CellKey end = keyOf({last.x + 1, y});
      for (std::size_t k = cells.firstFrom({first.x - 1, y});
           k < cells.size() && cells.keys()[k] <= end; ++k)
        result[k] = 1;
    }
  }
  return result;
}

} // namespace

bool
standsOut(const LevelColumns& columns,
          const std::vector<std::uint8_t>& marked,
          const PlanSlab& slab,
          double tolerance)
{
  const CellSet& cells = columns.cells();
  const std::vector<std::uint8_t> about = withNeighbours(cells, marked);
  const Contrast all = contrastOf(columns, about, slab, tolerance);
  if (all.at_slab <= 2 * std::max(all.above, all.below))
    return false;
  const auto count = [](const std::vector<std::uint8_t>& mask) {
    return std::count(mask.begin(), mask.end(), 1);
  };
  if (2 * count(marked) > count(about)) // mostly adjacent cells
    return true;
  const Contrast around =
      contrastOf(columns, markedAround(cells, marked, 2), slab, tolerance);
  return around.at_slab >= 2 * std::max(around.above, around.below);
}

} // namespace pcl::sedr
