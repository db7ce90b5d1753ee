// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief Where the points of a ceiling lie before and behind a wall, by columns of the
 * wall. A wall interrupts the ceiling for its thickness, what stands before one does
 * not. Offsets in metres, below 0 behind the wall. */
class CeilingBeside {
public:
  CeilingBeside() = default;

  /** @param edge of the surface: what is farther before it lies off it */
  CeilingBeside(std::size_t columns, double edge);

  void add(std::size_t column, float offset);

  /** @brief Finds how far the ceiling goes on behind the columns. O(points log points).
   * @param noise less is none */
  void measure(double noise);

  /** @brief Returns how far the ceiling goes on behind the surface. */
  float behind(std::size_t column) const { return behind_[column]; }

  /** @brief Returns how far before the surface lies the nearest point off it; infinite:
   * none does. */
  float before(std::size_t column) const { return before_[column]; }

private:
  double edge_ = 0;
  std::vector<std::vector<float>> offsets_;
  std::vector<float> behind_;
  std::vector<float> before_;
};

} // namespace pcl::sedr
