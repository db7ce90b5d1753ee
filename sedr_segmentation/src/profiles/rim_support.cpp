// SPDX-License-Identifier: BSD-3-Clause
#include "rim_support.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace pcl::sedr {

namespace {

Eigen::Vector3d
at(const PointView& points, pcl::index_t index)
{
  return points[static_cast<std::size_t>(index)].cast<double>();
}

} // namespace

ColumnOccupancy::ColumnOccupancy(const PointView& points,
                                 const CellGrid& grid,
                                 const pcl::Indices& standing)
    : grid_(grid)
{
  occupied_.reserve(standing.size());
  for (const auto i : standing) {
    const Eigen::Vector3d p = at(points, i);
    occupied_.emplace_back(keyOf(grid_.at(p.x(), p.y())),
                           static_cast<std::int64_t>(std::floor(p.z() / grid_.size())));
  }
  std::sort(occupied_.begin(), occupied_.end());
  occupied_.erase(std::unique(occupied_.begin(), occupied_.end()), occupied_.end());
}

double
ColumnOccupancy::share(Cell cell, double bottom, double top) const
{
  const auto first = static_cast<std::int64_t>(std::floor(bottom / grid_.size())) + 1;
  const auto last = static_cast<std::int64_t>(std::floor(top / grid_.size())) - 1;
  if (last < first)
    return 1;

  std::vector<std::int64_t> levels;
  for (std::int32_t y = cell.y - 1; y <= cell.y + 1; ++y)
    for (std::int32_t x = cell.x - 1; x <= cell.x + 1; ++x) {
      const CellKey key = keyOf({x, y});
      auto it = std::lower_bound(occupied_.begin(), occupied_.end(),
                                 std::make_pair(key, first));
      for (; it != occupied_.end() && it->first == key && it->second <= last; ++it)
        levels.push_back(it->second);
    }
  std::sort(levels.begin(), levels.end());
  const auto distinct = std::unique(levels.begin(), levels.end()) - levels.begin();
  return static_cast<double>(distinct) / static_cast<double>(last - first + 1);
}

pcl::Indices
supportedSeeds(const PointView& points,
               const pcl::Indices& seeds,
               const ColumnOccupancy& occupancy,
               double other_height,
               double minimum_share)
{
  const CellGrid& grid = occupancy.grid();
  const CellSet cells(grid, points, seeds);
  const CellRegions rims = labelRegions(cells);

  const auto cellOfSeed = [&](pcl::index_t i) {
    const Eigen::Vector3d p = at(points, i);
    return cells.find(grid.at(p.x(), p.y()));
  };
  std::vector<double> height_sum(cells.size());
  std::vector<std::size_t> seed_count(cells.size());
  for (const auto i : seeds) {
    const std::size_t cell = cellOfSeed(i);
    height_sum[cell] += at(points, i).z();
    ++seed_count[cell];
  }

  std::vector<double> support(rims.sizes.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const double height = height_sum[c] / static_cast<double>(seed_count[c]);
    const double share = occupancy.share(cells[c], std::min(height, other_height),
                                         std::max(height, other_height));
    support[rims.label[c]] += share / static_cast<double>(rims.sizes[rims.label[c]]);
  }

  pcl::Indices supported;
  std::copy_if(seeds.begin(), seeds.end(), std::back_inserter(supported), [&](auto i) {
    return support[rims.label[cellOfSeed(i)]] >= minimum_share;
  });
  return supported;
}

} // namespace pcl::sedr
