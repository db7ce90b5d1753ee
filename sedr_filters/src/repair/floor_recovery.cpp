// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/impl/floor_recovery.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace pcl::sedr {

namespace {

using CellPoint = std::pair<CellKey, pcl::index_t>;

/** @brief Returns the points of `indices` in `cells`, with their cells, sorted. */
std::vector<CellPoint>
pointsByCell(const CellSet& cells,
             const CellGrid& grid,
             const PointView& points,
             const pcl::Indices& indices)
{
  std::vector<CellPoint> found;
  for (const auto index : indices) {
    const auto i = static_cast<std::size_t>(index);
    const Eigen::Vector3f p = points[i];
    if (!points.isFinite(i) || !grid.holds(p.x(), p.y()))
      continue;
    const Cell cell = grid.at(p.x(), p.y());
    if (cells.contains(cell))
      found.emplace_back(keyOf(cell), index);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

} // namespace

FloorRecovery
recoverFloor(const CellGrid& grid,
             const PointView& points,
             const pcl::Indices& floor,
             const pcl::Indices& ceiling,
             const pcl::Indices& detail)
{
  const CellSet under_ceiling(grid, points, ceiling);
  const CellSet scope = unite(under_ceiling, CellSet(grid, points, detail));
  FloorRecovery result;
  for (const auto index : floor) {
    const auto i = static_cast<std::size_t>(index);
    const Eigen::Vector3f p = points[i];
    const bool inside = points.isFinite(i) && grid.holds(p.x(), p.y()) &&
                        scope.contains(grid.at(p.x(), p.y()));
    (inside ? result.kept : result.removed).push_back(index);
  }

  const CellSet missing = subtract(scope, CellSet(grid, points, result.kept));
  auto sources = pointsByCell(missing, grid, points, ceiling);
  const auto details =
      pointsByCell(subtract(missing, under_ceiling), grid, points, detail);
  const auto ceilings = static_cast<std::ptrdiff_t>(sources.size());
  sources.insert(sources.end(), details.begin(), details.end());
  std::inplace_merge(sources.begin(), sources.begin() + ceilings, sources.end());
  result.sources.reserve(sources.size());
  for (const auto& source : sources)
    result.sources.push_back(source.second);
  return result;
}

double
meanHeight(const PointView& points, const pcl::Indices& indices)
{
  if (indices.empty())
    return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  for (const auto i : indices)
    sum += points[static_cast<std::size_t>(i)].z();
  return sum / static_cast<double>(indices.size());
}

} // namespace pcl::sedr
