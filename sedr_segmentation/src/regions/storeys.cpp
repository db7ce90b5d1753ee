// SPDX-License-Identifier: BSD-3-Clause
#include "storey_regions.h"

#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <cstdint>

namespace pcl::sedr {

std::vector<Storey>
storeysOf(const std::vector<RoomCells>& rooms,
          const CellGrid& grid,
          const WallLineParameters& parameters,
          unsigned threads)
{
  std::vector<std::size_t> order;
  for (std::size_t r = 0; r < rooms.size(); ++r)
    if (rooms[r].seen.count() > 0)
      order.push_back(r);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return rooms[a].ceiling < rooms[b].ceiling;
  });
  std::vector<Storey> storeys;
  std::vector<std::size_t> seeds;
  std::vector<std::uint8_t> is_placed(rooms.size(), 0);
  for (const std::size_t seed : order) {
    if (is_placed[seed])
      continue;
    Storey storey;
    for (const std::size_t r : order)
      if (!is_placed[r] && (r == seed || rooms[r].sharesHeights(rooms[seed]))) {
        storey.rooms.push_back(r);
        is_placed[r] = 1;
      }
    std::sort(storey.rooms.begin(), storey.rooms.end());
    storeys.push_back(std::move(storey));
    seeds.push_back(seed);
  }
  parallelBlocks(storeys.size(), 1, threads, [&](std::size_t s, std::size_t) {
    std::vector<SurfacePlace> places;
    std::vector<SurfacePlace> lintels;
    std::vector<SurfacePlace> parapets;
    for (const std::size_t r : order) {
      if (!rooms[r].sharesHeights(rooms[seeds[s]]) && r != seeds[s])
        continue;
      std::size_t k = 0;
      for (std::size_t i = 0; i < rooms[r].solid.values().size(); ++i) {
        const auto room = static_cast<std::uint32_t>(r);
        if (rooms[r].base.values()[i])
          parapets.push_back({grid.centre(rooms[r].base.cellAt(i)), room});
        if (!rooms[r].solid.values()[i] && !rooms[r].riser.values()[i])
          continue;
        if (rooms[r].riser.values()[i])
          lintels.push_back({rooms[r].centres[k], room});
        else if (!rooms[r].glass.values()[i])
          places.push_back({rooms[r].centres[k], room});
        ++k;
      }
    }
    storeys[s].lines = wallLines(std::move(places), parapets, parameters);
    storeys[s].lintels = wallLines(std::move(lintels), {}, parameters);
    WallLineParameters of_parapets = parameters;
    of_parapets.min_part = 2; // shorter ones are below windows with walls beside them
    for (WallLine& line : wallLines(std::move(parapets), {}, of_parapets))
      storeys[s].lintels.push_back(std::move(line));
    for (WallLine& line : storeys[s].lintels)
      for (AlongLine& what : line.places)
        what = what == AlongLine::Surface ? AlongLine::Ended : AlongLine::Nothing;
  });
  return storeys;
}

} // namespace pcl::sedr
