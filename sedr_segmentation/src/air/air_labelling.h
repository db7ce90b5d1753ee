// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../labelling/minimum_cut.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Which of some places, columns in which not all ends of the air were seen, are
 * what a scan leaves open of known air: the answers of least cost, by a minimum cut.
 * The unit of cost is an edge of known air, or of what is added to it, as long as a
 * column is wide, at which nothing was seen that ends air. */
class AirLabelling {
public:
  /** @param cell edge of a column, metres
   * @param largest a patch of which neither end was seen is closed if its area over the
   * length of its edge is less, metres; a wall hidden on both sides has less known air
   * around it */
  AirLabelling(std::size_t places, double cell, double largest)
      : energy_(places)
      , unseen_(cell / largest)
  {}

  /** @brief Of the place neither end was seen. */
  void addUnseen(std::size_t place) { energy_.addTerm(place, 0, unseen_); }

  /** @brief Beside the place is known air, which ends there if it is none. */
  void addKnown(std::size_t place) { energy_.addTerm(place, 1, 0); }

  /** @brief Beside the place is neither air nor what ends it. */
  void addOpen(std::size_t place) { energy_.addTerm(place, 0, open); }

  /** @brief Beside the place is what ends air: the voids in slabs and walls have much
   * of that and hardly any known air. */
  void addEnd(std::size_t place) { energy_.addTerm(place, 0, end); }

  /** @brief Beside the place is another, which goes on from it; told by both. */
  void addOther(std::size_t place, std::size_t other)
  {
    energy_.addPair(place, other, 0, 0.5, 0.5, 0);
  }

  /** @brief Returns 1 for each place that is air. */
  std::vector<std::uint8_t> solve() const { return energy_.minimise(); }

private:
  static constexpr double open = 3; ///< in units of cost: air that is left open was
                                    ///< mostly seen through glass or a door
  static constexpr double end = 0.1;

  BinaryEnergy energy_;
  double unseen_;
};

} // namespace pcl::sedr
