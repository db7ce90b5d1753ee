// SPDX-License-Identifier: BSD-3-Clause
#include "part_ways.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl::sedr {

namespace {

constexpr int far_off = std::numeric_limits<int>::max() / 2;

/** @brief Returns the steps from `start` through the cells of `free`. O(cells). */
std::vector<int>
stepsFrom(const CellMask& start, const CellMask& free)
{
  constexpr std::array<Cell, 4> around{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  std::vector<int> steps(start.values().size(), far_off);
  std::vector<std::size_t> met;
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (start.values()[i]) {
      steps[i] = 0;
      met.push_back(i);
    }
  for (std::size_t k = 0; k < met.size(); ++k)
    for (const Cell by : around) {
      const Cell cell = start.cellAt(met[k]);
      const Cell next{cell.x + by.x, cell.y + by.y};
      if (!free.at(next) || steps[start.indexOf(next)] != far_off)
        continue;
      steps[start.indexOf(next)] = steps[met[k]] + 1;
      met.push_back(start.indexOf(next));
    }
  return steps;
}

} // namespace

CellMask
waysToParts(const CellMask& region,
            const CellMask& core,
            const CellMask& air,
            const CellMask& free,
            double worth)
{
  constexpr int detour = 4; // steps: ways that are so much longer count
  const MaskRegions parts = labelRegions(region, false);
  std::vector<double> value(parts.sizes.size(), 0);
  std::vector<int> nearest(parts.sizes.size(), far_off);
  const std::vector<int> from_core = stepsFrom(core, free);
  for (std::size_t i = 0; i < from_core.size(); ++i)
    if (parts.label[i] >= 0) {
      const auto part = static_cast<std::size_t>(parts.label[i]);
      value[part] += air.values()[i] ? worth : 0;
      nearest[part] = std::min(nearest[part], from_core[i]);
    }
  CellMask ways(region.box());
  for (std::size_t p = 0; p < value.size(); ++p) {
    if (nearest[p] == 0 || value[p] <= 2.0 * nearest[p])
      continue;
    const std::vector<int> from_part =
        stepsFrom(regionMask(region, parts, static_cast<std::int32_t>(p)), free);
    for (std::size_t i = 0; i < from_part.size(); ++i)
      if (from_core[i] + from_part[i] <= nearest[p] + detour)
        ways.values()[i] = 1;
  }
  return ways;
}

} // namespace pcl::sedr
