// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief Costs of a closed sequence of places with a few candidate labels each. */
struct CycleCosts {
  std::size_t labels = 0;     ///< candidates a place
  std::vector<double> own;    ///< of each candidate: `labels` a place
  std::vector<double> change; ///< from each candidate to each of the next place: labels
                              ///< squared a place; 0 from a label to itself
  std::vector<double> entry;  ///< of a change to each candidate: `labels` a place

  std::size_t places() const { return labels == 0 ? 0 : own.size() / labels; }
};

/** @brief Returns the candidate of each place such that the sum of all costs is least:
 * Viterbi along the cycle with any ends, which is exact where these agree; else the
 * cheapest cycle through the candidate that this gave half-way, far from both ends.
 * O(places x labels^2). */
std::vector<std::size_t> cheapestCycle(const CycleCosts& costs);

} // namespace pcl::sedr
