// SPDX-License-Identifier: BSD-3-Clause
#include "wall_lines.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::sedr {

namespace {

/** @brief How many cells of walls lie where along an axis, by multiples of the cell. */
using Counts = std::map<int, std::size_t>;

Counts
countsAlong(const std::vector<Eigen::Vector2d>& walls,
            const Eigen::Vector2d& axis,
            double cell)
{
  Counts counts;
  for (const Eigen::Vector2d& w : walls)
    ++counts[static_cast<int>(std::floor(axis.dot(w) / cell))];
  return counts;
}

Eigen::Vector2d
directionAt(double angle)
{
  return {std::cos(angle), std::sin(angle)};
}

Eigen::Vector2d
leftTurn(const Eigen::Vector2d& direction)
{
  return {-direction.y(), direction.x()};
}

/** @brief How well walls lie on few lines of a direction and square to it. */
double
sharpness(const std::vector<Eigen::Vector2d>& walls, double angle, double cell)
{
  double sum = 0;
  for (const Eigen::Vector2d& axis : {directionAt(angle), leftTurn(directionAt(angle))})
    for (const auto& entry : countsAlong(walls, axis, cell))
      sum += std::pow(static_cast<double>(entry.second), 2);
  return sum;
}

/** @brief The angle within a quarter turn at which walls lie on the fewest lines. */
double
mainAngle(const std::vector<Eigen::Vector2d>& walls, double cell)
{
  const int steps = 90;
  double best = 0;
  double width = M_PI / 2;
  double most = 0;
  for (int round = 0; round < 3; ++round) {
    const double first = round == 0 ? 0 : best - width / 2;
    for (int k = 0; k < steps; ++k)
      if (const double angle = first + width * k / steps,
          sharp = sharpness(walls, angle, cell);
          sharp > most) {
        most = sharp;
        best = angle;
      }
    width *= 4.0 / steps;
  }
  return best;
}

/** @brief The lines that hold at least `min_length` of the walls, increasing. */
std::vector<double>
linesOf(const Counts& counts, double cell, double min_length)
{
  const auto at = [&](int s) {
    const auto found = counts.find(s);
    return found == counts.end() ? std::size_t{0} : found->second;
  };
  const auto around = [&](int s) { return at(s - 1) + at(s) + at(s + 1); };
  std::vector<double> lines;
  for (const auto& entry : counts) {
    const int s = entry.first;
    bool is_most = static_cast<double>(around(s)) * cell >= min_length;
    for (int other = s - 2; other <= s + 2 && is_most; ++other)
      is_most = other < s ? around(other) < around(s) : around(other) <= around(s);
    if (is_most)
      lines.push_back(
          (s + 0.5 +
           (static_cast<double>(at(s + 1)) - static_cast<double>(at(s - 1))) /
               static_cast<double>(around(s))) *
          cell);
  }
  return lines;
}

} // namespace

WallLines::WallLines(const std::vector<Eigen::Vector2d>& walls,
                     double cell,
                     double min_length)
{
  across_ = directionAt(mainAngle(walls, cell));
  lines_[0] = linesOf(countsAlong(walls, across_, cell), cell, min_length);
  lines_[1] = linesOf(countsAlong(walls, leftTurn(across_), cell), cell, min_length);
}

std::array<std::size_t, 2>
WallLines::before(const Eigen::Vector2d& place) const
{
  const Eigen::Vector2d s = along(place);
  std::array<std::size_t, 2> count{};
  for (std::size_t k = 0; k < 2; ++k)
    count[k] = static_cast<std::size_t>(
        std::lower_bound(lines_[k].begin(), lines_[k].end(), s[static_cast<int>(k)]) -
        lines_[k].begin());
  return count;
}

} // namespace pcl::sedr
