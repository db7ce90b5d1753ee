// SPDX-License-Identifier: BSD-3-Clause
#include "../grids/cell_set.h"

#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_filters/impl/grid_region_outlier_removal.hpp>
#include <pcl/sedr_filters/point_types.h>

#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Returns the adaptive threshold of the paper (section 2.3.1): the smaller size
 * at the largest difference between consecutive sizes, which decrease. It is 0 for
 * fewer than two regions and for regions of one size; among equal differences the one
 * between the smaller regions counts. */
std::size_t
largestGapThreshold(const std::vector<std::size_t>& sizes)
{
  std::size_t threshold = 0;
  std::size_t largest = 1;
  for (std::size_t i = 1; i < sizes.size(); ++i)
    if (const std::size_t difference = sizes[i - 1] - sizes[i]; difference >= largest) {
      largest = difference;
      threshold = sizes[i];
    }
  return threshold;
}

} // namespace

GridRegions
findGridRegions(const PointView& points, const pcl::Indices& indices, double cell_size)
{
  const CellGrid grid(cell_size);
  const CellSet cells(grid, points, indices);
  CellRegions all = labelRegions(cells);
  GridRegions regions;
  regions.threshold = largestGapThreshold(all.sizes);
  while (regions.kept < all.sizes.size() && all.sizes[regions.kept] > regions.threshold)
    ++regions.kept;
  regions.labels.assign(points.size(), 0);
  for (const auto index : indices) {
    const auto i = static_cast<std::size_t>(index);
    const Eigen::Vector3f p = points[i];
    if (!points.isFinite(i))
      regions.labels[i] = -1;
    else if (grid.holds(p.x(), p.y())) {
      const std::size_t region = all.label[cells.find(grid.at(p.x(), p.y()))];
      regions.labels[i] = region < regions.kept ? static_cast<int>(region) + 1 : 0;
    }
  }
  regions.sizes = std::move(all.sizes);
  return regions;
}

} // namespace pcl::sedr

PCL_INSTANTIATE(GridRegionOutlierRemoval, SEDR_POINT_TYPES)
