// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/voxel_hash.h>

#include <atomic>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A box of voxels. */
struct VoxelBox {
  std::array<std::int64_t, 3> low{};
  std::array<std::int64_t, 3> high{}; ///< included

  bool holds(const VoxelCode& code) const
  {
    return code[0] >= low[0] && code[0] <= high[0] && code[1] >= low[1] &&
           code[1] <= high[1] && code[2] >= low[2] && code[2] <= high[2];
  }

  /** @brief Voxels in it; a double, for there may be more than any integer holds. */
  double volume() const
  {
    double volume = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
      volume *= static_cast<double>(high[axis] - low[axis] + 1);
    return volume;
  }
};

/** @brief Sorts voxels of a box by z, then y, then x without comparing any: each has a
 * bit of its own in that order, and its place is the number of bits that are set before
 * it. 12 bytes for 64 voxels of the box. */
class VoxelRanks {
public:
  explicit VoxelRanks(const VoxelBox& box)
      : box_(box)
      , words_(static_cast<std::size_t>(box.volume()) / 64 + 1)
      , bits_(new std::atomic<std::uint64_t>[words_]())
      , before_(words_)
  {}

  /** @brief Notes a voxel of the box, from any thread. */
  void mark(const VoxelCode& code)
  {
    const std::uint64_t bit = bitOf(code);
    bits_[bit / 64].fetch_or(std::uint64_t{1} << bit % 64, std::memory_order_relaxed);
  }

  /** @brief Numbers all voxels that were noted.
   * @return how many there are */
  std::size_t number()
  {
    std::size_t count = 0;
    for (std::size_t w = 0; w < words_; ++w) {
      before_[w] = static_cast<std::uint32_t>(count);
      count += std::bitset<64>(bits_[w].load(std::memory_order_relaxed)).count();
    }
    return count;
  }

  /** @brief Place of a voxel that was noted. */
  std::size_t rankOf(const VoxelCode& code) const
  {
    const std::uint64_t bit = bitOf(code);
    const std::uint64_t below = (std::uint64_t{1} << bit % 64) - 1;
    return before_[bit / 64] +
           std::bitset<64>(bits_[bit / 64].load(std::memory_order_relaxed) & below)
               .count();
  }

private:
  std::uint64_t bitOf(const VoxelCode& code) const
  {
    const auto at = [&](std::size_t axis) {
      return static_cast<std::uint64_t>(code[axis] - box_.low[axis]);
    };
    const auto size = [&](std::size_t axis) {
      return static_cast<std::uint64_t>(box_.high[axis] - box_.low[axis] + 1);
    };
    return (at(2) * size(1) + at(1)) * size(0) + at(0);
  }

  VoxelBox box_;
  std::size_t words_;
  std::unique_ptr<std::atomic<std::uint64_t>[]> bits_;
  std::vector<std::uint32_t> before_; ///< voxels before those of a word
};

} // namespace sedr
} // namespace pcl
