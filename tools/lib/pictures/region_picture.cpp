// SPDX-License-Identifier: BSD-3-Clause
#include "region_picture.h"

#include "map_cells.h"

#include <algorithm>

namespace pcl::sedr::tools {

namespace {

/** @brief Returns the minimum size of named regions, cells. */
std::size_t
minNamed(const RegionMap& map)
{
  return std::max<std::size_t>(12, map.cells.size() / 1500);
}

/** @brief Draws each region in its own colour, with its size. */
void
addRegions(const RegionMap& map, std::size_t first_colour, Panel& panel)
{
  const std::vector<CellSet> regions = map.regionCells();
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const CellSet& cells = regions[r];
    panel.addCells(cells, map.cell_size, colourNumber(first_colour + r));
    if (cells.size() >= minNamed(map))
      panel.addLabel(labelPlace(cells, map.cell_size), std::to_string(cells.size()));
  }
}

/** @brief Draws regions by decision: C for ceilings, O for outliers. */
void
addDecision(const RegionMap& map, std::size_t first_shade, Panel& panel)
{
  const std::vector<CellSet> regions = map.regionCells();
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const CellSet& cells = regions[r];
    const bool is_kept = map.number[r] > 0;
    panel.addCells(cells, map.cell_size,
                   is_kept ? ceilingShade(first_shade + r) : colours::removed);
    if (cells.size() >= minNamed(map))
      panel.addLabel(labelPlace(cells, map.cell_size), is_kept ? "C" : "O");
  }
}

/** @brief Lists the sizes of the regions in order, with a bar at the threshold, and the
 * number kept. */
std::string
sizesOf(const RegionMap& map)
{
  constexpr std::size_t most = 12;
  const auto& sizes = map.regions.sizes;
  std::string text = "cells a region:";
  bool is_above = true;
  std::size_t supported = 0;
  for (std::size_t r = 0; r < sizes.size(); ++r) {
    supported += sizes[r] <= map.threshold && map.number[r] > 0 ? 1 : 0;
    if (r >= most)
      continue;
    if (is_above && sizes[r] <= map.threshold) {
      text += " |";
      is_above = false;
    }
    text += " " + std::to_string(sizes[r]);
  }
  if (sizes.size() > most)
    text += " and " + std::to_string(sizes.size() - most) + " smaller ones";
  text += "; kept above the largest gap, " + std::to_string(map.threshold);
  return supported > 0
             ? text + ", and " + std::to_string(supported) + " for their floor"
             : text;
}

} // namespace

Picture
drawRegions(const std::vector<RegionMap>& maps)
{
  CellSet all;
  std::size_t regions = 0;
  std::size_t kept = 0;
  std::size_t cells = 0;
  for (const auto& map : maps) {
    addTo(all, map.cells);
    cells += map.cells.size();
    regions += map.regions.sizes.size();
    kept += static_cast<std::size_t>(std::count_if(map.number.begin(), map.number.end(),
                                                   [](int n) { return n > 0; }));
  }
  Panel binary("binary map: " + counted(cells, "cell"));
  Panel region("regions: " + std::to_string(regions) + ", sizes in cells");
  Panel decision("kept (C): " + std::to_string(kept) +
                 ", removed (O): " + std::to_string(regions - kept));
  std::size_t first = 0;
  for (const auto& map : maps) {
    binary.addCells(map.cells, map.cell_size, colours::other);
    addRegions(map, first, region);
    addDecision(map, first, decision);
    first += map.regions.sizes.size();
  }
  const double cell_size = maps.empty() ? 1 : maps.front().cell_size;
  for (Panel* panel : {&binary, &region, &decision})
    panel->setView(viewOf(all, cell_size));

  Picture picture("Outlier removal by grid regions: " + std::to_string(kept) + " of " +
                  counted(regions, "region") + " kept");
  picture.addMaps({binary, region, decision});
  picture.addLegend("occupied cell", colours::other);
  picture.addLegend("kept, a shade a region", colours::ceiling);
  picture.addLegend("removed", colours::removed);
  for (std::size_t m = 0; m < std::min<std::size_t>(maps.size(), 4); ++m)
    picture.addNote((maps.size() > 1 ? "Ceiling " + std::to_string(m + 1) + ", " : "") +
                    sizesOf(maps[m]));
  return picture;
}

} // namespace pcl::sedr::tools
