// SPDX-License-Identifier: BSD-3-Clause
#include "room_parting.h"

#include "../air/air_measures.h"
#include "room_borders.h"

#include "sedr_filters/src/base/plane_fit.h"
#include "sedr_filters/src/grids/disjoint_sets.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief A link from the air of one room to that of another. */
struct Crossing {
  std::uint32_t from = 0; ///< gap of the room with the lower number
  std::uint32_t to = 0;
};

using RoomPair = std::pair<std::uint32_t, std::uint32_t>; ///< the lower number first

std::map<RoomPair, std::vector<Crossing>>
crossingsOf(const AirGaps& air, RoomLabels& rooms)
{
  std::map<RoomPair, std::vector<Crossing>> crossings;
  for (std::uint32_t g = 0; g < air.size(); ++g)
    for (int d = 0; d < 4; ++d) {
      const bool is_link = air.link(g, d) != AirGaps::none;
      const std::uint32_t o = air.isDrop(g, d) ? AirGaps::none
                              : is_link        ? air.link(g, d)
                                               : air.climb(g, d);
      if (o == AirGaps::none || !rooms.hasRoom(g) || !rooms.hasRoom(o))
        continue;
      const std::uint32_t a = rooms.roomOf(g);
      const std::uint32_t b = rooms.roomOf(o);
      if (a < b)
        crossings[{a, b}].push_back({g, o});
      else if (b < a && !is_link)
        crossings[{b, a}].push_back({o, g}); // one climbs one way, links go both
    }
  return crossings;
}

/** @brief Crossings by openings: those that hang together. */
std::vector<std::vector<Crossing>>
parted(const AirGaps& air, const std::vector<Crossing>& crossings)
{
  constexpr int near = 2; // cells, of a slanting line
  const auto cellOf = [&](std::uint32_t k) {
    return air.columns().cellOf(air[crossings[k].from].column);
  };
  std::unordered_map<CellKey, std::vector<std::uint32_t>> at;
  for (std::uint32_t k = 0; k < crossings.size(); ++k)
    at[keyOf(cellOf(k))].push_back(k);
  DisjointSets<> sets(crossings.size());
  for (std::uint32_t k = 0; k < crossings.size(); ++k) {
    const Cell c = cellOf(k);
    for (int dx = -near; dx <= near; ++dx)
      for (int dy = -near; dy <= near; ++dy)
        if (const auto found = at.find(keyOf({c.x + dx, c.y + dy})); found != at.end())
          for (const std::uint32_t o : found->second)
            sets.join(k, o);
  }
  std::map<std::uint32_t, std::vector<Crossing>> parts;
  for (std::uint32_t k = 0; k < crossings.size(); ++k)
    parts[sets.find(k)].push_back(crossings[k]);
  std::vector<std::vector<Crossing>> openings;
  for (auto& entry : parts)
    openings.push_back(std::move(entry.second));
  return openings;
}

RoomOpening
measured(const AirGaps& air, const std::vector<Crossing>& crossings)
{
  RoomOpening m;
  Eigen::Vector2d through = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  const auto n = static_cast<double>(crossings.size());
  for (const Crossing& c : crossings) {
    const Eigen::Vector2d at = (air.placeOf(c.from) + air.placeOf(c.to)) / 2;
    through += air.placeOf(c.to) - air.placeOf(c.from);
    m.middle += at / n;
    squares += at * at.transpose() / n;
    m.bottom += air.columns().heightOf(std::max(air[c.from].low, air[c.to].low)) / n;
    m.top += air.columns().heightOf(std::min(air[c.from].high, air[c.to].high)) / n;
  }
  m.direction = // of one or two, at a right angle to the way through
      n <= 2 && through.norm() > 0
          ? Eigen::Vector2d(Eigen::Vector2d(-through.y(), through.x()).normalized())
          : Eigen::Vector2d(
                symmetricEigen(
                    Eigen::Matrix2d(squares - m.middle * m.middle.transpose()))
                    .vectors.col(1));
  const auto along = [&](const Crossing& c) {
    return m.direction.dot(air.placeOf(c.from));
  };
  const auto [first, last] = std::minmax_element(
      crossings.begin(), crossings.end(),
      [&](const Crossing& a, const Crossing& b) { return along(a) < along(b); });
  const double cell = air.columns().cellSize();
  m.width = std::max(along(*last) - along(*first) + cell, n / std::sqrt(2.0) * cell);
  return m;
}

} // namespace

std::vector<RoomOpening>
openingsBetween(const AirGaps& air, RoomLabels& rooms)
{
  std::vector<RoomOpening> openings;
  for (const auto& [pair, all] : crossingsOf(air, rooms))
    for (const auto& crossings : parted(air, all)) {
      openings.push_back(measured(air, crossings));
      openings.back().a = pair.first;
      openings.back().b = pair.second;
    }
  return openings;
}

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
