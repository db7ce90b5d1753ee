// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/plan_points.h>

#include <algorithm>
#include <utility>

namespace pcl {
namespace sedr {

PlanPoints::PlanPoints(std::vector<Eigen::Vector2d> points, double cell_size)
    : grid_(cell_size)
{
  std::vector<std::pair<CellKey, std::size_t>> order;
  order.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (grid_.holds(points[i].x(), points[i].y()))
      order.emplace_back(keyOf(grid_.at(points[i].x(), points[i].y())), i);
  std::sort(order.begin(), order.end());
  std::vector<CellKey> keys;
  points_.reserve(order.size());
  for (const auto& [key, i] : order) {
    if (keys.empty() || keys.back() != key) {
      keys.push_back(key);
      first_.push_back(points_.size());
    }
    points_.push_back(points[i]);
  }
  first_.push_back(points_.size());
  cells_ = CellSet::fromSorted(std::move(keys));
}

} // namespace sedr
} // namespace pcl
