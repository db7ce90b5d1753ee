// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/disjoint_sets.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief The room of each gap, while rooms are joined. Rooms are numbered by size,
 * largest first; of joined rooms the lower number stays. */
class RoomLabels {
public:
  static constexpr std::int32_t no_room = -1;

  /** @param label of each gap, any numbers from 0, no_room for none */
  explicit RoomLabels(std::vector<std::int32_t> label)
      : label_(std::move(label))
      , sizes_(numberBySize())
      , sets_(sizes_.size())
  {}

  bool hasRoom(std::uint32_t g) const { return label_[g] != no_room; }

  /** @brief The room of a gap that has one. */
  std::uint32_t roomOf(std::uint32_t g)
  {
    return rootOf(static_cast<std::uint32_t>(label_[g]));
  }

  /** @brief The room that one was joined to. */
  std::uint32_t rootOf(std::uint32_t room) { return sets_.find(room); }

  /** @brief Whether two gaps are of one room, or both of none. */
  bool isSameRoom(std::uint32_t g, std::uint32_t o)
  {
    return hasRoom(g) && hasRoom(o) ? roomOf(g) == roomOf(o) : hasRoom(g) == hasRoom(o);
  }

  void join(std::uint32_t a, std::uint32_t b) { sets_.join(a, b); }

  /** @brief Gaps of each room as it was before any joins. */
  const std::vector<std::size_t>& sizes() const { return sizes_; }

  /** @brief The room of each gap, numbered anew. */
  std::vector<std::int32_t> joined()
  {
    std::vector<std::int32_t> label(label_.size(), no_room);
    for (std::uint32_t g = 0; g < label.size(); ++g)
      if (hasRoom(g))
        label[g] = static_cast<std::int32_t>(roomOf(g));
    return RoomLabels(std::move(label)).label_;
  }

private:
  std::vector<std::size_t> numberBySize()
  {
    std::map<std::int32_t, std::size_t> size;
    for (const std::int32_t l : label_)
      if (l != no_room)
        ++size[l];
    std::vector<std::pair<std::size_t, std::int32_t>> order;
    for (const auto& [l, n] : size)
      order.emplace_back(n, l);
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::map<std::int32_t, std::int32_t> number;
    std::vector<std::size_t> sizes;
    for (const auto& [n, l] : order) {
      number[l] = static_cast<std::int32_t>(sizes.size());
      sizes.push_back(n);
    }
    for (std::int32_t& l : label_)
      if (l != no_room)
        l = number[l];
    return sizes;
  }

  std::vector<std::int32_t> label_;
  std::vector<std::size_t> sizes_;
  DisjointSets<> sets_;
};

} // namespace pcl::sedr
