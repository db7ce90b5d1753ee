// SPDX-License-Identifier: BSD-3-Clause
#include "height_drops.h"

#include "sedr_filters/src/base/middle_value.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Returns the standard deviation of heights between neighbouring cells, metres.
 * It does not depend on the shape of the surface. */
double
noiseBetween(const CellSet& cells, const std::vector<double>& heights)
{
  std::vector<double> differences;
  for (std::size_t i = 1; i < heights.size(); ++i)
    if (cells[i].y == cells[i - 1].y && cells[i].x == cells[i - 1].x + 1)
      differences.push_back(std::abs(heights[i] - heights[i - 1]));
  return differences.empty()
             ? 0
             : 1.4826 * middleValue(std::move(differences)) / std::sqrt(2);
}

/** @brief Returns the mean of the middle half of some values. Heights of voxels lie in
 * layers, between which a median may jump. */
double
middleMean(std::vector<double>& values)
{
  std::sort(values.begin(), values.end());
  const auto cut = static_cast<std::ptrdiff_t>(values.size() / 4);
  return std::accumulate(values.begin() + cut, values.end() - cut, 0.0) /
         static_cast<double>(values.end() - values.begin() - 2 * cut);
}

} // namespace

std::vector<std::uint8_t>
cellsOfDrops(const CellSet& cells,
             const std::vector<double>& heights,
             const Priors& priors)
{
  constexpr int length = 4;
  constexpr int half_width = 2;
  constexpr std::size_t min_seen = 8; // of the 20 cells of a side
  const double step = std::max(priors.slab_noise, 2 * noiseBetween(cells, heights));
  std::vector<std::uint8_t> marked(heights.size(), 0);
  std::vector<double> before;
  std::vector<double> behind;
  const auto isAcross = [&](std::size_t i, bool along_x) {
    before.clear();
    behind.clear();
    forEachAround(cells, cells[i], length, [&](std::size_t k) {
      const int dx = cells[k].x - cells[i].x;
      const int dy = cells[k].y - cells[i].y;
      const int along = along_x ? dx : dy;
      if (along != 0 && std::abs(along_x ? dy : dx) <= half_width)
        (along < 0 ? before : behind).push_back(heights[k]);
    });
    return before.size() >= min_seen && behind.size() >= min_seen &&
           std::abs(middleMean(behind) - middleMean(before)) >= step;
  };
  for (std::size_t i = 0; i < heights.size(); ++i)
    marked[i] = isAcross(i, true) || isAcross(i, false) ? 1 : 0;
  return marked;
}

} // namespace pcl::sedr
