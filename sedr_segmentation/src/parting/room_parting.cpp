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

/** @brief Returns the doubt about a border of two rooms.
 * @param odds logarithm of the odds that they are one */
PartingDoubt
doubtAbout(const RoomBorders& rooms, std::uint32_t a, std::uint32_t b, double odds)
{
  const RoomBorder& border = rooms.room(a).beside.at(b);
  return {a, odds > 0 ? a : b, border.at / border.links,
          std::min(rooms.room(a).area, rooms.room(b).area),
          1 / (1 + std::exp(std::abs(odds)))};
}

/** @brief Joins rooms until any two are more likely two than one: first those between
 * which there is least.
 * @return what may be wrong, by rooms before they are joined */
std::vector<PartingDoubt>
joinRooms(RoomBorders& rooms)
{
  std::vector<PartingDoubt> doubts;
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
    const RoomOdds now = rooms.oddsOfOne(a, b);
    if (now.by_border != -odds || now.by_all <= 0)
      continue;
    doubts.push_back(doubtAbout(rooms, a, b, now.by_all));
    rooms.join(a, b);
    judgeBordersOf(a);
  }
  for (std::uint32_t a = 0; a < rooms.size(); ++a)
    for (const auto& [b, border] : rooms.room(a).beside)
      if (a < b && border.links > 0)
        doubts.push_back(doubtAbout(rooms, a, b, rooms.oddsOfOne(a, b).by_all));
  return doubts;
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
  PartedAir parted;
  parted.doubts = joinRooms(borders);
  std::vector<std::int32_t> room = labels.joined();
  keepHeightField(air, room);
  RoomLabels rooms(std::move(room));
  parted.room = rooms.joined();
  parted.rooms = rooms.sizes().size();
  parted.openings = openingsBetween(air, rooms);
  std::vector<std::uint32_t> number(borders.size()); // of what became of each
  for (std::uint32_t g = 0; g < air.size(); ++g)
    if (rooms.hasRoom(g))
      number[labels.roomOf(g)] = rooms.roomOf(g);
  for (PartingDoubt& doubt : parted.doubts) {
    doubt.a = number[labels.rootOf(doubt.a)];
    doubt.b = number[labels.rootOf(doubt.b)];
  }
  return parted;
}

} // namespace pcl::sedr
