// SPDX-License-Identifier: BSD-3-Clause
#include "room_opening.h"

#include "sedr_filters/src/base/symmetric_eigen.h"
#include "sedr_filters/src/grids/disjoint_sets.h"

#include <algorithm>
#include <cmath>
#include <map>
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

} // namespace pcl::sedr
