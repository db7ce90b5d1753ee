// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cube_table.h"
#include <pcl/sedr_filters/point_view.h>

#include <vector>

namespace pcl::sedr {

/** @brief Points by the cubes that they are in; those that are not finite are left out.
 * O(n). */
class CubePoints {
public:
  /** @param size edge of a cube, metres
   * @param indices the points to take; null: all */
  CubePoints(const PointView& points,
             double size,
             const std::vector<int>* indices = nullptr)
      : cubes_(size)
  {
    const std::size_t count = indices ? indices->size() : points.size();
    const auto pointAt = [&](std::size_t k) {
      return indices ? static_cast<std::size_t>((*indices)[k]) : k;
    };
    std::vector<std::uint32_t> cube_of(count, CubeTable::none);
    for (std::size_t k = 0; k < count; ++k)
      if (points.isFinite(pointAt(k)))
        cube_of[k] = cubes_.add(cubes_.at(points[pointAt(k)].cast<double>()));
    first_.assign(cubes_.size() + 1, 0);
    for (const std::uint32_t cube : cube_of)
      if (cube != CubeTable::none)
        ++first_[cube + 1];
    for (std::size_t k = 1; k < first_.size(); ++k)
      first_[k] += first_[k - 1];
    places_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t k = 0; k < count; ++k)
      if (cube_of[k] != CubeTable::none)
        places_[next[cube_of[k]]++] = points[pointAt(k)];
  }

  const CubeTable& cubes() const { return cubes_; }

  /** @brief Calls `see(place)` for the points of a cube. */
  template <typename See>
  void forEachPoint(std::uint32_t cube, See see) const
  {
    for (std::uint32_t k = first_[cube]; k < first_[cube + 1]; ++k)
      see(places_[k]);
  }

  /** @brief Checks whether `asked(point)` is true for any point within one edge of a
   * cube of `place`; it also sees points farther away. */
  template <typename Asked>
  bool anyNear(const Eigen::Vector3d& place, Asked asked) const
  {
    return cubes_.anyAround(cubes_.at(place), [&](std::uint32_t cube) {
      bool is_any = false;
      for (std::uint32_t k = first_[cube]; k < first_[cube + 1] && !is_any; ++k)
        is_any = asked(Eigen::Vector3d(places_[k].cast<double>()));
      return is_any;
    });
  }

private:
  CubeTable cubes_;
  std::vector<std::uint32_t> first_; ///< point of each cube, and the end
  std::vector<Eigen::Vector3f> places_;
};

} // namespace pcl::sedr
