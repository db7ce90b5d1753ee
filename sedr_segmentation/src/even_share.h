// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace pcl {
namespace sedr {

/** @brief An even share of what is numbered: about as many of any numbers that follow
 * one another, or that a step apart, are in it. Told by the fractional part of their
 * multiples of the golden ratio (Knuth 1973, section 6.4). */
class EvenShare {
public:
  /** @param share from 0 on; 1 or more for all */
  explicit EvenShare(double share = 1)
      : last_(share < 1 ? static_cast<std::uint32_t>(share * 4294967296.0)
                        : std::numeric_limits<std::uint32_t>::max())
  {}

  bool holds(std::size_t number) const { return placeOf(number) <= last_; }

  /** @brief The share in 128ths, rounded up. */
  std::uint8_t parts() const
  {
    return static_cast<std::uint8_t>((last_ >> bits_of_place) + 1);
  }

  /** @brief Whether a number may be in a share of at most so many 128ths. */
  static bool mayHold(std::uint8_t parts, std::size_t number)
  {
    return placeOf(number) >> bits_of_place < parts;
  }

private:
  static constexpr std::uint32_t golden_ratio = 2654435769; ///< of 2^32
  static constexpr int bits_of_place = 25;                  ///< within a 128th

  static std::uint32_t placeOf(std::size_t number)
  {
    return static_cast<std::uint32_t>(number) * golden_ratio;
  }

  std::uint32_t last_;
};

} // namespace sedr
} // namespace pcl
