// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <deque>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief A voxel along x, y and z: floor(coordinate / leaf). */
using VoxelCode = std::array<std::int32_t, 3>;

/** @brief A voxel and the sum of its points; trivially copyable, also to another
 * process. Its VoxelFrame interprets the numbers. */
struct VoxelSum {
  VoxelCode code;
  std::uint32_t count;              ///< number of points
  std::array<std::uint64_t, 3> sum; ///< sums of steps along x, y and z, modulo 2^64

  /** @brief Adds another sum of the same voxel. */
  VoxelSum& operator+=(const VoxelSum& other)
  {
    count += other.count;
    for (std::size_t axis = 0; axis < 3; ++axis)
      sum[axis] += other.sum[axis];
    return *this;
  }
};

/** @brief The positions of the voxels and the arithmetic of their sums: coordinates are
 * integer steps, so sums are exact in any order.
 *
 * A step is a power of two between 2^-31 and 2^-30 leaves. Coordinates farther from 0
 * than 2^-7 leaves are exact multiples of a step; nearer ones are rounded, to 0.05 nm
 * at a leaf of 5 cm. Sums are taken modulo 2^64, and means relative to the voxel's
 * corner, so that 2^31 points of a voxel cannot overflow. */
class VoxelFrame {
public:
  /** @param inverse_leaf one over the edges of a voxel, per metre, finite and > 0 */
  explicit VoxelFrame(const Eigen::Array3f& inverse_leaf)
      : inverse_leaf_(inverse_leaf)
  {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double leaf = 1 / static_cast<double>(inverse_leaf[static_cast<int>(axis)]);
      steps_[axis] = std::ldexp(1., 30 - std::ilogb(leaf));
      corner_steps_[axis] = leaf * steps_[axis];
    }
  }

  /** @brief Checks that a point is finite and nearer to 0 than 2^30 leaves along each
   * axis: 53,000 km at 5 cm. */
  bool holds(const Eigen::Vector3f& point) const
  {
    return ((point.array() * inverse_leaf_).abs() < limit).all();
  }

  /** @brief Returns the voxel of a finite point; of one too far away, one that holds no
   * point. */
  VoxelCode codes(const Eigen::Vector3f& point) const
  {
    const Eigen::Array3f scaled =
        (point.array() * inverse_leaf_).max(-limit).min(limit);
    return {cellOf(scaled[0]), cellOf(scaled[1]), cellOf(scaled[2])};
  }

  /** @brief Returns the sum of a single point that the frame holds. */
  VoxelSum sumOf(const Eigen::Vector3f& point) const
  {
    VoxelSum sum{{}, 1, {}};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<Eigen::Index>(axis);
      sum.code[axis] = cellOf(point[i] * inverse_leaf_[i]);
      sum.sum[axis] = stepsOf(static_cast<double>(point[i]) * steps_[axis]);
    }
    return sum;
  }

  /** @brief Returns the mean of a voxel's points; its count must not be 0. */
  Eigen::Vector3f mean(const VoxelSum& voxel) const
  {
    Eigen::Vector3f mean;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto corner = std::llround(voxel.code[axis] * corner_steps_[axis]);
      const auto sum = static_cast<std::int64_t>(
          voxel.sum[axis] - voxel.count * static_cast<std::uint64_t>(corner));
      const double beside = static_cast<double>(sum) / voxel.count;
      mean[static_cast<Eigen::Index>(axis)] =
          static_cast<float>((static_cast<double>(corner) + beside) / steps_[axis]);
    }
    return mean;
  }

