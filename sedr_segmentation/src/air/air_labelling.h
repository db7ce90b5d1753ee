// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../labelling/minimum_cut.h"
#include "air_gaps.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Which of some places, columns in which not all ends of the air were seen, are
 * what a scan leaves open of known air: the answers of least cost, by a minimum cut.
 * The unit of cost is an edge of known air, as long as a column is wide, at which
 * nothing was seen that ends it. */
class AirLabelling {
public:
  AirLabelling(std::size_t places, const AirGaps& air)
      : energy_(places)
      , unseen_(air.columns().cellSize() / air.parameters().largest_unseen)
  {}

  /** @brief Of the place neither end was seen: a patch of such places is closed if its
   * area over the length of its edge is less than AirParameters::largest_unseen. */
  void addUnseen(std::size_t place) { energy_.addTerm(place, 0, unseen_); }

  /** @brief Beside the place is known air, which ends there if it is none. */
  void addKnown(std::size_t place) { energy_.addTerm(place, 1, 0); }

  /** @brief Beside the place is neither air nor what ends it. */
  void addOpen(std::size_t place) { energy_.addTerm(place, 0, open); }

  /** @brief Beside the place is what ends air: the voids in slabs and walls have much
   * of that and hardly any known air. */
  void addEnd(std::size_t place) { energy_.addTerm(place, 0, end); }

  /** @brief Beside the place is another, which goes on from it; told by both.
   * @param is_alike whether as much was seen of it: air does not end there */
  void addOther(std::size_t place, std::size_t other, bool is_alike = true)
  {
    const double border = is_alike ? alike : open;
    energy_.addPair(place, other, 0, border / 2, border / 2, 0);
  }

  /** @brief Returns 1 for each place that is air. */
  std::vector<std::uint8_t> solve() const { return energy_.minimise(); }

private:
  // In units of cost.
  static constexpr double open = 3; ///< air that is left open was mostly seen through
                                    ///< glass or a door
  static constexpr double end = 0.1;
  static constexpr double alike = 10;

  BinaryEnergy energy_;
  double unseen_;
};

} // namespace pcl::sedr
