// SPDX-License-Identifier: BSD-3-Clause
#include "storeys.h"

#include "simulator/truth/room_regions.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl::sedr::sim {

namespace {

double
floorOf(const Room& room)
{
  return heightAt(room.floor, pointInside(room.outline));
}

/** @brief Returns storey numbers derived from floor heights alone. */
std::vector<std::size_t>
storeysByHeight(const std::vector<Room>& rooms)
{
  std::vector<std::size_t> order(rooms.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return floorOf(rooms[a]) < floorOf(rooms[b]);
  });
  std::vector<std::size_t> storeys(rooms.size(), 1);
  for (std::size_t i = 1; i < order.size(); ++i) {
    const double step = floorOf(rooms[order[i]]) - floorOf(rooms[order[i - 1]]);
    storeys[order[i]] = storeys[order[i - 1]] + (step >= kStoreyStep ? 1 : 0);
  }
  return storeys;
}

/** @brief Returns the numbered room whose floor is nearest in height. */
const Room*
nearestNumbered(const std::vector<Room>& rooms, const Room& room)
{
  const Room* nearest = nullptr;
  const auto distance = [&](const Room& other) {
    return std::abs(floorOf(other) - floorOf(room));
  };
  for (const Room& other : rooms)
    if (other.storey && (nearest == nullptr || distance(other) < distance(*nearest)))
      nearest = &other;
  return nearest;
}

} // namespace

std::vector<std::size_t>
storeysOf(const Scene& scene)
{
  std::vector<std::size_t> storeys = storeysByHeight(scene.rooms);
  for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
    const Room& room = scene.rooms[i];
    if (room.storey)
      storeys[i] = *room.storey;
    else if (const Room* numbered = nearestNumbered(scene.rooms, room))
      storeys[i] = *numbered->storey;
  }
  return storeys;
}

} // namespace pcl::sedr::sim
