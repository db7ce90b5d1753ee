// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_filters/impl/grid_region_outlier_removal.hpp>
#include <pcl/sedr_filters/point_types.h>

#include <cmath>

namespace pcl::sedr {

std::vector<CellSet>
RegionMap::regionCells() const
{
  std::vector<std::vector<CellKey>> keys(regions.sizes.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    keys[regions.label[i]].push_back(cells.keys()[i]);
  std::vector<CellSet> sets;
  for (auto& own : keys)
    sets.push_back(CellSet::fromSorted(std::move(own)));
  return sets;
}

std::string
problemOf(const RegionParameters& parameters)
{
  if (!(parameters.cell_size > 0) || !std::isfinite(parameters.cell_size))
    return "the grid size must be above 0 m, it is " +
           std::to_string(parameters.cell_size);
  if (!(parameters.minimum_support >= 0 && parameters.minimum_support <= 1))
    return "the minimum support must lie between 0 and 1, it is " +
           std::to_string(parameters.minimum_support);
  return {};
}

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
selectRegions(const PointView& points,
              const pcl::Indices& indices,
              const pcl::Indices* support,
              const RegionParameters& parameters)
{
  const CellGrid grid(parameters.cell_size);
  RegionMap map;
  map.cell_size = parameters.cell_size;
  map.cells = CellSet(grid, points, indices);
  map.regions = labelRegions(map.cells);
  const std::vector<std::size_t>& sizes = map.regions.sizes;
  map.threshold = largestGapThreshold(sizes);
  std::vector<std::size_t> supported(sizes.size(), 0); // cells on or beside support
  const CellSet below = support ? CellSet(grid, points, *support) : CellSet();
  for (std::size_t i = 0; i < map.cells.size(); ++i)
    if (anyAround(below, map.cells[i], 1, [](std::size_t) { return true; }))
      ++supported[map.regions.label[i]];
  map.number.assign(sizes.size(), 0);
  int kept = 0;
  for (std::size_t r = 0; r < sizes.size(); ++r) {
    const bool is_supported =
        support && sizes[r] >= parameters.minimum_supported_cells &&
        static_cast<double>(supported[r]) >=
            parameters.minimum_support * static_cast<double>(sizes[r]);
    if (sizes[r] > map.threshold || is_supported)
      map.number[r] = ++kept;
  }
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
