// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_filters/impl/grid_region_outlier_removal.hpp>
#include <pcl/sedr_filters/point_types.h>

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

RegionMap
selectRegions(const PointView& points, const pcl::Indices& indices, double cell_size)
{
  RegionMap map;
  map.cell_size = cell_size;
  map.cells = CellSet(CellGrid(cell_size), points, indices);
  map.regions = labelRegions(map.cells);
  map.threshold = largestGapThreshold(map.regions.sizes);
  int kept = 0;
  for (const std::size_t size : map.regions.sizes)
    map.number.push_back(size > map.threshold ? ++kept : 0);
  return map;
}

std::vector<int>
labelPoints(const RegionMap& map, const PointView& points, const pcl::Indices& indices)
{
  const CellGrid grid(map.cell_size);
  std::vector<int> label(points.size(), 0);
  for (const auto index : indices) {
    const auto i = static_cast<std::size_t>(index);
    const Eigen::Vector3f p = points[i];
    if (!points.isFinite(i))
      label[i] = -1;
    else if (grid.holds(p.x(), p.y()))
      label[i] = map.number[map.regions.label[map.cells.find(grid.at(p.x(), p.y()))]];
  }
  return label;
}

} // namespace pcl::sedr

PCL_INSTANTIATE(GridRegionOutlierRemoval, SEDR_POINT_TYPES)
