// SPDX-License-Identifier: BSD-3-Clause
#include "place_table.h"

#include <algorithm>
#include <utility>

namespace pcl::sedr {

void
PlaceTable::addIn(const Eigen::AlignedBox2d& box, std::uint32_t number)
{
  const Eigen::Vector2d& low = box.min();
  const Eigen::Vector2d& high = box.max();
  const bool is_held = grid_.holds(low.x(), low.y()) && grid_.holds(high.x(), high.y());
  entries_.push_back(
      {is_held ? CellBox{grid_.at(low.x(), low.y()), grid_.at(high.x(), high.y())}
               : CellBox{{0, 0}, {-1, -1}},
       number});
}

void
PlaceTable::addAlong(const PlanElement& element, double reach, std::uint32_t number)
{
  constexpr double rounding = 1e-6; // metres
  const double step = grid_.size();
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(reach + step / 2 + rounding);
  const double length = element.length();
  for (double s = 0; s < length + step; s += step) {
    const Eigen::Vector2d p = element.pointAt(std::min(s, length));
    addIn({p - margin, p + margin}, number);
    if (entries_.back().box.count() == 0)
      return; // too far away for a table
  }
}

std::string
PlaceTable::finish()
{
  CellBox box{{0, 0}, {-1, -1}};
  std::string problem;
  for (const Entry& entry : entries_) {
    box = around(box, entry.box);
    if (entry.box.count() == 0)
      problem = "a part of the plan lies too far away";
  }
  if (problem.empty() && !entries_.empty())
    problem = maskProblem(box);
  const std::vector<Entry> entries = std::exchange(entries_, {});
  if (!problem.empty()) {
    for (const Entry& entry : entries)
      if (all_.empty() || all_.back() != entry.number)
        all_.push_back(entry.number);
    return problem;
  }
  frame_ = CellMask(box);
  numbers_.resize(frame_.values().size());
  for (const Entry& entry : entries)
    for (std::int32_t y = entry.box.low.y; y <= entry.box.high.y; ++y)
      for (std::int32_t x = entry.box.low.x; x <= entry.box.high.x; ++x) {
        Numbers& numbers = numbers_[frame_.indexOf({x, y})];
        if (numbers.empty() || numbers.back() != entry.number)
          numbers.push_back(entry.number);
      }
  return {};
}

} // namespace pcl::sedr
