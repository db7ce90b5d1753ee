// SPDX-License-Identifier: BSD-3-Clause
#include "cell_mask.h"

#include <algorithm>

namespace pcl::sedr {

MaskRegions
labelRegions(const CellMask& mask, bool eight_connected)
{
  MaskRegions regions;
  regions.label.assign(mask.values().size(), -1);
  std::vector<std::size_t> stack;
  for (std::size_t start = 0; start < mask.values().size(); ++start) {
    if (!mask.values()[start] || regions.label[start] >= 0)
      continue;
    const auto region = static_cast<std::int32_t>(regions.sizes.size());
    regions.sizes.push_back(0);
    regions.touches_border.push_back(0);
    regions.label[start] = region;
    stack.push_back(start);
    while (!stack.empty()) {
      const Cell cell = mask.cellAt(stack.back());
      stack.pop_back();
      ++regions.sizes.back();
      if (cell.x == mask.box().low.x || cell.x == mask.box().high.x ||
          cell.y == mask.box().low.y || cell.y == mask.box().high.y)
        regions.touches_border.back() = 1;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const Cell next{cell.x + dx, cell.y + dy};
          if ((!eight_connected && dx != 0 && dy != 0) || !mask.at(next))
            continue;
          const std::size_t i = mask.indexOf(next);
          if (regions.label[i] >= 0)
            continue;
          regions.label[i] = region;
          stack.push_back(i);
        }
    }
  }
  return regions;
}

CellMask
regionMask(const CellMask& mask, const MaskRegions& regions, std::int32_t region)
{
  CellMask result(mask.box());
  for (std::size_t i = 0; i < result.values().size(); ++i)
    result.values()[i] = regions.label[i] == region ? 1 : 0;
  return result;
}

CellMask
markedRegions(const CellMask& mask, const CellMask& marks, bool eight_connected)
{
  const MaskRegions regions = labelRegions(mask, eight_connected);
  std::vector<std::uint8_t> is_marked(regions.sizes.size(), 0);
  for (std::size_t i = 0; i < regions.label.size(); ++i)
    if (marks.values()[i] && regions.label[i] >= 0)
      is_marked[static_cast<std::size_t>(regions.label[i])] = 1;
  CellMask result(mask.box());
  for (std::size_t i = 0; i < regions.label.size(); ++i)
    if (regions.label[i] >= 0)
      result.values()[i] = is_marked[static_cast<std::size_t>(regions.label[i])];
  return result;
}

CellMask
largestRegion(const CellMask& mask)
{
  const MaskRegions regions = labelRegions(mask, false);
  if (regions.sizes.empty())
    return mask;
  const auto largest = std::max_element(regions.sizes.begin(), regions.sizes.end());
  return regionMask(mask, regions,
                    static_cast<std::int32_t>(largest - regions.sizes.begin()));
}

void
growLabels(const CellMask& domain, int steps, std::vector<std::int32_t>& label)
{
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < label.size(); ++i)
    if (label[i] >= 0)
      front.push_back(i);
  for (int step = 0; step < steps && !front.empty(); ++step) {
    std::vector<std::size_t> next;
    for (const std::size_t i : front) {
      const Cell cell = domain.cellAt(i);
      for (const Cell d : {Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}}) {
        const Cell to{cell.x + d.x, cell.y + d.y};
        if (!domain.at(to))
          continue;
        const std::size_t j = domain.indexOf(to);
        if (label[j] >= 0)
          continue;
        label[j] = label[i];
        next.push_back(j);
      }
    }
    front.swap(next);
  }
}

CellMask
enclosedCells(const CellMask& mask)
{
  const CellMask empty = inverted(mask);
  const MaskRegions regions = labelRegions(empty, false);
  CellMask enclosed(mask.box());
  for (std::size_t i = 0; i < enclosed.values().size(); ++i)
    enclosed.values()[i] =
        regions.label[i] >= 0 &&
                !regions.touches_border[static_cast<std::size_t>(regions.label[i])]
            ? 1
            : 0;
  return enclosed;
}

} // namespace pcl::sedr
