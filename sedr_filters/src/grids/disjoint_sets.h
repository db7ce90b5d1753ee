// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace pcl::sedr {

/** @brief Disjoint sets of 0 .. n - 1 (union-find with path halving). The lowest member
 * represents its set, so results do not depend on the order of joins. */
template <typename Index = std::uint32_t>
class DisjointSets {
public:
  explicit DisjointSets(std::size_t n)
      : parent_(n)
  {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  /** @brief Returns the member that represents the set of i. */
  Index find(Index i)
  {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void join(Index a, Index b)
  {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<Index> parent_;
};

} // namespace pcl::sedr
