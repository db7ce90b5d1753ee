// SPDX-License-Identifier: BSD-3-Clause
#include "level_contrast.h"

#include <pcl/sedr_filters/plane_fit.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl {
namespace sedr {

namespace {

/** @brief Points at a slab and beside it. */
struct Contrast {
  std::size_t at_slab = 0;
  std::size_t above = 0;
  std::size_t below = 0;
};

/** @brief Counts the points of the columns, each as often as its cell weighs. */
Contrast
contrastOf(const LevelColumns& columns,
           const std::vector<std::uint8_t>& weights,
           const PlanSlab& slab,
           double tolerance)
{
  Contrast contrast;
  for (std::size_t cell = 0; cell < weights.size(); ++cell) {
    const std::size_t weight = weights[cell];
    if (weight == 0)
      continue;
    for (std::size_t k = columns.first(cell); k < columns.last(cell); ++k) {
      const double d = distanceAbove(slab, columns.all()[k].position());
      contrast.at_slab += std::abs(d) <= tolerance / 2 ? weight : 0;
      contrast.above += d > tolerance && d <= 2 * tolerance ? weight : 0;
      contrast.below += d < -tolerance && d >= -2 * tolerance ? weight : 0;
    }
  }
  return contrast;
}

/** @brief The marked cells and those around them. */
std::vector<std::uint8_t>
withNeighbours(const CellSet& cells, const std::vector<std::uint8_t>& marked)
{
  std::vector<std::uint8_t> result(marked.size(), 0);
  for (std::size_t i = 0; i < marked.size(); ++i)
    if (marked[i])
      for (const std::size_t k : blockAround(cells, i))
        result[k] = 1;
  return result;
}

/** @brief For each cell the number of marked ones up to two cells away, itself left
 * out. */
std::vector<std::uint8_t>
markedAround(const CellSet& cells, const std::vector<std::uint8_t>& marked)
{
  std::vector<std::uint8_t> around(marked.size(), 0);
  for (std::size_t i = 0; i < marked.size(); ++i)
    if (marked[i])
      for (int k = 0; k < 25; ++k) {
        const std::size_t at =
            cells.find({cells[i].x + k % 5 - 2, cells[i].y + k / 5 - 2});
        if (at != i && at != CellSet::npos)
          ++around[at];
      }
  return around;
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
  if (2 * count(marked) > count(about)) // cells side by side
    return true;
  const Contrast around =
      contrastOf(columns, markedAround(cells, marked), slab, tolerance);
  return around.at_slab >= 2 * std::max(around.above, around.below);
}

} // namespace sedr
} // namespace pcl
