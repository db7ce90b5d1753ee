// SPDX-License-Identifier: BSD-3-Clause
#include "level_regions.h"

namespace pcl {
namespace sedr {

std::vector<std::vector<std::size_t>>
levelRegions(const LevelColumns& columns,
             const std::vector<std::uint8_t>& marked,
             const PlanSlab& slab,
             double tolerance,
             std::size_t minimum_cells)
{
  const CellSet& cells = columns.cells();
  const std::vector<std::uint8_t> below =
      columnsThatGoOn(columns, marked, slab, -1, tolerance);
  const std::vector<std::uint8_t> above =
      columnsThatGoOn(columns, marked, slab, 1, tolerance);
  std::vector<std::size_t> positions;
  std::vector<CellKey> keys;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!marked[i] || below[i] || above[i])
      continue;
    positions.push_back(i);
    keys.push_back(cells.keys()[i]);
  }
  const CellRegions labels = labelRegions(CellSet::fromSorted(std::move(keys)));
  std::vector<std::vector<std::size_t>> regions;
  for (const std::size_t size : labels.sizes)
    if (size >= minimum_cells)
      regions.emplace_back();
  for (std::size_t k = 0; k < positions.size(); ++k)
    if (labels.label[k] < regions.size())
      regions[labels.label[k]].push_back(positions[k]);
  return regions;
}

} // namespace sedr
} // namespace pcl
