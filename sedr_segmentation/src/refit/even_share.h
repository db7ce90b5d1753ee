// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <cstring>
#include <limits>

namespace pcl {
namespace sedr {

/** @brief A share of points that is told by where each of them is, and by nothing else:
 * not by their order nor by points beside them. */
class EvenShare {
public:
  /** @param share from 0 on; 1 or more for all */
  explicit EvenShare(double share = 1)
      : last_(share < 1 ? static_cast<std::uint32_t>(share * 4294967296.0)
                        : std::numeric_limits<std::uint32_t>::max())
  {}

  /** @brief The number by which a point is in shares, as if drawn at random: that in
   * some share is in all larger ones. */
  static std::uint32_t numberOf(const Eigen::Vector3f& p)
  {
    std::uint32_t bits[3];
    std::memcpy(bits, p.data(), sizeof bits);
    std::uint64_t mixed = bits[0] * 0x9E3779B97F4A7C15U;
    mixed = (mixed ^ (mixed >> 32) ^ bits[1]) * 0xBF58476D1CE4E5B9U;
    mixed = (mixed ^ (mixed >> 32) ^ bits[2]) * 0x94D049BB133111EBU;
    return static_cast<std::uint32_t>(mixed >> 32);
  }

  bool holds(std::uint32_t number) const { return number <= last_; }

  /** @brief The share in 128ths, rounded up. */
  std::uint8_t parts() const
  {
    return static_cast<std::uint8_t>((last_ >> bits_of_part) + 1);
  }

  /** @brief Whether a number may be in a share of at most so many 128ths. */
  static bool mayHold(std::uint8_t parts, std::uint32_t number)
  {
    return number >> bits_of_part < parts;
  }

private:
  static constexpr int bits_of_part = 25; ///< of the numbers in a 128th

  std::uint32_t last_;
};

} // namespace sedr
} // namespace pcl
