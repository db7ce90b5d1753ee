// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A place that some points of a scan were taken from. */
struct ScanPosition {
  /// Number of the first of these points; the last is before that of the next position.
  std::size_t first_row = 0;
  /// Metres, in the frame of the points; NaN where the place is not known.
  Eigen::Vector3f place = Eigen::Vector3f::Zero();

  bool isKnown() const { return place.allFinite(); }
};

/** @brief Where all points of a scan were taken from, by increasing `first_row`; empty
 * where nothing is known. */
using ScanPositions = std::vector<ScanPosition>;

/** @brief Number of the position that a row was taken from; of rows before the first
 * position it is positions.size(). O(log n) for n positions. */
inline std::size_t
positionOfRow(const ScanPositions& positions, std::size_t row)
{
  const auto after = std::upper_bound(positions.begin(), positions.end(), row,
                                      [](std::size_t r, const ScanPosition& position) {
                                        return r < position.first_row;
                                      });
  return after == positions.begin()
             ? positions.size()
             : static_cast<std::size_t>(after - positions.begin()) - 1;
}

} // namespace sedr
} // namespace pcl
