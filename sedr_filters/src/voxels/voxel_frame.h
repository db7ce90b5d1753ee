// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

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

} // namespace pcl::sedr
