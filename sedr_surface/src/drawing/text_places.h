// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Half the width and height of some lines of text, over the size of the font;
 * letters of sans-serif fonts are about as wide as this on average. */
inline Eigen::Vector2d
halfSizeOf(const std::vector<std::string>& lines)
{
  constexpr double letter = 0.56;
  constexpr double line_height = 1.3;
  std::size_t letters = 0;
  for (const std::string& line : lines)
    letters = std::max(letters, line.size());
  return {letter * static_cast<double>(letters) / 2,
          line_height * static_cast<double>(lines.size()) / 2};
}

/** @brief Half the sides of the upright box around a text that is written at a right
 * angle to a unit vector. */
inline Eigen::Vector2d
turnedTo(const Eigen::Vector2d& normal, const Eigen::Vector2d& half_size)
{
  const Eigen::Vector2d n = normal.cwiseAbs();
  return {n.y() * half_size.x() + n.x() * half_size.y(),
          n.x() * half_size.x() + n.y() * half_size.y()};
}

/** @brief The rectangles of a page that texts stand in. */
class TextPlaces {
public:
  /** @brief Takes a rectangle.
   * @return false where another text stands there already */
  bool take(const Eigen::Vector2d& middle, const Eigen::Vector2d& half_size)
  {
    const Eigen::AlignedBox2d box(middle - half_size, middle + half_size);
    if (std::any_of(taken_.begin(), taken_.end(), [&](const auto& other) {
          return !box.intersection(other).isEmpty();
        }))
      return false;
    taken_.push_back(box);
    return true;
  }

private:
  std::vector<Eigen::AlignedBox2d> taken_;
};

} // namespace sedr
} // namespace pcl
