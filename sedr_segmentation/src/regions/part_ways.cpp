// SPDX-License-Identifier: BSD-3-Clause
#include "part_ways.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr int straight = 5; // length of a step to one of four neighbours; of a
constexpr int diagonal = 7; // diagonal one, nearly as much longer as it is
constexpr int far_off = std::numeric_limits<int>::max() / 2;

/** @brief Returns the lengths of the shortest ways from `start` through the cells of
 * `free`. O(cells log cells). */
std::vector<int>
lengthsFrom(const CellMask& start, const CellMask& free)
{
  std::vector<int> length(start.values().size(), far_off);
  using Place = std::pair<int, std::size_t>;
  std::priority_queue<Place, std::vector<Place>, std::greater<>> next;
  for (std::size_t i = 0; i < length.size(); ++i)
    if (start.values()[i]) {
      length[i] = 0;
      next.push({0, i});
    }
  while (!next.empty()) {
    const auto [here, i] = next.top();
    next.pop();
    if (here > length[i])
      continue;
    const Cell cell = start.cellAt(i);
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        const Cell by{cell.x + x, cell.y + y};
        const int there = here + (x != 0 && y != 0 ? diagonal : straight);
        if (!free.at(by) || !free.at({cell.x, by.y}) || !free.at({by.x, cell.y}) ||
            there >= length[start.indexOf(by)])
          continue;
        length[start.indexOf(by)] = there;
        next.push({there, start.indexOf(by)});
      }
  }
  return length;
}

} // namespace

CellMask
waysToParts(const CellMask& region,
            const CellMask& core,
            const CellMask& free,
            const std::vector<float>& worth,
            double border)
{
  constexpr int detour = 2 * straight; // ways longer by two cells are of it, too
  const MaskRegions parts = labelRegions(region, false);
  std::vector<double> value(parts.sizes.size(), 0);
  std::vector<std::uint8_t> has_core(parts.sizes.size(), 0);
  for (std::size_t i = 0; i < worth.size(); ++i)
    if (parts.label[i] >= 0) {
      value[static_cast<std::size_t>(parts.label[i])] += worth[i];
      if (core.values()[i])
        has_core[static_cast<std::size_t>(parts.label[i])] = 1;
    }
  CellMask ways(region.box());
  std::vector<int> from_core;
  for (std::size_t p = 0; p < value.size(); ++p) {
    if (has_core[p] || value[p] <= 2 * border)
      continue;
    if (from_core.empty())
      from_core = lengthsFrom(core, free);
    const std::vector<int> from_part =
        lengthsFrom(regionMask(region, parts, static_cast<std::int32_t>(p)), free);
    int shortest = far_off;
    for (std::size_t i = 0; i < from_part.size(); ++i)
      shortest = std::min(shortest, from_core[i] + from_part[i]);
    double price = 2 * border * shortest / straight;
    std::vector<std::size_t> way;
    for (std::size_t i = 0; i < from_part.size() && price < value[p]; ++i)
      if (from_core[i] + from_part[i] <= shortest + detour) {
        way.push_back(i);
        price += region.values()[i] ? 0 : -std::min(0.f, worth[i]);
      }
    if (price < value[p])
      for (const std::size_t i : way)
        ways.values()[i] = 1;
  }
  return ways;
}

} // namespace pcl::sedr
