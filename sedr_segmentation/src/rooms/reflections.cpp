// SPDX-License-Identifier: BSD-3-Clause
#include "reflections.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace pcl::sedr {

namespace {

struct ColumnOfPart {
  CellKey key{};
  const RoomColumn* column = nullptr;
  std::size_t part = 0;
};

/** @brief The columns of all parts, those above each other together, from below. */
std::vector<ColumnOfPart>
stackedColumns(const std::vector<BuildingRoom>& parts)
{
  std::vector<ColumnOfPart> all;
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (const RoomColumn& column : parts[p].columns)
      all.push_back({keyOf(column.cell), &column, p});
  std::sort(all.begin(), all.end(), [](const ColumnOfPart& a, const ColumnOfPart& b) {
    return std::tuple(a.key, a.column->floor, a.part) <
           std::tuple(b.key, b.column->floor, b.part);
  });
  return all;
}

/** @brief Returns 1 for each part of which a share is more than `most`. */
std::vector<std::uint8_t>
whereMore(const std::vector<std::size_t>& some,
          const std::vector<std::size_t>& all,
          double most)
{
  std::vector<std::uint8_t> is_more(all.size());
  for (std::size_t p = 0; p < all.size(); ++p)
    is_more[p] = static_cast<double>(some[p]) > most * static_cast<double>(all[p]);
  return is_more;
}

} // namespace

std::vector<std::uint8_t>
mirrorImages(const std::vector<BuildingRoom>& parts, double surface)
{
  constexpr double same_height = 0.1; // metres
  constexpr double most = 0.8;        // of its columns
  std::vector<std::size_t> mirrored(parts.size(), 0);
  std::vector<std::size_t> columns;
  for (const BuildingRoom& part : parts)
    columns.push_back(part.columns.size());
  const std::vector<ColumnOfPart> all = stackedColumns(parts);
  for (std::size_t k = 0; k + 1 < all.size(); ++k) {
    const RoomColumn& image = *all[k].column;
    const RoomColumn& above = *all[k + 1].column;
    const double floor = parts[all[k + 1].part].floor;
    const bool is_mirrored =
        all[k].key == all[k + 1].key && all[k].part != all[k + 1].part &&
        std::abs(floor - (image.ceiling + above.floor) / 2) <= surface / 2 &&
        std::abs((above.ceiling - above.floor) - (image.ceiling - image.floor)) <=
            same_height;
    mirrored[all[k].part] += is_mirrored ? 1 : 0;
  }
  return whereMore(mirrored, columns, most);
}

std::vector<std::uint8_t>
viewsThroughPanes(const std::vector<BuildingRoom>& parts,
                  const CellGrid& grid,
                  const PointView& points,
                  const std::vector<std::uint8_t>& behind)
{
  constexpr float beside = 0.1F; // metres, of floor and ceiling
  constexpr double most = 0.9;   // of the points
  std::vector<std::size_t> all(parts.size(), 0);
  std::vector<std::size_t> through(parts.size(), 0);
  if (std::find(behind.begin(), behind.end(), 1) == behind.end())
    return whereMore(through, all, most);
  const std::vector<ColumnOfPart> columns = stackedColumns(parts);
  for (std::size_t i = 0; i < std::min(points.size(), behind.size()); ++i) {
    const Eigen::Vector3f p = points[i];
    if (!p.allFinite() || !grid.holds(p.x(), p.y()))
      continue;
    const CellKey key = keyOf(grid.at(p.x(), p.y()));
    auto at = std::lower_bound(
        columns.begin(), columns.end(), key,
        [](const ColumnOfPart& column, CellKey k) { return column.key < k; });
    for (; at != columns.end() && at->key == key; ++at)
      if (p.z() > at->column->floor - beside && p.z() < at->column->ceiling + beside) {
        ++all[at->part];
        through[at->part] += behind[i];
      }
  }
  return whereMore(through, all, most);
}

} // namespace pcl::sedr
