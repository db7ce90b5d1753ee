// SPDX-License-Identifier: BSD-3-Clause
#include "plan_points.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace pcl::sedr {

PlanPoints::PlanPoints(std::vector<Eigen::Vector2d> points, double cell_size)
    : grid_(cell_size)
{
  const auto isHeld = [&](const Eigen::Vector2d& p) {
    return grid_.holds(p.x(), p.y());
  };
  points.erase(std::remove_if(points.begin(), points.end(), std::not_fn(isHeld)),
               points.end());
  std::vector<CellKey> keys;
  keys.reserve(points.size());
  for (const auto& p : points)
    keys.push_back(keyOf(grid_.at(p.x(), p.y())));
  cells_ = CellSet(keys);
  first_.assign(cells_.size() + 1, 0);
  std::vector<std::size_t> cell_of;
  cell_of.reserve(points.size());
  for (const CellKey key : keys) {
    cell_of.push_back(cells_.find(cellOf(key)));
    ++first_[cell_of.back() + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  std::vector<std::size_t> next = first_;
  points_.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    points_[next[cell_of[i]]++] = points[i];
}

} // namespace pcl::sedr
