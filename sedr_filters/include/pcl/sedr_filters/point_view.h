// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstring>

namespace pcl {

template <typename PointT>
class PointCloud;

namespace sedr {

/** @brief A view of the coordinates of a cloud of any point type, without a copy.
 * Algorithms read points through it and do not depend on PCL. Valid as long as the
 * cloud. */
class PointView {
public:
  PointView() = default;

  /** @brief Views `size` points, `stride` bytes apart. The x of the first point, a
   * float, is at `first_x`; y and z follow x. No alignment is needed. */
  PointView(const void* first_x, std::size_t stride, std::size_t size)
      : first_(static_cast<const char*>(first_x))
      , stride_(stride)
      , size_(size)
  {}

  template <typename PointT>
  explicit PointView(const pcl::PointCloud<PointT>& cloud)
      : PointView(cloud.empty() ? nullptr : &cloud[0].x, sizeof(PointT), cloud.size())
  {}

  std::size_t size() const { return size_; }

  Eigen::Vector3f operator[](std::size_t i) const
  {
    Eigen::Vector3f p;
    std::memcpy(p.data(), first_ + i * stride_, 3 * sizeof(float));
    return p;
  }

  /** @brief Prefetches a point that will soon be read. */
  void prefetch(std::size_t i) const
  {
#ifdef __GNUC__
    __builtin_prefetch(first_ + i * stride_);
#else
    static_cast<void>(i);
#endif
  }

  bool isFinite(std::size_t i) const
  {
    const Eigen::Vector3f p = (*this)[i];
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  }

private:
  const char* first_ = nullptr;
  std::size_t stride_ = 0;
  std::size_t size_ = 0;
};

} // namespace sedr
} // namespace pcl
