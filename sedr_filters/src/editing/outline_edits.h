// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pcl::sedr {

constexpr double touching = 1e-6; ///< metres; places within this distance coincide

inline PlanElement
segment(const Eigen::Vector2d& start, const Eigen::Vector2d& end)
{
  PlanElement element;
  element.start = start;
  element.end = end;
  return element;
}

inline double
cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/** @brief Returns where two segments cross or touch. */
std::optional<Eigen::Vector2d> crossing(const PlanElement& a, const PlanElement& b);

/** @brief Joins collinear neighbours and drops elements without a length. */
void simplify(PlanLoop& loop);

/** @brief A stretch of a straight wall between two rooms. */
struct SharedWall {
  std::size_t element = 0; ///< of the first room
  std::size_t other = 0;   ///< of the second room
  double from = 0;         ///< along the first, metres
  double to = 0;           ///< along the first, metres
};

/** @brief Returns the longest stretch at which two rooms face each other through a wall
 * of up to 0.6 m; of no length if there is none. */
SharedWall longestWall(const PlanRoom& room, const PlanRoom& other);

/** @brief Appends the elements from place `s` of element `k` around the loop to place
 * `t` of it. */
void appendAround(const PlanLoop& loop,
                  std::size_t k,
                  double s,
                  double t,
                  std::vector<PlanElement>& elements);

/** @brief Meets straight neighbours again after some of them were moved: `lines` are
 * the elements' new lines.
 * @return why that is not possible, or an empty text */
std::string meetAgain(const std::vector<PlanElement>& lines, PlanLoop& loop);

} // namespace pcl::sedr
