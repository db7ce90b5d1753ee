// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace pcl::sedr {

/** @brief A voxel along x, y and z, see codeOf(). */
using VoxelCode = std::array<std::int32_t, 3>;

/** @brief A voxel and the sum of its points; trivially copyable, also to another
 * process. Its VoxelFrame interprets the numbers. */
struct VoxelSum {
  VoxelCode code;                   ///< voxel along x, y and z
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

inline std::uint32_t
bitsOf(float value)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

inline float
floatOf(std::uint32_t bits)
{
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

constexpr float code_limit = 1073741824.f; // 2^30

/** @brief Returns a code that increases with floor(scaled) for any magnitude: the
 * integer itself up to 2^30, beyond that the index of the float. */
inline std::int32_t
codeOf(float scaled)
{
  if (std::abs(scaled) < code_limit) {
    const auto cell = static_cast<std::int32_t>(scaled);
    return cell - (scaled < static_cast<float>(cell) ? 1 : 0);
  }
  const auto beyond =
      static_cast<std::int32_t>(bitsOf(std::abs(scaled)) - bitsOf(code_limit));
  const auto code = static_cast<std::int32_t>(code_limit) + beyond;
  return scaled < 0 ? -code : code;
}

/** @brief Returns the floor(scaled) of a code. */
inline double
cellOf(std::int32_t code)
{
  constexpr auto limit = static_cast<std::int32_t>(code_limit);
  if (std::abs(code) < limit)
    return code;
  const auto beyond = static_cast<std::uint32_t>(std::abs(code) - limit);
  return std::copysign(static_cast<double>(floatOf(bitsOf(code_limit) + beyond)), code);
}

/** @brief Returns the voxel coordinates of codes, saturated to int. */
inline Eigen::Vector3i
voxelAt(const VoxelCode& code)
{
  constexpr double lowest = std::numeric_limits<int>::min();
  constexpr double highest = std::numeric_limits<int>::max();
  Eigen::Vector3i voxel;
  for (std::size_t axis = 0; axis < 3; ++axis)
    voxel[static_cast<int>(axis)] =
        static_cast<int>(std::clamp(cellOf(code[axis]), lowest, highest));
  return voxel;
}

/** @brief The positions of the voxels and the arithmetic of their sums: coordinates are
 * integer steps, so sums are exact in any order.
 *
 * A step is a power of two between 2^-31 and 2^-30 leaves. Coordinates farther from 0
 * than 2^-7 leaves are exact multiples of a step; nearer ones are rounded, to 0.05 nm
 * at a leaf of 5 cm. Sums are taken modulo 2^64, and means relative to the voxel's
 * corner. Points lie within 1.5 leaves of it, less than 1.5 x 2^31 steps, so 2^31
 * points add up to less than 2^63. Along an axis where the voxel is more than 2^19
 * leaves from 0 (26 km at 5 cm), the index of the float replaces the step. It is below
 * 2^31, too. */
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

  const Eigen::Array3f& inverseLeaf() const { return inverse_leaf_; }

  /** @brief Returns the codes of the voxel of a finite point. */
  VoxelCode codes(const float* point) const
  {
    return {codeOf(point[0] * inverse_leaf_[0]), codeOf(point[1] * inverse_leaf_[1]),
            codeOf(point[2] * inverse_leaf_[2])};
  }

  /** @brief Converts a coordinate whose code along the axis is `code` to steps. */
  std::uint64_t steps(float value, std::size_t axis, std::int32_t code) const
  {
    return isNear(code) ? nearSteps(value, axis) : floatsTo(value);
  }

  /** @brief Computes codes and steps of `n` finite coordinates along an axis. */
  void find(std::size_t axis,
            const float* values,
            std::size_t n,
            std::int32_t* codes,
            std::uint64_t* steps) const;

  /** @brief Returns the mean of a voxel's points; its count must not be 0. */
  Eigen::Vector3f mean(const VoxelSum& voxel) const
  {
    return {meanAlong(voxel, 0), meanAlong(voxel, 1), meanAlong(voxel, 2)};
  }

private:
  static constexpr std::int32_t near_limit = 1 << 19;

  static bool isNear(std::int32_t code)
  {
    return code >= -near_limit && code < near_limit;
  }

  /** @brief Rounds a coordinate to steps; the result must be below 2^51. */
  std::uint64_t nearSteps(float value, std::size_t axis) const
  {
    // In a double of this size the last bit has the value 1.
    constexpr double shift = 6755399441055744.; // 1.5 x 2^52
    constexpr std::uint64_t shift_bits = 0x4338000000000000u;
    const double shifted = static_cast<double>(value) * steps_[axis] + shift;
    std::uint64_t bits = 0;
    std::memcpy(&bits, &shifted, sizeof bits);
    return bits - shift_bits;
  }

  /** @brief Returns the signed number of floats between 0 and `value`. */
  static std::uint64_t floatsTo(float value)
  {
    const auto floats = static_cast<std::int64_t>(bitsOf(std::abs(value)));
    return static_cast<std::uint64_t>(std::signbit(value) ? -floats : floats);
  }

  /** @brief Computes llround() of a number below 2^51, without a function call. */
  static std::int64_t rounded(double value)
  {
    return static_cast<std::int64_t>(value + std::copysign(0.5, value));
  }

  float meanAlong(const VoxelSum& voxel, std::size_t axis) const
  {
    const double count = voxel.count;
    if (isNear(voxel.code[axis])) {
      const std::int64_t corner = rounded(voxel.code[axis] * corner_steps_[axis]);
      const std::uint64_t corners = voxel.count * static_cast<std::uint64_t>(corner);
      const auto sum = static_cast<std::int64_t>(voxel.sum[axis] - corners);
      return static_cast<float>(
          (static_cast<double>(corner) + static_cast<double>(sum) / count) /
          steps_[axis]);
    }
    const auto sum = static_cast<std::int64_t>(voxel.sum[axis]);
    const std::int64_t bits = std::llround(static_cast<double>(sum) / count);
    const float size = floatOf(static_cast<std::uint32_t>(std::abs(bits)));
    return bits < 0 ? -size : size;
  }

  Eigen::Array3f inverse_leaf_;
  std::array<double, 3> steps_{};        ///< steps per metre, powers of two
  std::array<double, 3> corner_steps_{}; ///< steps from a voxel to the next
};

} // namespace pcl::sedr
