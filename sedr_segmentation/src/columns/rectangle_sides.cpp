// SPDX-License-Identifier: BSD-3-Clause
#include "rectangle_sides.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Minimum share of the points that supports a side. */
constexpr double min_share = 0.06;

/** @brief Moves a single unsupported side by at most `slack` to make the rectangle
 * square, as its position is only known to a voxel. */
void
makeSquare(const std::array<bool, 4>& is_shown, double slack, Rectangle& r)
{
  if (std::count(is_shown.begin(), is_shown.end(), false) != 1)
    return;
  const auto hidden = static_cast<std::size_t>(
      std::find(is_shown.begin(), is_shown.end(), false) - is_shown.begin());
  const double other = hidden < 2 ? r.side[3] - r.side[2] : r.side[1] - r.side[0];
  const double square =
      hidden % 2 == 1 ? r.side[hidden - 1] + other : r.side[hidden + 1] - other;
  if (std::abs(square - r.side[hidden]) <= slack)
    r.side[hidden] = square;
}

} // namespace

double
quantile(const std::vector<double>& sorted, double share)
{
  const double at = share * static_cast<double>(sorted.size() - 1);
  return sorted[static_cast<std::size_t>(at + 0.5)];
}

double
endOf(const std::vector<double>& sorted, bool is_high, double voxel)
{
  constexpr double tail = 0.01;
  return is_high ? quantile(sorted, 1 - tail) + voxel / 4
                 : quantile(sorted, tail) - voxel / 4;
}

std::vector<double>
peaksOf(std::vector<double> sorted, double width)
{
  constexpr std::size_t most = 4;
  const double least = min_share * static_cast<double>(sorted.size());
  std::vector<double> peaks;
  while (peaks.size() < most && !sorted.empty()) {
    std::size_t best_first = 0;
    std::size_t best_count = 0;
    for (std::size_t first = 0, last = 0; last < sorted.size(); ++last) {
      while (sorted[last] - sorted[first] > width)
        ++first;
      if (last - first + 1 > best_count) {
        best_count = last - first + 1;
        best_first = first;
      }
    }
    if (static_cast<double>(best_count) < least)
      break;
    double sum = 0;
    for (std::size_t i = best_first; i < best_first + best_count; ++i)
      sum += sorted[i];
    const double peak = sum / static_cast<double>(best_count);
    peaks.push_back(peak);
    sorted.erase(std::remove_if(sorted.begin(), sorted.end(),
                                [&](double v) { return std::abs(v - peak) <= width; }),
                 sorted.end());
  }
  return peaks;
}

std::array<std::vector<Eigen::Vector2d>, 4>
pointsOfSides(const std::vector<Eigen::Vector2d>& in_frame,
              const Rectangle& rectangle,
              double band)
{
  std::array<std::vector<Eigen::Vector2d>, 4> sides;
  for (const auto& p : in_frame) {
    std::size_t on = 4;
    std::size_t count = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t other = k < 2 ? 2 : 0;
      const double along = p[static_cast<Eigen::Index>(other / 2)];
      if (std::abs(rectangle.fromSide(p, k)) > band ||
          along < rectangle.side[other] - band ||
          along > rectangle.side[other + 1] + band)
        continue;
      on = k;
      ++count;
    }
    if (count == 1)
      sides[on].push_back(p);
  }
  return sides;
}

void
judgeSides(const std::vector<Eigen::Vector2d>& in_frame, double band, Rectangle& r)
{
  const auto sides = pointsOfSides(in_frame, r, band);
  const double least = std::max(5.0, min_share * static_cast<double>(in_frame.size()));
  std::array<bool, 4> is_shown{};
  for (std::size_t k = 0; k < 4; ++k) {
    is_shown[k] = static_cast<double>(sides[k].size()) >= least;
    double sum = 0;
    for (const auto& p : sides[k])
      sum += std::pow(r.fromSide(p, k), 2);
    r.inliers[k] = is_shown[k] ? sides[k].size() : 0;
    r.residual[k] =
        is_shown[k] ? std::sqrt(sum / static_cast<double>(sides[k].size())) : 0;
  }
  for (std::size_t k = 0; k < 4; ++k) {
    if (is_shown[k])
      continue;
    const std::size_t beside = k < 2 ? 2 : 0;
    std::vector<double> along;
    for (const auto& p : in_frame)
      if (std::abs(r.fromSide(p, beside)) <= band ||
          std::abs(r.fromSide(p, beside + 1)) <= band)
        along.push_back(p[static_cast<Eigen::Index>(k / 2)]);
    if (along.size() < 5)
      continue;
    std::sort(along.begin(), along.end());
    r.side[k] = endOf(along, k % 2 == 1, band);
  }
  makeSquare(is_shown, band, r);
}

} // namespace pcl::sedr
