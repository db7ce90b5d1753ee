// SPDX-License-Identifier: BSD-3-Clause
#include "plan_points.h"

#include <numeric>

namespace pcl::sedr {

PlanPoints::PlanPoints(const std::vector<Eigen::Vector2d>& points, double cell_size)
    : grid_(cell_size)
{
  std::vector<CellKey> keys;
  std::vector<std::uint32_t> held;
  keys.reserve(points.size());
  held.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (grid_.holds(points[i].x(), points[i].y())) {
      keys.push_back(keyOf(grid_.at(points[i].x(), points[i].y())));
      held.push_back(static_cast<std::uint32_t>(i));
    }
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
  points_.resize(held.size());
  given_.resize(held.size());
  for (std::size_t i = 0; i < held.size(); ++i) {
    const std::size_t at = next[cell_of[i]]++;
    points_[at] = points[held[i]];
    given_[at] = held[i];
  }
}

} // namespace pcl::sedr
