// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "quarter_turns.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace pcl::sedr {

/** @brief What is known of the gaps between the directions around a point. */
enum class Gap { None, Wide, Unknown };

/** @brief Directions sorted into 64 sectors, the bits of a word: they tell wide gaps
 * between directions without an arc tangent for each. */
class DirectionSectors {
public:
  /** @param angle widest gap that is none, radians */
  explicit DirectionSectors(float angle);

  /** @brief The bit of the sector of a direction other than (0, 0). */
  static std::uint64_t bitOf(float x, float y)
  {
    const auto sector =
        static_cast<unsigned>(quarterTurns(x, y) * (static_cast<float>(sectors) / 4));
    return std::uint64_t{1} << std::min(sector, sectors - 1);
  }

  /** @brief Whether the `seen` sectors surely leave no gap wider than the angle: what
   * gapOf() says, quickly, where they are close. */
  bool areClose(std::uint64_t seen) const
  {
    if (min_run_ == 0)
      return false;
    // Bits that begin a run of so many empty sectors.
    std::uint64_t empty = ~seen;
    for (unsigned left = min_run_ - 1, step = 1; left > 0 && empty != 0; step *= 2) {
      const unsigned by = std::min(step, left);
      empty &= empty >> by | empty << (sectors - by);
      left -= by;
    }
    return empty == 0;
  }

  /** @brief Whether directions in the `seen` sectors leave a gap wider than the angle;
   * Unknown where that depends on where in the sectors they are, or there are none. */
  Gap gapOf(std::uint64_t seen) const;

private:
  static constexpr unsigned sectors = 64;

  /** @brief From where a sector begins to where the last of so many ends, radians. */
  float turnOver(unsigned first, unsigned count) const;

  float angle_;
  unsigned min_run_ = 0; ///< as many empty sectors may be a gap; 0: as none too
  std::array<float, sectors + 1> from_{}; ///< where each sector begins, radians
};

} // namespace pcl::sedr
