// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "recent_blocks.h"

#include "voxel_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pcl::sedr {

/** @brief A batch of points stored by axis, with vectorised loops without branches. */
class VoxelBatch {
public:
  static constexpr std::size_t most = 256;

  std::size_t size() const { return size_; }

  /** @brief Takes the finite points among pointAt(i), i < n. */
  template <typename PointAt>
  void fill(std::size_t n, const PointAt& pointAt)
  {
    for (std::size_t i = 0; i < n; ++i) {
      const Eigen::Vector3f point = pointAt(i);
      for (std::size_t axis = 0; axis < 3; ++axis)
        points_[axis][i] = point[static_cast<Eigen::Index>(axis)];
    }
    size_ = n;
    if (!areAllFinite())
      leaveOutOthers();
  }

  /** @brief Computes block, place in the block and steps of every point. */
  void find(const VoxelFrame& frame)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
      frame.find(axis, points_[axis].data(), size_, codes_[axis].data(),
                 steps_[axis].data());
    for (std::size_t i = 0; i < size_; ++i)
      locals_[i] = VoxelBlock::localOf(code(i));
    for (std::size_t i = 0; i < size_; ++i)
      slots_[i] = RecentBlocks::slotOf(VoxelBlock::cornerOf(code(i)));
  }

  VoxelCode corner(std::size_t i) const { return VoxelBlock::cornerOf(code(i)); }

  std::uint64_t steps(std::size_t axis, std::size_t i) const { return steps_[axis][i]; }

  /** @brief Returns VoxelBlock::localOf() of the voxel. */
  unsigned local(std::size_t i) const { return locals_[i]; }

  /** @brief Returns RecentBlocks::slotOf() of the block. */
  std::size_t slot(std::size_t i) const { return slots_[i]; }

private:
  template <typename ValueT>
  using Column = std::array<ValueT, most>;
  template <typename ValueT>
  using Columns = std::array<Column<ValueT>, 3>;

  VoxelCode code(std::size_t i) const
  {
    return {codes_[0][i], codes_[1][i], codes_[2][i]};
  }

  bool areAllFinite() const
  {
    constexpr std::uint32_t exponent = 0x7f800000u; // all bits set: not finite
    std::uint32_t others = 0;
    for (const Column<float>& values : points_)
      for (std::size_t i = 0; i < size_; ++i)
        others |= (bitsOf(values[i]) & exponent) == exponent ? 1 : 0;
    return others == 0;
  }

  void leaveOutOthers()
  {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      for (Column<float>& values : points_)
        values[kept] = values[i];
      if (std::all_of(points_.begin(), points_.end(), [&](const Column<float>& values) {
            return std::isfinite(values[kept]);
          }))
        ++kept;
    }
    size_ = kept;
  }

  std::size_t size_ = 0;
  Columns<float> points_;
  Columns<std::int32_t> codes_;
  Columns<std::uint64_t> steps_;
  Column<std::uint32_t> locals_;
  Column<std::uint32_t> slots_;
};

} // namespace pcl::sedr
