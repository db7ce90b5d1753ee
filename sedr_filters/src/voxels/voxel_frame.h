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

/** @brief A voxel along x, y and z: floor(coordinate / leaf), or beyond 2^30 leaves a
 * number that increases with it (see codeOf()). */
using VoxelCode = std::array<std::int32_t, 3>;

/** @brief A box of voxels; both ends are inclusive. */
struct VoxelBox {
  static constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max();

  VoxelCode low{most, most, most};
  VoxelCode high{-most, -most, -most};

  void extend(const VoxelBox& other)
  {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], other.low[axis]);
      high[axis] = std::max(high[axis], other.high[axis]);
    }
  }
};

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

/** @brief Checks whether voxel `a` comes before `b` in the output: by z, then y, then
 * x. */
inline bool
isBefore(const VoxelSum& a, const VoxelSum& b)
{
  if (a.code[2] != b.code[2])
    return a.code[2] < b.code[2];
  return a.code[1] != b.code[1] ? a.code[1] < b.code[1] : a.code[0] < b.code[0];
}

constexpr std::int32_t code_limit = 1 << 30;

/** @brief Returns the number of floats between 0 and `value`, with its sign. */
inline std::int32_t
floatsTo(float value)
{
  const float size = std::abs(value);
  std::int32_t bits = 0;
  std::memcpy(&bits, &size, sizeof bits);
  return std::signbit(value) ? -bits : bits;
}

/** @brief Returns the inverse of floatsTo(). */
inline float
floatAt(std::int32_t number)
{
  const std::int32_t bits = std::abs(number);
  float size = 0;
  std::memcpy(&size, &bits, sizeof size);
  return number < 0 ? -size : size;
}

/** @brief Returns floor(scaled) of a number that an int can hold. */
inline std::int32_t
cellOf(float scaled)
{
  const auto cell = static_cast<std::int32_t>(scaled);
  return cell - (scaled < static_cast<float>(cell) ? 1 : 0);
}

/** @brief Returns floor(scaled), or beyond 2^30 the floats to it: those count from
 * above 2^30, because 2^30 itself is preceded by 1.3 x 2^30 floats. */
inline std::int32_t
codeOf(float scaled)
{
  return std::abs(scaled) < static_cast<float>(code_limit) ? cellOf(scaled)
                                                           : floatsTo(scaled);
}

/** @brief Returns the voxel coordinates of codes, saturated to int. */
inline Eigen::Vector3i
voxelAt(const VoxelCode& code)
{
  constexpr double lowest = std::numeric_limits<int>::min();
  constexpr double highest = std::numeric_limits<int>::max();
  Eigen::Vector3i voxel(code[0], code[1], code[2]);
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(voxel[axis]) > code_limit)
      voxel[axis] =
          static_cast<int>(std::clamp<double>(floatAt(voxel[axis]), lowest, highest));
  return voxel;
}

/** @brief The positions of the voxels and the arithmetic of their sums: coordinates are
 * integer steps, so sums are exact in any order.
 *
 * A step is a power of two between 2^-31 and 2^-30 leaves. Coordinates farther from 0
 * than 2^-7 leaves are exact multiples of a step; nearer ones are rounded, to 0.05 nm
 * at a leaf of 5 cm. Sums are taken modulo 2^64, and means relative to the voxel's
 * corner, so that 2^31 points of a voxel cannot overflow. Beyond 2^30 leaves from 0
 * (53 000 km at 5 cm), where a voxel holds one float or two, floatsTo() replaces the
 * step. */
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
  VoxelCode codes(const Eigen::Vector3f& point) const
  {
    return {codeOf(point[0] * inverse_leaf_[0]), codeOf(point[1] * inverse_leaf_[1]),
            codeOf(point[2] * inverse_leaf_[2])};
  }

  /** @brief Returns the sum of a single finite point. */
  VoxelSum sumOf(const Eigen::Vector3f& point) const
  {
    const Eigen::Array3f scaled = point.array() * inverse_leaf_;
    VoxelSum sum{{}, 1, {}};
    if ((scaled.abs() < near_limit).all()) // nearly always: without branches below
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Eigen::Index>(axis);
        sum.code[axis] = cellOf(scaled[i]);
        sum.sum[axis] = nearSteps(static_cast<double>(point[i]) * steps_[axis]);
      }
    else
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Eigen::Index>(axis);
        sum.code[axis] = codeOf(scaled[i]);
        sum.sum[axis] = farSteps(point[i], sum.code[axis], axis);
      }
    return sum;
  }

  /** @brief Returns the mean of a voxel's points; its count must not be 0. */
  Eigen::Vector3f mean(const VoxelSum& voxel) const
  {
    return {meanAlong(voxel, 0), meanAlong(voxel, 1), meanAlong(voxel, 2)};
  }

private:
  static constexpr float near_limit = 1 << 19;
  static constexpr double near_steps = 2251799813685248.; // 2^51

  /** @brief Rounds a number below 2^51. */
  static std::uint64_t nearSteps(double steps)
  {
    // In a double of the size of the shift the last bit has the value 1.
    constexpr double shift = 3 * near_steps;
    constexpr std::uint64_t shift_bits = 0x4338000000000000u;
    const double shifted = steps + shift;
    std::uint64_t bits = 0;
    std::memcpy(&bits, &shifted, sizeof bits);
    return bits - shift_bits;
  }

  std::uint64_t farSteps(float value, std::int32_t code, std::size_t axis) const
  {
    if (std::abs(code) > code_limit)
      return static_cast<std::uint64_t>(std::int64_t{floatsTo(value)});
    const double steps = static_cast<double>(value) * steps_[axis];
    return std::abs(steps) < near_steps // larger numbers have no fraction
               ? nearSteps(steps)
               : static_cast<std::uint64_t>(static_cast<std::int64_t>(steps));
  }

  float meanAlong(const VoxelSum& voxel, std::size_t axis) const
  {
    const std::int32_t code = voxel.code[axis];
    const bool is_far = std::abs(code) > code_limit;
    const auto corner = is_far ? 0 : std::llround(code * corner_steps_[axis]);
    const auto sum = static_cast<std::int64_t>(
        voxel.sum[axis] - voxel.count * static_cast<std::uint64_t>(corner));
    const double beside = static_cast<double>(sum) / voxel.count;
    if (is_far)
      return floatAt(static_cast<std::int32_t>(std::llround(beside)));
    return static_cast<float>((static_cast<double>(corner) + beside) / steps_[axis]);
  }

  Eigen::Array3f inverse_leaf_;
  std::array<double, 3> steps_{};        ///< steps per metre, powers of two
  std::array<double, 3> corner_steps_{}; ///< steps from a voxel to the next
};

} // namespace pcl::sedr