private:
  static constexpr float limit = 1 << 30;

  /** @brief Returns floor(scaled). */
  static std::int32_t cellOf(float scaled)
  {
    const auto cell = static_cast<std::int32_t>(scaled);
    return cell - (scaled < static_cast<float>(cell) ? 1 : 0);
  }

  /** @brief Rounds a number of steps below 2^62. */
  static std::uint64_t stepsOf(double steps)
  {
    constexpr double whole = 2251799813685248.; // 2^51: larger ones have no fraction
    if (std::abs(steps) >= whole)
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(steps));
    // In a double of the size of the shift the last bit has the value 1.
    constexpr double shift = 3 * whole;
    constexpr std::uint64_t shift_bits = 0x4338000000000000u;
    const double shifted = steps + shift;
    std::uint64_t bits = 0;
    std::memcpy(&bits, &shifted, sizeof bits);
    return bits - shift_bits;
  }

  Eigen::Array3f inverse_leaf_;
  std::array<double, 3> steps_{};        ///< steps per metre, powers of two
  std::array<double, 3> corner_steps_{}; ///< steps from a voxel to the next
};

/** @brief Hashes the codes of a voxel; all bits can be used. */
inline std::uint64_t
hashOf(const VoxelCode& code)
{
  const auto widened = [](std::int32_t c) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(c));
  };
  std::uint64_t h = widened(code[0]) * 0x9e3779b97f4a7c15u +
                    widened(code[1]) * 0xc2b2ae3d27d4eb4fu +
                    widened(code[2]) * 0x165667b19e3779f9u;
  h ^= h >> 32;
  h *= 0xd6e8feb86659fd93u;
  return h ^ h >> 32;
}

/** @brief Checks whether two voxels are the same; faster than memcmp(). */
inline bool
isSame(const VoxelCode& a, const VoxelCode& b)
{
  return ((a[0] ^ b[0]) | (a[1] ^ b[1]) | (a[2] ^ b[2])) == 0;
}

/** @brief A hash table of the sums of voxels, numbered as they came; they stay where
 * they are. */
class VoxelTable {
public:
  /** @brief Adds a sum to that of its voxel. */
  void add(const VoxelSum& sum)
  {
    if (2 * (sums_.size() + 1) > slots_.size())
      grow();
    Slot& slot = slots_[slotOf(sum.code)];
    if (slot.number > 0) {
      sums_[slot.number - 1] += sum;
      return;
    }
    sums_.push_back(sum);
    slot = {static_cast<std::uint32_t>(hashOf(sum.code)),
            static_cast<std::uint32_t>(sums_.size())};
  }

  /** @brief Returns the number of voxels. */
  std::size_t size() const { return sums_.size(); }

  const VoxelSum& operator[](std::size_t number) const { return sums_[number]; }

  /** @brief Sets the count of a voxel to 0.
   * @return what it was */
  std::uint32_t drop(std::size_t number)
  {
    return std::exchange(sums_[number].count, 0);
  }

  /** @brief Returns the number of a voxel, -1 if there is none. */
  std::int64_t numberOf(const VoxelCode& code) const
  {
    return slots_.empty() ? -1 : std::int64_t{slots_[slotOf(code)].number} - 1;
  }

private:
  struct Slot {
    std::uint32_t hash = 0;   ///< its low bits
    std::uint32_t number = 0; ///< of the sum plus one; 0: empty
  };

  /** @brief Returns the slot of a voxel, or the empty one for it. */
  std::size_t slotOf(const VoxelCode& code) const
  {
    const std::uint64_t hash = hashOf(code);
    std::size_t s = hash & (slots_.size() - 1);
    while (slots_[s].number > 0 &&
           (slots_[s].hash != static_cast<std::uint32_t>(hash) ||
            !isSame(sums_[slots_[s].number - 1].code, code)))
      s = (s + 1) & (slots_.size() - 1);
    return s;
  }

  void grow()
  {
    constexpr std::size_t fewest = 16;
    slots_.assign(std::max(fewest, 2 * slots_.size()), {});
    for (std::size_t k = 0; k < sums_.size(); ++k)
      slots_[slotOf(sums_[k].code)] = {
          static_cast<std::uint32_t>(hashOf(sums_[k].code)),
          static_cast<std::uint32_t>(k + 1)};
  }

  std::vector<Slot> slots_; ///< at most half full, as many as a power of two
  std::deque<VoxelSum> sums_;
};

} // namespace pcl::sedr
