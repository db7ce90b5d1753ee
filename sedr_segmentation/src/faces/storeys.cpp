// SPDX-License-Identifier: BSD-3-Clause
#include "storeys.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Checks whether a room lies above or below another one in a part of the plan,
 * as a gallery in a hall does. */
bool
isOver(const RoomCells& room, const RoomCells& other, const CellGrid& grid)
{
  constexpr double least = 1; // square metre
  if (overlapOf(room.seen.box(), other.seen.box()).count() == 0)
    return false;
  const CellMask both = intersect(room.seen, other.seen);
  const CellMask over = subtract(both, room.besideRoom(other, both));
  return static_cast<double>(over.count()) * grid.size() * grid.size() > least;
}

} // namespace

std::vector<Storey>
storeysOf(const std::vector<RoomCells>& rooms, const CellGrid& grid)
{
  std::vector<std::size_t> order;
  for (std::size_t r = 0; r < rooms.size(); ++r)
    if (rooms[r].seen.count() > 0)
      order.push_back(r);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return rooms[a].ceiling < rooms[b].ceiling;
  });
  std::vector<Storey> storeys;
  std::vector<std::uint8_t> is_placed(rooms.size(), 0);
  for (const std::size_t seed : order) {
    if (is_placed[seed])
      continue;
    Storey storey;
    for (const std::size_t r : order) {
      const auto isOverRoom = [&](std::size_t other) {
        return isOver(rooms[r], rooms[other], grid);
      };
      if (is_placed[r] || (r != seed && !rooms[r].sharesHeights(rooms[seed])) ||
          std::any_of(storey.rooms.begin(), storey.rooms.end(), isOverRoom))
        continue;
      storey.rooms.push_back(r);
      is_placed[r] = 1;
    }
    std::sort(storey.rooms.begin(), storey.rooms.end());
    storeys.push_back(std::move(storey));
  }
  return storeys;
}

} // namespace pcl::sedr
