// SPDX-License-Identifier: BSD-3-Clause
#include "room_borders.h"

#include "gap_distance.h"
#include "wall_beside.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

RoomPair
pairOf(std::uint32_t a, std::uint32_t b)
{
  return std::minmax(a, b);
}

/** @brief The gap behind the wall at which another ends, `none` if there is none within
 * `reach` columns, or no wall as seen from either of the two: where air ends at stairs,
 * at furniture or at the edge of a gallery there is none. */
std::uint32_t
facedFrom(const AirGaps& air, std::uint32_t g, int d, int reach)
{
  std::uint32_t column = air[g].column;
  for (int step = 0; step <= reach; ++step) {
    column = air.columns().neighbour(column, d);
    if (column == VoxelColumns::none)
      return AirGaps::none;
    const std::uint32_t o = air.goingOnFrom(air[g], column);
    if (o != AirGaps::none) {
      const bool is_wall =
          step > 0 && (isWallBeside(air, g, d) || isWallBeside(air, o, (d + 2) % 4));
      return is_wall ? o : AirGaps::none;
    }
  }
  return AirGaps::none;
}

/** @brief Collects the steps from one room to another, by pairs of rooms; `next` tells
 * the gap to which there is one from a gap in a direction. */
template <typename Next>
std::map<RoomPair, std::vector<Crossing>>
stepsBetween(const AirGaps& air, RoomLabels& labels, Next next)
{
  std::map<RoomPair, std::vector<Crossing>> steps;
  for (std::uint32_t g = 0; g < air.size(); ++g)
    for (int d = 0; d < 4; ++d) {
      const std::uint32_t o = next(g, d);
      if (o == AirGaps::none || !labels.hasRoom(g) || !labels.hasRoom(o))
        continue;
      const std::uint32_t a = labels.roomOf(g);
      const std::uint32_t b = labels.roomOf(o);
      if (a < b)
        steps[{a, b}].push_back({g, o});
      else if (b < a && air.link(g, d) == AirGaps::none)
        steps[{b, a}].push_back({o, g}); // one climbs one way, links go both
    }
  return steps;
}

} // namespace

std::map<RoomPair, std::vector<Crossing>>
waysBetween(const AirGaps& air, RoomLabels& labels)
{
  return stepsBetween(air, labels, [&](std::uint32_t g, int d) {
    return air.isDrop(g, d)                  ? AirGaps::none
           : air.link(g, d) == AirGaps::none ? air.climb(g, d)
                                             : air.link(g, d);
  });
}

RoomBorders::RoomBorders(const AirGaps& air,
                         const PartingParameters& parameters,
                         RoomLabels& labels)
    : labels_(labels)
    , column_area_(air.columns().cellSize() * air.columns().cellSize())
    , rooms_(labels.sizes().size())
{
  measureRooms(air);
  const auto link = [&](std::uint32_t g, int d) { return air.link(g, d); };
  for (auto& [pair, crossings] : stepsBetween(air, labels, link))
    borders_[pair].crossings = std::move(crossings);
  countWalls(air, static_cast<int>(std::lround(2 * parameters.lintel_reach /
                                               air.columns().cellSize())));
  for (auto& [pair, border] : borders_) {
    rooms_[pair.first].beside.insert(pair.second);
    rooms_[pair.second].beside.insert(pair.first);
  }
}

double
RoomBorders::openShare(std::uint32_t room) const
{
  std::size_t open = 0;
  for (const std::uint32_t other : rooms_[room].beside)
    open += between(pairOf(room, other)).crossings.size();
  return static_cast<double>(open) /
         static_cast<double>(std::max<std::size_t>(1, open + rooms_[room].ends));
}

bool
RoomBorders::areStacked(const RoomPair& pair) const
{
  constexpr double most = 0.5; // of the gaps of the smaller room
  const auto [a, b] = pair;
  const auto shared = rooms_[a].stacked.find(b);
  return shared != rooms_[a].stacked.end() &&
         static_cast<double>(shared->second) * column_area_ >
             most * std::min(rooms_[a].area, rooms_[b].area);
}

void
RoomBorders::join(const RoomPair& pair)
{
  const auto [a, b] = pair;
  labels_.join(a, b);
  RoomExtent& into = rooms_[a];
  RoomExtent& joined = rooms_[b];
  into.area += joined.area;
  into.depth = std::max(into.depth, joined.depth);
  into.ends += joined.ends;
  into.floors.add(joined.floors);
  into.roofs.add(joined.roofs);
  borders_.erase(pair);
  into.beside.erase(b);
  joined.beside.erase(a);
  for (const std::uint32_t other : joined.beside) {
    RoomBorder moved = std::move(borders_.extract(pairOf(b, other)).mapped());
    RoomBorder& border = borders_[pairOf(a, other)];
    for (Crossing c : moved.crossings) {
      if (labels_.roomOf(c.from) > labels_.roomOf(c.to))
        std::swap(c.from, c.to);
      border.crossings.push_back(c);
    }
    border.walls += moved.walls;
    rooms_[other].beside.erase(b);
    rooms_[other].beside.insert(a);
    into.beside.insert(other);
  }
  joined.beside.clear();
  into.stacked.erase(b);
  for (const auto& [other, pairs] : joined.stacked) {
    rooms_[other].stacked.erase(b);
    if (other == a)
      continue;
    into.stacked[other] += pairs;
    rooms_[other].stacked[a] += pairs;
  }
  joined.stacked.clear();
}

void
RoomBorders::measureRooms(const AirGaps& air)
{
  const double cell = air.columns().cellSize();
  for (std::size_t r = 0; r < rooms_.size(); ++r)
    rooms_[r].area = static_cast<double>(labels_.sizes()[r]) * column_area_;
  const std::vector<float> free = distanceToRim(air);
  for (std::uint32_t g = 0; g < air.size(); ++g)
    if (labels_.hasRoom(g)) {
      RoomExtent& own = rooms_[labels_.roomOf(g)];
      own.depth = std::max<double>(own.depth, free[g] * cell);
      own.floors.add(air.columns().heightOf(air[g].low));
      for (std::uint32_t o = air.first(air[g].column); o < g; ++o) {
        if (air.height(o) >= air.parameters().headroom)
          own.roofs.add(air.columns().heightOf(air[o].high));
        if (labels_.hasRoom(o) && !labels_.isSameRoom(o, g)) {
          ++own.stacked[labels_.roomOf(o)];
          ++rooms_[labels_.roomOf(o)].stacked[labels_.roomOf(g)];
        }
      }
    }
}

/** @brief Counts where rooms end, and where behind it another begins. */
void
RoomBorders::countWalls(const AirGaps& air, int reach)
{
  std::map<RoomPair, std::size_t> faces;
  for (std::uint32_t g = 0; g < air.size(); ++g) {
    if (!labels_.hasRoom(g))
      continue;
    for (int d = 0; d < 4; ++d) {
      if (air.link(g, d) != AirGaps::none)
        continue;
      ++rooms_[labels_.roomOf(g)].ends;
      const std::uint32_t faced = facedFrom(air, g, d, reach);
      if (faced != AirGaps::none && labels_.hasRoom(faced) &&
          !labels_.isSameRoom(faced, g))
        ++faces[pairOf(labels_.roomOf(g), labels_.roomOf(faced))];
    }
  }
  for (const auto& [pair, n] : faces)
    borders_[pair].walls = (n + 1) / 2; // each is met from both sides
}

} // namespace pcl::sedr
