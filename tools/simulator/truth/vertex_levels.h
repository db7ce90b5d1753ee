// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_regions.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace pcl::sedr::sim {

/** @brief The heights at which a plan point has a vertex; equal up to rounding means
 * one. */
class VertexLevels {
public:
  void insert(double z)
  {
    const auto next = firstFrom(z);
    if (next == levels_.end() || *next > z + kSameHeight)
      levels_.insert(next, z);
  }

  /** @brief Returns the level equal to @p z, which was inserted before. */
  double at(double z) const
  {
    const auto level = firstFrom(z);
    if (level == levels_.end() || *level > z + kSameHeight)
      throw std::logic_error("A vertex has a height that is none of its point's");
    return *level;
  }

  /** @brief Returns all levels from @p low to @p high, which were inserted before. */
  std::vector<double> within(double low, double high) const
  {
    return {firstFrom(low), std::next(firstFrom(high))};
  }

private:
  std::vector<double>::const_iterator firstFrom(double z) const
  {
    return std::lower_bound(levels_.begin(), levels_.end(), z - kSameHeight);
  }

  std::vector<double> levels_; ///< ascending
};

} // namespace pcl::sedr::sim
