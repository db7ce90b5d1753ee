// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/common/io.h>
#include <pcl/filters/impl/filter_indices.hpp>
#include <pcl/impl/pcl_base.hpp>
#include <pcl/point_types.h>
#include <pcl/sedr_filters/grid_region_outlier_removal.h>

#include <cmath>
#include <string>

namespace pcl {

template <typename PointT>
void
GridRegionOutlierRemoval<PointT>::filter(PointCloud& output)
{
  if (input_) {
    FilterIndices<PointT>::filter(output);
    if (!keep_organized_)
      output.is_dense = true;
    return;
  }
  clearResults();
  fail("GridRegionOutlierRemoval", "no input cloud was set");
  output.clear();
}

template <typename PointT>
void
GridRegionOutlierRemoval<PointT>::filter(Indices& indices)
{
  if (input_) {
    FilterIndices<PointT>::filter(indices);
    return;
  }
  clearResults();
  fail("GridRegionOutlierRemoval", "no input cloud was set");
  indices.clear();
}

template <typename PointT>
void
GridRegionOutlierRemoval<PointT>::clearResults()
{
  clearError();
  removed_indices_->clear();
  region_labels_.clear();
  region_map_ = sedr::RegionMap();
  number_of_regions_ = 0;
}

template <typename PointT>
bool
GridRegionOutlierRemoval<PointT>::validate()
{
  constexpr const char* name = "GridRegionOutlierRemoval";
  if (!(grid_size_ > 0) || !std::isfinite(grid_size_))
    return fail(name,
                "the grid size must be above 0 m, it is " + std::to_string(grid_size_));
  if (opening_radius_ < 0)
    return fail(name, "the opening radius must be at least 0 cells, it is " +
                          std::to_string(opening_radius_));
  if (!(minimum_support_ >= 0 && minimum_support_ <= 1))
    return fail(name, "the minimum support must lie between 0 and 1, it is " +
                          std::to_string(minimum_support_));
  std::string problem = sedr::indicesProblem(*indices_, input_->size());
  if (!problem.empty())
    return fail(name, problem);
  if (support_)
    problem = sedr::indicesProblem(*support_, input_->size());
  return problem.empty() || fail(name, "support " + problem);
}

template <typename PointT>
std::vector<int>
GridRegionOutlierRemoval<PointT>::numberKeptRegions(const sedr::CellGrid& grid) const
{
  const sedr::CellRegions& regions = region_map_.regions;
  std::vector<std::size_t> supported(regions.sizes.size(), 0);
  if (support_)
    supported =
        sedr::supportedCells(region_map_.cells, regions,
                             sedr::CellSet(grid, sedr::PointView(*input_), *support_));
  std::vector<int> number(regions.sizes.size(), 0);
  int kept = 0;
  for (std::size_t r = 0; r < number.size(); ++r) {
    const std::size_t size = regions.sizes[r];
    const bool is_supported = support_ && size >= minimum_supported_cells_ &&
                              static_cast<double>(supported[r]) >=
                                  minimum_support_ * static_cast<double>(size);
    if (size > region_map_.threshold || is_supported)
      number[r] = ++kept;
  }
  return number;
}

template <typename PointT>
void
GridRegionOutlierRemoval<PointT>::labelPoints(const sedr::CellGrid& grid)
{
  const sedr::PointView points(*input_);
  for (const auto index : *indices_) {
    const auto i = static_cast<std::size_t>(index);
    const Eigen::Vector3f p = points[i];
    if (!points.isFinite(i) || !grid.holds(p.x(), p.y()))
      continue;
    const std::size_t cell = region_map_.cells.find(grid.at(p.x(), p.y()));
    region_labels_[i] = region_map_.number[region_map_.regions.label[cell]];
  }
}

template <typename PointT>
void
GridRegionOutlierRemoval<PointT>::split(Indices& kept)
{
  const sedr::PointView points(*input_);
  for (const auto index : *indices_) {
    const auto i = static_cast<std::size_t>(index);
    const bool in_region = region_labels_[i] > 0;
    if (points.isFinite(i) && in_region != negative_)
      kept.push_back(index);
    else if (extract_removed_indices_)
      removed_indices_->push_back(index);
  }
}

template <typename PointT>
void
GridRegionOutlierRemoval<PointT>::applyFilter(Indices& indices)
{
  clearResults();
  Indices kept; // `indices` may be the very ones that were set
  if (validate()) {
    labelRegions();
    split(kept);
  }
  else if (extract_removed_indices_)
    *removed_indices_ = sedr::indicesInRange(*indices_, input_->size());
  indices.swap(kept);
}

template <typename PointT>
void
GridRegionOutlierRemoval<PointT>::labelRegions()
{
  const sedr::CellGrid grid(grid_size_);
  region_map_.cell_size = grid_size_;
  region_map_.cells = sedr::CellSet(grid, sedr::PointView(*input_), *indices_);
  region_map_.regions =
      sedr::labelOpenedRegions(region_map_.cells, opening_radius_, minimum_part_);
  region_map_.threshold = sedr::largestGapThreshold(region_map_.regions.sizes);
  region_map_.number = numberKeptRegions(grid);
  for (const int n : region_map_.number)
    number_of_regions_ += n > 0 ? 1 : 0;
  region_labels_.assign(input_->size(), 0);
  labelPoints(grid);
}

} // namespace pcl

#define PCL_INSTANTIATE_GridRegionOutlierRemoval(T)                                    \
  template class PCL_EXPORTS pcl::GridRegionOutlierRemoval<T>;
