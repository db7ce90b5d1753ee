// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/voxel_frame.h>
#include <pcl/sedr_filters/voxel_hash.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace pcl {
namespace sedr {

/** @brief Some points, axis by axis, and what is made of them several at once. */
class VoxelBatch {
public:
  static constexpr std::size_t most = 256;

  std::size_t size() const { return size_; }

  bool isFull() const { return size_ == most; }

  void clear() { size_ = 0; }

  void push(const Eigen::Vector3f& point)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
      points_[axis][size_] = point[static_cast<Eigen::Index>(axis)];
    ++size_;
  }

  /** @brief Finds voxel and steps of every point. */
  void find(const VoxelFrame& frame)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
      frame.find(axis, points_[axis].data(), size_, codes_[axis].data(),
                 steps_[axis].data());
  }

  VoxelCode code(std::size_t i) const
  {
    return {codes_[0][i], codes_[1][i], codes_[2][i]};
  }

  std::uint64_t steps(std::size_t axis, std::size_t i) const { return steps_[axis][i]; }

private:
  template <typename ValueT>
  using Columns = std::array<std::array<ValueT, most>, 3>;

  std::size_t size_ = 0;
  Columns<float> points_;
  Columns<std::int32_t> codes_;
  Columns<std::uint64_t> steps_;
};

} // namespace sedr
} // namespace pcl
