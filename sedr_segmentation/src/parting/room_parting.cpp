// SPDX-License-Identifier: BSD-3-Clause
#include "room_parting.h"

#include "room_basins.h"
#include "room_borders.h"

#include "../air/ceiling_dip.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <tuple>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Joins rooms until any two are more likely two than one: first those between
 * which there is least. */
void
joinRooms(RoomBorders& rooms)
{
  using Turn = std::tuple<double, std::uint32_t, std::uint32_t>; // the least is first
  std::priority_queue<Turn, std::vector<Turn>, std::greater<Turn>> turns;
  const auto judgeBordersOf = [&](std::uint32_t room) {
    for (const auto& entry : rooms.room(room).beside) {
      const auto [a, b] = std::minmax(room, entry.first);
      if (const RoomOdds odds = rooms.oddsOfOne(a, b); odds.by_all > 0)
        turns.emplace(-odds.by_border, a, b);
    }
  };
  for (std::uint32_t r = 0; r < rooms.size(); ++r)
    judgeBordersOf(r);
  while (!turns.empty()) {
    const auto [odds, a, b] = turns.top();
    turns.pop();
    if (rooms.room(a).beside.count(b) == 0)
      continue; // one of them was joined since
    if (const RoomOdds now = rooms.oddsOfOne(a, b);
        now.by_border != -odds || now.by_all <= 0)
      continue;
    rooms.join(a, b);
    judgeBordersOf(a);
  }
}

/** @brief Of the gaps of a column that are of one room the tallest stays: others are
 * below its stairs or above its furniture. */
void
keepHeightField(const AirGaps& air, std::vector<std::int32_t>& room)
{
  for (std::uint32_t g = 0; g + 1 < air.size(); ++g)
    for (std::uint32_t o = g + 1; o < air.size() && air[o].column == air[g].column; ++o)
      if (room[g] != PartedAir::no_room && room[g] == room[o])
        room[air.height(g) < air.height(o) ? g : o] = PartedAir::no_room;
}

} // namespace

PartedAir
partIntoRooms(const AirGaps& air, const PartingParameters& parameters)
{
  const std::vector<float> dip =
      dipOfCeiling(air, static_cast<int>(std::lround(parameters.lintel_reach /
                                                     air.columns().cellSize())));
  RoomLabels labels(roomBasins(air, dip, parameters));
  RoomBorders borders(air, dip, parameters, labels);
  joinRooms(borders);
  std::vector<std::int32_t> room = labels.joined();
  keepHeightField(air, room);
  RoomLabels rooms(std::move(room));
  PartedAir parted;
  parted.room = rooms.joined();
  parted.rooms = rooms.sizes().size();
  parted.openings = openingsBetween(air, rooms);
  return parted;
}

} // namespace pcl::sedr
