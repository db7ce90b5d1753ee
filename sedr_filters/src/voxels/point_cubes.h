// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../base/parallel_for.h"
#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace pcl::sedr {

/** @brief The points within a box, sorted into cubes for spatial queries: by column in
 * plan, then by height. O(n log n). */
class PointCubes {
public:
  /** @param size edge of a cube, metres; larger for boxes of more than 2^24 columns
   * @param threads 0: all processors; the result does not depend on it */
  PointCubes(const PointView& points,
             const std::vector<int>& indices,
             const Eigen::AlignedBox3d& box,
             double size,
             unsigned threads)
      : origin_(box.min())
      , size_(size)
  {
    constexpr double max_columns = 1 << 24;
    const Eigen::Vector3d extent = box.sizes();
    if (box.isEmpty() || !extent.allFinite())
      return;
    while ((extent.x() / size_ + 1) * (extent.y() / size_ + 1) > max_columns)
      size_ *= 2; // queries then see more points, most of them too far away
    const Cube far = cubeOf(box.max());
    width_ = far.x() + 1;
    height_ = far.y() + 1;
    ends_.assign(static_cast<std::size_t>(width_ * height_) + 1, 0);
    std::vector<int> inside;
    for (const int i : indices) {
      const Eigen::Vector3d p = points[static_cast<std::size_t>(i)].cast<double>();
      if (!p.allFinite() || !box.contains(p))
        continue;
      inside.push_back(i);
      ++ends_[columnOf(p) + 1];
    }
    std::partial_sum(ends_.begin(), ends_.end(), ends_.begin());
    sorted_.resize(inside.size());
    std::vector<std::size_t> next = ends_;
    for (const int i : inside) {
      const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
      sorted_[next[columnOf(p.cast<double>())]++] = p;
    }
    constexpr std::size_t columns_a_block = 1024;
    parallelFor(ends_.size() - 1, columns_a_block, threads, [&](std::size_t c) {
      std::sort(sorted_.data() + ends_[c], sorted_.data() + ends_[c + 1],
                [](const auto& a, const auto& b) { return a.z() < b.z(); });
    });
  }

  /** @brief Checks whether `asked(point)` is true for any point within one cube size of
   * `place`; it may also see points slightly farther away. */
  template <typename Asked>
  bool anyNear(const Eigen::Vector3d& place, Asked asked) const
  {
    const Cube cube = cubeOf(place);
    for (std::int64_t y = std::max<std::int64_t>(cube.y() - 1, 0);
         y <= std::min(cube.y() + 1, height_ - 1); ++y)
      for (std::int64_t x = std::max<std::int64_t>(cube.x() - 1, 0);
           x <= std::min(cube.x() + 1, width_ - 1); ++x) {
        const auto column = static_cast<std::size_t>(y * width_ + x);
        const Eigen::Vector3f* const end = sorted_.data() + ends_[column + 1];
        const Eigen::Vector3f* p = std::lower_bound(
            sorted_.data() + ends_[column], end, place.z() - size_,
            [](const Eigen::Vector3f& point, double z) { return point.z() < z; });
        for (; p != end && p->z() <= place.z() + size_; ++p)
          if (asked(Eigen::Vector3d(p->cast<double>())))
            return true;
      }
    return false;
  }

private:
  using Cube = Eigen::Matrix<std::int64_t, 3, 1>;

  Cube cubeOf(const Eigen::Vector3d& p) const
  {
    return ((p - origin_) / size_).array().floor().cast<std::int64_t>();
  }

  std::size_t columnOf(const Eigen::Vector3d& p) const
  {
    const Cube cube = cubeOf(p);
    return static_cast<std::size_t>(cube.y() * width_ + cube.x());
  }

  Eigen::Vector3d origin_;
  double size_;
  std::int64_t width_ = 0;        ///< columns along x
  std::int64_t height_ = 0;       ///< columns along y
  std::vector<std::size_t> ends_; ///< 0, then the end of each column, row by row
  std::vector<Eigen::Vector3f> sorted_;
};

} // namespace pcl::sedr
