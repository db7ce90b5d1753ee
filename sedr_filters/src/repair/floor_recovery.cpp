// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/impl/refinement.h>

#include "../grids/cell_set.h"

#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_filters/impl/floor_projection_recovery.hpp>
#include <pcl/sedr_filters/impl/structure_refinement.hpp>
#include <pcl/sedr_filters/impl/vertical_hole_repair.hpp>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace pcl::sedr {

FloorRecovery
recoverFloor(double cell_size,
             const PointView& points,
             const pcl::Indices& floor,
             const pcl::Indices& ceiling,
             const pcl::Indices& detail)
{
  const CellGrid grid(cell_size);
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
  std::vector<std::pair<CellKey, pcl::index_t>> sources;
  const auto addFrom = [&](const pcl::Indices& indices, const CellSet& cells) {
    for (const auto index : indices) {
      const auto i = static_cast<std::size_t>(index);
      const Eigen::Vector3f p = points[i];
      if (!points.isFinite(i) || !grid.holds(p.x(), p.y()))
        continue;
      if (const Cell cell = grid.at(p.x(), p.y()); cells.contains(cell))
        sources.emplace_back(keyOf(cell), index);
    }
  };
  addFrom(ceiling, missing);
  addFrom(detail, subtract(missing, under_ceiling));
  std::sort(sources.begin(), sources.end());
  sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
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

PCL_INSTANTIATE(FloorProjectionRecovery, SEDR_POINT_TYPES)

PCL_INSTANTIATE(StructureRefinement, SEDR_POINT_TYPES)

PCL_INSTANTIATE(VerticalHoleRepair, SEDR_POINT_TYPES)
