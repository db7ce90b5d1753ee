// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/parallel_sort.h>
#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Points of a box by cubes, to be found by place. */
class PointCubes {
public:
  /** @param size of a cube, metres
   * @param threads 0: as many as there are processors; the result is the same */
  PointCubes(const PointView& points,
             const std::vector<int>& indices,
             const Eigen::AlignedBox3d& box,
             double size,
             unsigned threads)
      : origin_(box.min())
      , size_(size)
  {
    for (const int i : indices) {
      const auto at = static_cast<std::size_t>(i);
      if (!points.isFinite(at))
        continue;
      const Eigen::Vector3d p = points[at].cast<double>();
      if (box.contains(p))
        points_.emplace_back(keyOf(cubeOf(p)), p);
    }
    sortParallel(points_, threads,
                 [](const Entry& a, const Entry& b) { return a.first < b.first; });
  }

  /** @brief Whether any point within a cube's size of `place` is one that is asked for.
   */
  template <typename Asked>
  bool anyNear(const Eigen::Vector3d& place, Asked asked) const
  {
    const Cube cube = cubeOf(place);
    for (std::int64_t x = cube[0] - 1; x <= cube[0] + 1; ++x)
      for (std::int64_t y = cube[1] - 1; y <= cube[1] + 1; ++y) {
        // Three cubes above each other have keys in a row.
        auto at = std::lower_bound(
            points_.begin(), points_.end(), keyOf({x, y, cube[2] - 1}),
            [](const Entry& entry, std::uint64_t key) { return entry.first < key; });
        const std::uint64_t last = keyOf({x, y, cube[2] + 1});
        for (; at != points_.end() && at->first <= last; ++at)
          if (asked(at->second))
            return true;
      }
    return false;
  }

private:
  using Cube = std::array<std::int64_t, 3>;
  using Entry = std::pair<std::uint64_t, Eigen::Vector3d>;

  Cube cubeOf(const Eigen::Vector3d& p) const
  {
    const Eigen::Vector3d q = ((p - origin_) / size_).array().floor();
    return {static_cast<std::int64_t>(q.x()), static_cast<std::int64_t>(q.y()),
            static_cast<std::int64_t>(q.z())};
  }

  /** @brief Unique within two million cubes. */
  static std::uint64_t keyOf(const Cube& cube)
  {
    constexpr std::int64_t off = 1 << 20;
    std::uint64_t key = 0;
    for (const std::int64_t c : cube)
      key = (key << 21) | (static_cast<std::uint64_t>(c + off) & 0x1fffff);
    return key;
  }

  Eigen::Vector3d origin_;
  double size_;
  std::vector<Entry> points_;
};

} // namespace sedr
} // namespace pcl
