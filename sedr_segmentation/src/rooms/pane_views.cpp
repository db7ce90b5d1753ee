// SPDX-License-Identifier: BSD-3-Clause
#include "pane_views.h"

#include <algorithm>
#include <cstddef>

namespace pcl::sedr {

namespace {

struct CellColumn {
  std::uint64_t key = 0;
  const RoomColumn* column = nullptr;
  std::size_t part = 0;
};

std::vector<CellColumn>
columnsByCell(const std::vector<BuildingRoom>& parts)
{
  std::vector<CellColumn> all;
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (const RoomColumn& column : parts[p].columns)
      all.push_back({static_cast<std::uint64_t>(keyOf(column.cell)), &column, p});
  std::stable_sort(
      all.begin(), all.end(),
      [](const CellColumn& a, const CellColumn& b) { return a.key < b.key; });
  return all;
}

} // namespace

std::vector<std::uint8_t>
viewsThroughPanes(const std::vector<BuildingRoom>& parts,
                  const CellGrid& grid,
                  const PointView& points,
                  const std::vector<std::uint8_t>& behind)
{
  constexpr float beside = 0.1F; // metres, of floor and ceiling
  constexpr double least = 0.9;  // of the points
  std::vector<std::uint8_t> is_view(parts.size(), 0);
  if (std::find(behind.begin(), behind.end(), 1) == behind.end())
    return is_view;
  const std::vector<CellColumn> columns = columnsByCell(parts);
  std::vector<std::size_t> all(parts.size(), 0);
  std::vector<std::size_t> through(parts.size(), 0);
  for (std::size_t i = 0; i < std::min(points.size(), behind.size()); ++i) {
    const Eigen::Vector3f p = points[i];
    if (!p.allFinite() || !grid.holds(p.x(), p.y()))
      continue;
    const auto key = static_cast<std::uint64_t>(keyOf(grid.at(p.x(), p.y())));
    auto at = std::lower_bound(
        columns.begin(), columns.end(), key,
        [](const CellColumn& column, std::uint64_t k) { return column.key < k; });
    for (; at != columns.end() && at->key == key; ++at)
      if (p.z() > at->column->floor - beside && p.z() < at->column->ceiling + beside) {
        ++all[at->part];
        through[at->part] += behind[i];
      }
  }
  for (std::size_t p = 0; p < parts.size(); ++p)
    is_view[p] = all[p] > 0 && static_cast<double>(through[p]) >=
                                   least * static_cast<double>(all[p])
                     ? 1
                     : 0;
  return is_view;
}

} // namespace pcl::sedr
