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

/** @brief The coordinates of a cloud of any point type, seen without copying: the
 * algorithms of this library read points through it and know nothing of PCL. Valid
 * while the cloud is. */
class PointView {
public:
  PointView() = default;

  /** @brief `size` points, the x of the first, a float, at `first_x`, `stride` bytes
   * from one to the next; y and z follow x. They need not be aligned. */
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

  /** @brief Tells the processor that a point will soon be read. */
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
