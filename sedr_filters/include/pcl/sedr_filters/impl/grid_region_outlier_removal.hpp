// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/common/io.h>
#include <pcl/point_types.h>
#include <pcl/sedr_filters/grid_region_outlier_removal.h>
#include <pcl/sedr_filters/impl/pcl_bases.hpp>

#include <algorithm>
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
  regions_ = sedr::GridRegions();
}

template <typename PointT>
bool
GridRegionOutlierRemoval<PointT>::validate()
{
  std::string problem = sedr::positiveProblem({{"the grid size", cell_size_}});
  if (problem.empty())
    problem = sedr::indicesProblem(*indices_, input_->size());
  return problem.empty() || fail("GridRegionOutlierRemoval", problem);
}

template <typename PointT>
void
GridRegionOutlierRemoval<PointT>::applyFilter(Indices& indices)
{
  clearResults();
  Indices kept; // `indices` may be the input indices themselves
  if (validate()) {
    regions_ = sedr::findGridRegions(sedr::PointView(*input_), *indices_, cell_size_);
    for (const auto index : *indices_) {
      const int label = regions_.labels[static_cast<std::size_t>(index)];
      if (label >= 0 && (label > 0) != negative_)
        kept.push_back(index);
      else if (extract_removed_indices_)
        removed_indices_->push_back(index);
    }
    std::replace(regions_.labels.begin(), regions_.labels.end(), -1, 0);
  }
  else if (extract_removed_indices_)
    *removed_indices_ = sedr::indicesInRange(*indices_, input_->size());
  indices.swap(kept);
}

} // namespace pcl

#define PCL_INSTANTIATE_GridRegionOutlierRemoval(T)                                    \
  template class PCL_EXPORTS pcl::GridRegionOutlierRemoval<T>;
