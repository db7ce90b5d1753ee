// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cube_table.h"
#include <pcl/sedr_filters/point_view.h>

#include <algorithm>
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
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = indices ? static_cast<std::size_t>((*indices)[k]) : k;
      if (!points.isFinite(i))
        continue;
      const std::uint32_t cube = cubes_.add(cubes_.at(points[i].cast<double>()));
      places_.resize(cubes_.size());
      places_[cube].push_back(points[i]);
    }
  }

  const CubeTable& cubes() const { return cubes_; }

  /** @brief Returns the points of a cube. */
  const std::vector<Eigen::Vector3f>& operator[](std::uint32_t cube) const
  {
    return places_[cube];
  }

  /** @brief Checks whether `asked(point)` is true for any point within one edge of a
   * cube of `place`; it also sees points farther away. */
  template <typename Asked>
  bool anyNear(const Eigen::Vector3d& place, Asked asked) const
  {
    return cubes_.anyAround(cubes_.at(place), [&](std::uint32_t cube) {
      return std::any_of(places_[cube].begin(), places_[cube].end(),
                         [&](const Eigen::Vector3f& p) {
                           return asked(Eigen::Vector3d(p.cast<double>()));
                         });
    });
  }

private:
  CubeTable cubes_;
  std::vector<std::vector<Eigen::Vector3f>> places_; ///< of each cube
};

} // namespace pcl::sedr
