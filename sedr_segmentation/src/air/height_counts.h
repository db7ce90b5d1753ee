// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

namespace pcl::sedr {

/** @brief Heights in bins of 5 cm: at which of them a room has a level. */
class HeightCounts {
public:
  /** @brief Least share of a room's heights that makes its floor: what is less is a
   * hole in it, what is higher stands on it. */
  static constexpr double share_of_floor = 0.2;

  void add(double height) { ++bins_[std::lround(height / bin)]; }

  void add(const HeightCounts& other)
  {
    for (const auto& [at, n] : other.bins_)
      bins_[at] += n;
  }

  bool empty() const { return bins_.empty(); }

  /** @brief How many they are. */
  double total() const
  {
    double sum = 0;
    for (const auto& entry : bins_)
      sum += static_cast<double>(entry.second);
    return sum;
  }

  /** @brief The lowest height around which at least `share` of all lie, metres. */
  double lowestOf(double share) const
  {
    for (const auto& entry : bins_)
      if (static_cast<double>(around(entry.first)) >= share * total())
        return middleOf(entry.first);
    return highestCount();
  }

  /** @brief The height around which most lie. */
  double highestCount() const
  {
    long best = bins_.empty() ? 0 : bins_.begin()->first;
    for (const auto& entry : bins_)
      if (around(entry.first) > around(best))
        best = entry.first;
    return middleOf(best);
  }

private:
  static constexpr double bin = 0.05; // metres

  std::size_t count(long at) const
  {
    const auto found = bins_.find(at);
    return found == bins_.end() ? 0 : found->second;
  }

  std::size_t around(long at) const
  {
    return count(at - 1) + count(at) + count(at + 1);
  }

  /** @brief The mean height of a bin and those beside it. */
  double middleOf(long at) const
  {
    double sum = 0;
    for (long k = at - 1; k <= at + 1; ++k)
      sum += bin * static_cast<double>(k) * static_cast<double>(count(k));
    return sum / std::max<double>(1, static_cast<double>(around(at)));
  }

  std::map<long, std::size_t> bins_;
};

} // namespace pcl::sedr
