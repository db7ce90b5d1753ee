// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief Costs of a closed sequence of places with a few candidate labels each. */
struct CycleCosts {
  std::vector<std::size_t> first; ///< first candidate of each place, and the end
  std::vector<std::size_t> pairs; ///< first change from each place, and the end
  std::vector<double> own;        ///< of each candidate
  std::vector<float> change; ///< from each candidate of a place to each of the next; 0
                             ///< from a label to itself
  std::vector<double> entry; ///< of a change to each candidate

  std::size_t places() const { return first.empty() ? 0 : first.size() - 1; }

  std::size_t candidates(std::size_t place) const
  {
    return first[place + 1] - first[place];
  }
};

/** @brief Returns the candidate of each place such that the sum of all costs is least:
 * Viterbi along the cycle with any ends, which is exact where these agree; else the
 * cheapest cycle through the candidate that this gave half-way, far from both ends.
 * O(changes). Every place needs a candidate. */
std::vector<std::size_t> cheapestCycle(const CycleCosts& costs);

/** @brief Finds the cheapest candidates of `steps` - 1 places after the place `from`;
 * it and the place `steps` after it keep theirs. O(changes on the way).
 * @param labels the candidate of each place */
void cheapestWay(const CycleCosts& costs,
                 std::size_t from,
                 std::size_t steps,
                 std::vector<std::size_t>& labels);

} // namespace pcl::sedr
