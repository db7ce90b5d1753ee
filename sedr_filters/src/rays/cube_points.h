// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../voxels/voxel_table.h"

#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief A cube of a grid in space, by its place along x, y and z. */
using Cube = Eigen::Vector3i;

/** @brief A set of cubes of one size, numbered from 0 as they were added, and found by
 * place in O(1). Memory grows with the number of cubes. */
class CubeTable {
public:
  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  /** @param size edge of a cube, metres */
  explicit CubeTable(double size)
      : inverse_(1 / size)
  {}

  std::size_t size() const { return table_.size(); }
  double edge() const { return 1 / inverse_; }

  Cube operator[](std::size_t k) const
  {
    const VoxelCode& code = table_[k].code;
    return {code[0], code[1], code[2]};
  }

  /** @brief Returns the cube of a place; those farther than a million cubes from 0
   * along an axis are taken for one that is there. */
  Cube at(const Eigen::Vector3d& place) const
  {
    constexpr double limit = 1 << 20;
    return (inverse_ * place)
        .cwiseMax(-limit)
        .cwiseMin(limit - 1)
        .array()
        .floor()
        .cast<int>();
  }

  std::uint32_t find(const Cube& cube) const
  {
    return static_cast<std::uint32_t>(table_.numberOf(codeOf(cube)));
  }

  std::uint32_t findAt(const Eigen::Vector3d& place) const { return find(at(place)); }

  /** @brief Returns the number of a cube, which is added if it is new. */
  std::uint32_t add(const Cube& cube)
  {
    table_.add({codeOf(cube), 1, {}});
    return find(cube);
  }

  /** @brief Calls `see(number)` for the cubes of the set among the 27 around one,
   * until it returns true.
   * @return whether it did */
  template <typename See>
  bool anyAround(const Cube& middle, See see) const
  {
    for (int k = 0; k < 27; ++k) {
      const std::uint32_t found =
          find(Cube(middle + Cube(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1)));
      if (found != none && see(found))
        return true;
    }
    return false;
  }

  /** @brief Checks whether any of the 27 cubes around a place is in the set. */
  bool isNear(const Eigen::Vector3d& place) const
  {
    return anyAround(at(place), [](std::uint32_t) { return true; });
  }

private:
  static VoxelCode codeOf(const Cube& cube) { return {cube[0], cube[1], cube[2]}; }

  double inverse_;
  VoxelTable table_; ///< of which only the numbers are used
};

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

private:
  CubeTable cubes_;
  std::vector<std::vector<Eigen::Vector3f>> places_; ///< of each cube
};

} // namespace pcl::sedr
