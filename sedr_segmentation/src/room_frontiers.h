// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_pieces.h"

#include <map>
#include <utility>

namespace pcl {
namespace sedr {

/** @brief How two pieces face each other, in cell edges. */
struct Frontier {
  std::size_t wall = 0;
  std::size_t plain = 0; ///< nothing below: a step, a soffit
  std::vector<CellKey>
      passage; ///< below a beam or a lintel, or between two jambs: perhaps a doorway
  std::size_t hidden = 0; ///< something above, furniture below
};

/** @brief By the positions of two pieces, the smaller one first. */
using Frontiers = std::map<std::pair<std::size_t, std::size_t>, Frontier>;

/** @brief Where pieces face each other across at most 0.4 m each.
 * @param passages cells between pieces, in openings as high as the rooms */
Frontiers frontiersOf(const Storey& storey,
                      const std::vector<Piece>& pieces,
                      const CellMask& passages);

} // namespace sedr
} // namespace pcl
