// SPDX-License-Identifier: BSD-3-Clause
#include "place_table.h"

#include <algorithm>

namespace pcl::sedr {

void
PlaceTable::addIn(const Eigen::AlignedBox2d& box, std::uint32_t number)
{
  entries_.push_back({table_.boxAround(box.min(), box.max()), number});
}

void
PlaceTable::addAlong(const PlanElement& element, double reach, std::uint32_t number)
{
  constexpr double rounding = 1e-6; // metres
  const double step = table_.grid().size();
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(reach + step / 2 + rounding);
  const double length = element.length();
  for (double s = 0; s < length + step; s += step) {
    const Eigen::Vector2d p = element.pointAt(std::min(s, length));
    addIn({p - margin, p + margin}, number);
    if (entries_.back().box.count() == 0)
      return; // too far away for a table
  }
}

void
PlaceTable::finish()
{
  const bool is_held =
      std::all_of(entries_.begin(), entries_.end(),
                  [](const CellTable::Entry& e) { return e.box.count() > 0; });
  if (!is_held || !table_.fill(entries_).empty())
    for (const auto& entry : entries_)
      if (all_.empty() || all_.back() != entry.number)
        all_.push_back(entry.number);
  entries_ = {};
}

} // namespace pcl::sedr
