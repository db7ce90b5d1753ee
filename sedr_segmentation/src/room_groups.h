// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_pieces.h"

namespace pcl {
namespace sedr {

/** @brief Group of every piece: first what meets without anything between, then what
 * meets below beams, for a beam may part each of two rows of coffers from the other by
 * bits, and a half of a ceiling alone makes a doorway look wide.
 * @param passages cells between pieces, in openings as high as the rooms */
std::vector<std::size_t> groupPieces(const Storey& storey,
                                     const std::vector<Piece>& pieces,
                                     const CellMask& passages);

} // namespace sedr
} // namespace pcl
