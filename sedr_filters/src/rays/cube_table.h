// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
      , slots_(std::size_t{1} << 12, none)
  {}

  std::size_t size() const { return cubes_.size(); }
  double edge() const { return 1 / inverse_; }
  const Cube& operator[](std::size_t k) const { return cubes_[k]; }

  /** @brief The cube of a place; those farther than a million cubes from 0 along an
   * axis are taken for one that is there. */
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

  std::uint32_t find(const Cube& cube) const { return slots_[slotOf(cube)]; }

  std::uint32_t findAt(const Eigen::Vector3d& place) const { return find(at(place)); }

  /** @brief Number of a cube, which is added if it is new. */
  std::uint32_t add(const Cube& cube)
  {
    if (2 * (cubes_.size() + 1) > slots_.size())
      grow();
    std::uint32_t& slot = slots_[slotOf(cube)];
    if (slot == none) {
      slot = static_cast<std::uint32_t>(cubes_.size());
      cubes_.push_back(cube);
    }
    return slot;
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

  /** @brief Whether any of the 27 cubes around a place is in the set. */
  bool isNear(const Eigen::Vector3d& place) const
  {
    return anyAround(at(place), [](std::uint32_t) { return true; });
  }

private:
  /** @brief The slot that holds a cube, or the empty one where it belongs. */
  std::size_t slotOf(const Cube& cube) const
  {
    constexpr std::uint64_t spread = 0x9e3779b97f4a7c15u;
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
      key = key << 21 | (static_cast<std::uint64_t>(cube[axis] + (1 << 20)) & 0x1fffff);
    std::size_t slot = (key * spread) >> 20 & (slots_.size() - 1);
    while (slots_[slot] != none && cubes_[slots_[slot]] != cube)
      slot = (slot + 1) & (slots_.size() - 1);
    return slot;
  }

  void grow()
  {
    slots_.assign(2 * slots_.size(), none);
    for (std::size_t k = 0; k < cubes_.size(); ++k)
      slots_[slotOf(cubes_[k])] = static_cast<std::uint32_t>(k);
  }

  double inverse_;
  std::vector<Cube> cubes_;
  std::vector<std::uint32_t> slots_; ///< a power of two of them
};

} // namespace pcl::sedr
