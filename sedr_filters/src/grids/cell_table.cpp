// SPDX-License-Identifier: BSD-3-Clause
#include "cell_table.h"

#include <utility>

namespace pcl::sedr {

CellBox
CellTable::boxAround(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const
{
  if (!grid_.holds(low.x(), low.y()) || !grid_.holds(high.x(), high.y()))
    return {{0, 0}, {-1, -1}};
  return {grid_.at(low.x(), low.y()), grid_.at(high.x(), high.y())};
}

std::string
CellTable::fill(const std::vector<Entry>& entries)
{
  CellBox all{{0, 0}, {-1, -1}};
  for (const auto& [box, number] : entries)
    all = around(all, box);
  if (all.count() == 0)
    return {};
  const std::string problem = maskProblem(all);
  if (!problem.empty())
    return problem;
  frame_ = CellMask(all);
  const auto forEachCell = [&](const CellBox& box, const auto& visit) {
    for (std::int32_t y = box.low.y; y <= box.high.y; ++y)
      for (std::int32_t x = box.low.x; x <= box.high.x; ++x)
        visit(frame_.indexOf({x, y}));
  };
  first_.assign(frame_.values().size(), 0);
  for (const auto& [box, number] : entries)
    forEachCell(box, [&](std::size_t i) { ++first_[i]; });
  std::size_t total = 0;
  for (auto& first : first_)
    total += std::exchange(first, total);
  last_ = first_;
  numbers_.resize(total);
  for (const auto& entry : entries)
    forEachCell(entry.box, [&](std::size_t i) {
      if (last_[i] == first_[i] || numbers_[last_[i] - 1] != entry.number)
        numbers_[last_[i]++] = entry.number;
    });
  return {};
}

} // namespace pcl::sedr
