// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "loop.h"

#include <optional>
#include <vector>

namespace pcl::sedr::sim {

/** @brief Parallel ribs or beams below a ceiling, from wall to wall. */
struct RibFamily {
  double direction = 0.0; ///< radians, along the ribs
  double spacing = 0.0;   ///< metres from one rib's middle to the next
  double width = 0.0;     ///< metres
  double depth = 0.0;     ///< metres below the ceiling
  /// Metres from the room's right end, seen along the ribs, to the middle of the first
  /// rib; empty: half the spacing.
  std::optional<double> first = std::nullopt;
};

/** @brief Returns the footprints of the ribs of every family, which do not overlap.
 *
 * Ribs end where they meet those of a later family, as joists do at a beam. A rib that
 * crosses the outline is cut at it, or left out at the ends of the room. Cost: ribs
 * times corners.
 * @param outline counter-clockwise, of straight elements
 */
std::vector<std::vector<Loop>> ribLoops(const Loop& outline,
                                        const std::vector<RibFamily>& families);

} // namespace pcl::sedr::sim
