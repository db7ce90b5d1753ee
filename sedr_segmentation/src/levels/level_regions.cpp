// SPDX-License-Identifier: BSD-3-Clause
#include "level_regions.h"

namespace pcl::sedr {

std::vector<std::uint8_t>
withoutWalls(const LevelColumns& columns,
             const std::vector<std::uint8_t>& marked,
             const PlanSlab& slab,
             double tolerance)
{
  std::vector<std::uint8_t> rest = marked;
  for (const double direction : {-1.0, 1.0}) {
    const std::vector<std::uint8_t> walls =
        columnsThatGoOn(columns, marked, slab, direction, tolerance);
    for (std::size_t i = 0; i < rest.size(); ++i)
      rest[i] = rest[i] && !walls[i] ? 1 : 0;
  }
  return rest;
}

std::vector<std::vector<std::size_t>>
regionsOf(const CellSet& cells,
          const std::vector<std::uint8_t>& marked,
          std::size_t minimum_cells)
{
  std::vector<std::size_t> positions;
  std::vector<CellKey> keys;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!marked[i])
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

std::vector<std::vector<std::size_t>>
levelRegions(const LevelColumns& columns,
             const std::vector<std::uint8_t>& marked,
             const PlanSlab& slab,
             double tolerance,
             std::size_t minimum_cells)
{
  return regionsOf(columns.cells(), withoutWalls(columns, marked, slab, tolerance),
                   minimum_cells);
}

} // namespace pcl::sedr
