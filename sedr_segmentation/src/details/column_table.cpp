// SPDX-License-Identifier: BSD-3-Clause
#include "column_table.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace pcl::sedr {

ColumnTable::ColumnTable(const CellGrid& grid,
                         const CellBox& box,
                         const PointView& points,
                         const std::vector<int>& indices)
    : frame_(box)
    , first_(frame_.values().size() + 1, 0)
{
  std::vector<std::pair<std::size_t, Entry>> all;
  for (const int i : indices) {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    if (!std::isfinite(p.z()) || !grid.holds(p.x(), p.y()))
      continue;
    const Cell cell = grid.at(p.x(), p.y());
    if (!frame_.isInside(cell))
      continue;
    all.push_back({frame_.indexOf(cell), {p.z(), i}});
    ++first_[all.back().first + 1];
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return std::tie(a.first, a.second.z, a.second.index) <
           std::tie(b.first, b.second.z, b.second.index);
  });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  for (const auto& [cell, entry] : all)
    entries_.push_back(entry);
}

bool
ColumnTable::hasWithin(Cell cell, double low, double high) const
{
  const Entry* const last = end(cell);
  const Entry* const it = std::lower_bound(
      begin(cell), last, low, [](const Entry& e, double z) { return e.z < z; });
  return it != last && it->z <= high;
}

std::vector<ColumnRun>
ColumnTable::runs(Cell cell, double gap) const
{
  std::vector<ColumnRun> result;
  for (const Entry* e = begin(cell); e != end(cell); ++e) {
    if (result.empty() || e->z - result.back().high > gap)
      result.push_back({e->z, e->z});
    result.back().high = e->z;
  }
  return result;
}

} // namespace pcl::sedr
