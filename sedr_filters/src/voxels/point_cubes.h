// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../base/parallel_for.h"
#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

namespace pcl::sedr {

/** @brief The points within a box, sorted into cubes for spatial queries: by profile in
 * plan, then by height. O(n + profiles of the box). */
class PointCubes {
public:
  /** @param size edge of a cube, metres; larger for large boxes
   * @param threads 0: all processors; the result does not depend on it */
  PointCubes(const PointView& points,
             const std::vector<int>& indices,
             const Eigen::AlignedBox3d& box,
             double size,
             unsigned threads)
      : origin_(box.min())
      , size_(size)
  {
    constexpr double max_columns = 1 << 26;
    const Eigen::Vector3d extent = box.sizes();
    if (box.isEmpty() || !extent.allFinite())
      return;
    while ((extent.x() / size_ + 1) * (extent.y() / size_ + 1) > max_columns)
      size_ *= 2; // queries then see more points, most of them too far away
    const Cube far = cubeOf(box.max());
    width_ = far.x() + 1;
    height_ = far.y() + 1;
    sortIntoColumns(points, indices, columnsOf(points, indices, box, threads));
    sortColumns(threads);
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
        const Entry* const begin = entries_.get() + first_[column];
        const Entry* const end = entries_.get() + first_[column + 1];
        const Entry* at = std::lower_bound(
            begin, end, cube.z() - 1,
            [](const Entry& entry, std::int64_t level) { return entry.level < level; });
        for (; at != end && at->level <= cube.z() + 1; ++at)
          if (asked(Eigen::Vector3d(at->place.cast<double>())))
            return true;
      }
    return false;
  }

private:
  using Cube = Eigen::Matrix<std::int64_t, 3, 1>;

  struct Entry {
    Eigen::Vector3f place;
    std::int32_t level; ///< level of its cube above the lowest
  };

  static constexpr std::uint32_t outside = static_cast<std::uint32_t>(-1);

  Cube cubeOf(const Eigen::Vector3d& p) const
  {
    return ((p - origin_) / size_).array().floor().cast<std::int64_t>();
  }

  /** @brief Returns the profile of each point, `outside` for points outside the box. */
  std::vector<std::uint32_t> columnsOf(const PointView& points,
                                       const std::vector<int>& indices,
                                       const Eigen::AlignedBox3d& box,
                                       unsigned threads) const
  {
    constexpr std::size_t points_a_block = 16384;
    std::vector<std::uint32_t> columns(indices.size(), outside);
    parallelFor(indices.size(), points_a_block, threads, [&](std::size_t k) {
      const auto i = static_cast<std::size_t>(indices[k]);
      const Eigen::Vector3d p = points[i].cast<double>();
      if (!points.isFinite(i) || !box.contains(p))
        return;
      const Cube cube = cubeOf(p);
      columns[k] = static_cast<std::uint32_t>(cube.y() * width_ + cube.x());
    });
    return columns;
  }

  void sortIntoColumns(const PointView& points,
                       const std::vector<int>& indices,
                       const std::vector<std::uint32_t>& columns)
  {
    first_.assign(static_cast<std::size_t>(width_ * height_) + 1, 0);
    for (const std::uint32_t column : columns)
      if (column != outside)
        ++first_[column + 1];
    for (std::size_t c = 1; c < first_.size(); ++c)
      first_[c] += first_[c - 1];
    entries_.reset(new Entry[first_.back()]); // not cleared: all are written
    std::vector<std::size_t> next(first_.begin(), first_.end());
    for (std::size_t k = 0; k < indices.size(); ++k) {
      if (columns[k] == outside)
        continue;
      const Eigen::Vector3f p = points[static_cast<std::size_t>(indices[k])];
      const auto level = static_cast<std::int32_t>(cubeOf(p.cast<double>()).z());
      entries_[next[columns[k]]++] = {p, level};
    }
  }

  void sortColumns(unsigned threads)
  {
    constexpr std::size_t columns_a_block = 1024;
    const auto isLower = [](const Entry& a, const Entry& b) {
      return a.level < b.level;
    };
    parallelFor(first_.size() - 1, columns_a_block, threads, [&](std::size_t c) {
      Entry* const low = entries_.get() + first_[c];
      Entry* const high = entries_.get() + first_[c + 1];
      if (!std::is_sorted(low, high, isLower)) // usually the case
        std::sort(low, high, isLower);
    });
  }

  Eigen::Vector3d origin_;
  double size_;
  std::int64_t width_ = 0;         ///< profiles along x
  std::int64_t height_ = 0;        ///< profiles along y
  std::vector<std::size_t> first_; ///< first of each profile, row by row, then the end
  std::unique_ptr<Entry[]> entries_;
};

} // namespace pcl::sedr
