// SPDX-License-Identifier: BSD-3-Clause
#include "agreed_rooms.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <queue>
#include <set>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief A set of places, and how many of them are in each room of each partition. */
struct PlaceSet {
  double size = 0;
  std::vector<std::map<std::int32_t, double>> rooms;
};

/** @brief How much two sets are one room: of all pairs of places of both, the votes for
 * it without those against it, in the mean. */
double
agreementOn(const PlaceSet& a, const PlaceSet& b)
{
  double votes = 0;
  for (std::size_t p = 0; p < a.rooms.size(); ++p) {
    double of_a = 0;
    double of_b = 0;
    double same = 0;
    for (const auto& [room, n] : b.rooms[p])
      of_b += n;
    for (const auto& [room, n] : a.rooms[p]) {
      of_a += n;
      const auto found = b.rooms[p].find(room);
      same += found == b.rooms[p].end() ? 0 : n * found->second;
    }
    const double weight = p == 0 ? 2 : 1; // decides between as many others
    votes += weight * (2 * same - of_a * of_b);
  }
  return votes / (a.size * b.size);
}

/** @brief Joins sets until no two agree that they are one room. */
class Agreement {
public:
  explicit Agreement(std::vector<PlaceSet> sets)
      : sets_(std::move(sets))
      , joined_to_(sets_.size())
      , in_room_(sets_.empty() ? 0 : sets_.front().rooms.size())
  {
    for (std::size_t s = 0; s < sets_.size(); ++s) {
      joined_to_[s] = s;
      enter(s);
    }
    for (std::size_t s = 0; s < sets_.size(); ++s)
      compare(s, [&](std::size_t other) { return other < s; });
  }

  /** @brief Returns the number of the set that each has become part of. */
  std::vector<std::size_t> joinAll()
  {
    while (!pairs_.empty()) {
      const Pair pair = pairs_.top();
      pairs_.pop();
      if (joined_to_[pair.a] != pair.a || joined_to_[pair.b] != pair.b)
        continue; // one of them is part of another meanwhile
      join(pair.a, pair.b);
    }
    for (std::size_t s = 0; s < joined_to_.size(); ++s) // to later sets only
      for (std::size_t& to = joined_to_[s]; joined_to_[to] != to;)
        to = joined_to_[to];
    return joined_to_;
  }

private:
  struct Pair {
    double agreement;
    std::size_t a;
    std::size_t b;

    bool operator<(const Pair& other) const
    {
      return std::pair(agreement, std::pair(other.a, other.b)) <
             std::pair(other.agreement, std::pair(a, b));
    }
  };

  /** @brief Joins two sets to a new one. */
  void join(std::size_t a, std::size_t b)
  {
    const std::size_t both = sets_.size();
    PlaceSet set = std::move(sets_[a]);
    set.size += sets_[b].size;
    for (std::size_t p = 0; p < set.rooms.size(); ++p)
      for (const auto& [room, n] : sets_[b].rooms[p])
        set.rooms[p][room] += n;
    sets_.push_back(std::move(set));
    joined_to_.push_back(both);
    joined_to_[a] = joined_to_[b] = both;
    enter(both);
    compare(both, [](std::size_t) { return true; });
  }

  void enter(std::size_t s)
  {
    for (std::size_t p = 0; p < in_room_.size(); ++p)
      for (const auto& entry : sets_[s].rooms[p])
        in_room_[p][entry.first].insert(s);
  }

  /** @brief Remembers the sets that agree with one, of those that share a room with it
   * in a partition and that `is_asked` names; others cannot. */
  template <typename IsAsked>
  void compare(std::size_t s, IsAsked is_asked)
  {
    std::set<std::size_t> others;
    for (std::size_t p = 0; p < in_room_.size(); ++p)
      for (const auto& entry : sets_[s].rooms[p]) {
        std::set<std::size_t>& in_room = in_room_[p][entry.first];
        for (auto it = in_room.begin(); it != in_room.end();) {
          const std::size_t other = *it;
          if (joined_to_[other] != other) {
            it = in_room.erase(it);
            continue;
          }
          if (other != s && is_asked(other))
            others.insert(other);
          ++it;
        }
      }
    for (const std::size_t other : others)
      if (const double agreement = agreementOn(sets_[other], sets_[s]); agreement > 0)
        pairs_.push({agreement, std::min(s, other), std::max(s, other)});
  }

  std::vector<PlaceSet> sets_;
  std::vector<std::size_t> joined_to_; ///< itself if it is part of no other
  std::vector<std::map<std::int32_t, std::set<std::size_t>>> in_room_;
  std::priority_queue<Pair> pairs_;
};

} // namespace

std::vector<std::int32_t>
agreedRooms(const std::vector<std::vector<std::int32_t>>& rooms)
{
  std::map<std::vector<std::int32_t>, std::size_t> number;
  std::vector<PlaceSet> sets;
  const std::size_t places = rooms.empty() ? 0 : rooms.front().size();
  std::vector<std::optional<std::size_t>> set_of(places);
  for (std::size_t i = 0; i < places; ++i) {
    std::vector<std::int32_t> here;
    here.reserve(rooms.size());
    for (const auto& partition : rooms)
      here.push_back(std::max(partition[i], -1));
    if (*std::max_element(here.begin(), here.end()) < 0)
      continue;
    const auto [entry, is_new] = number.emplace(std::move(here), sets.size());
    set_of[i] = entry->second;
    if (is_new)
      sets.push_back({0, std::vector<std::map<std::int32_t, double>>(rooms.size())});
    PlaceSet& set = sets[entry->second];
    ++set.size;
    for (std::size_t p = 0; p < rooms.size(); ++p)
      if (entry->first[p] >= 0)
        ++set.rooms[p][entry->first[p]];
  }
  const std::vector<std::size_t> joined = Agreement(std::move(sets)).joinAll();
  std::vector<std::int32_t> agreed(places, -1);
  for (std::size_t i = 0; i < places; ++i)
    if (set_of[i])
      agreed[i] = static_cast<std::int32_t>(joined[*set_of[i]]);
  return agreed;
}

} // namespace pcl::sedr
