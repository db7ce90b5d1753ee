// SPDX-License-Identifier: BSD-3-Clause
#include "whole_openings.h"

#include <algorithm>
#include <set>
#include <utility>

namespace pcl::sedr {

bool
WholeOpenings::isPartOfDoor(std::uint32_t room, const MeasuredOpening& opening)
{
  if (opening.has_ends || opening.dip < parameters_.min_lintel ||
      opening.width > parameters_.widest_passage)
    return false;
  OfRoom& own = ofRoom(room);
  Whole& whole = own.wholes[own.at.at(keyOf(outOf(room, opening.crossing)))];
  if (!whole.measured)
    whole.measured = measures_.measure(whole.crossings, labels_);
  // Where columns stand in an opening, a piece between two of them is no whole.
  return whole.measured->width > opening.width &&
         whole.measured->depth <= parameters_.thickest_wall &&
         isDoor(*whole.measured, parameters_) &&
         std::min(whole.measured->jamb_a, whole.measured->jamb_b) >= parameters_.jamb;
}

std::vector<RoomPair>
WholeOpenings::afterJoining(const RoomPair& pair)
{
  known_.erase(pair.first);
  known_.erase(pair.second);
  std::set<RoomPair> changed;
  for (const std::uint32_t room : rooms_.room(pair.first).beside) {
    const auto own = known_.find(room);
    if (own == known_.end())
      continue;
    for (Whole& whole : own->second.wholes) {
      if (!whole.measured || !whole.measured->has_ends ||
          whole.measured->width > parameters_.widest_passage)
        continue; // it has no jambs, whatever the rooms are
      std::set<std::uint32_t> into;
      for (const Crossing& c : whole.crossings)
        into.insert(labels_.roomOf(c.to));
      if (into.erase(pair.first) == 0)
        continue;
      whole.measured.reset();
      for (const std::uint32_t other : into)
        changed.insert(std::minmax(room, other));
    }
  }
  return {changed.begin(), changed.end()};
}

WholeOpenings::OfRoom&
WholeOpenings::ofRoom(std::uint32_t room)
{
  const auto [entry, is_new] = known_.try_emplace(room);
  OfRoom& own = entry->second;
  if (!is_new)
    return own;
  std::vector<Crossing> around;
  for (const std::uint32_t other : rooms_.room(room).beside)
    for (const Crossing& c : rooms_.between(std::minmax(room, other)).crossings)
      around.push_back(outOf(room, c));
  // In an order that does not depend on that in which rooms were joined.
  std::sort(around.begin(), around.end(),
            [](const Crossing& a, const Crossing& b) { return keyOf(a) < keyOf(b); });
  for (auto& crossings : openingsOf(air_, around, 0)) {
    for (const Crossing& c : crossings)
      own.at[keyOf(c)] = own.wholes.size();
    own.wholes.push_back({std::move(crossings), {}});
  }
  return own;
}

} // namespace pcl::sedr
