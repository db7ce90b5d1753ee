// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/plan_points.h>

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
  for (const auto& [key, i] : order) {
    keys_.push_back(key);
    points_.push_back(points[i]);
  }
}

} // namespace sedr
} // namespace pcl
