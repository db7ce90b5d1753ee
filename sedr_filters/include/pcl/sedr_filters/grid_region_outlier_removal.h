// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/filters/filter_indices.h>
#include <pcl/sedr_filters/impl/stage_error.h>
#include <pcl/sedr_filters/point_view.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief The connected regions of the cells of a cloud, and which are kept (paper,
 * Figure 3c). */
struct GridRegions {
  std::vector<int> labels; ///< of each point: 1 .. n in a kept region, 0 in none or not
                           ///< among the indices, -1 if it is not finite
  std::vector<std::size_t> sizes; ///< of all regions, cells, decreasing
  std::size_t threshold = 0;      ///< cells; larger regions are kept
  std::size_t kept = 0;           ///< n, number of regions
};

/** @brief Finds the regions of `points[indices]` and numbers those that are kept.
 * @param cell_size metres, above 0 */
GridRegions
findGridRegions(const PointView& points, const pcl::Indices& indices, double cell_size);

} // namespace sedr

/** @brief Removes points outside the large regions in plan (paper, section 2.3.1). Such
 * points belong to rooms beside it or the street, seen through doors and windows at
 * ceiling height.
 *
 * The points are divided into square cells of the x-y plane (z up, metres). Occupied
 * cells that touch, corners included, form a region. The region sizes in cells are
 * sorted; the threshold is the smaller size at their largest difference, and larger
 * regions are kept. A single region, or several of one size, are all kept. The kept
 * regions are the first segmentation into rooms.
 *
 * Non-finite points are never kept, even with setNegative(true), and are always among
 * the removed indices. An empty cloud gives an empty output. After invalid input, such
 * as a grid size that is not above 0 or an index beyond the cloud, PCL_ERROR is
 * printed, nothing is kept, and getErrorMessage() gives the reason. O(n log n) in time,
 * O(n) in memory at any extent. Single-threaded and deterministic. */
template <typename PointT>
class GridRegionOutlierRemoval : public FilterIndices<PointT>, public sedr::StageError {
public:
  using Ptr = shared_ptr<GridRegionOutlierRemoval<PointT>>;
  using ConstPtr = shared_ptr<const GridRegionOutlierRemoval<PointT>>;
  using PointCloud = typename FilterIndices<PointT>::PointCloud;

  /** @param extract_removed_indices whether getRemovedIndices() is filled */
  explicit GridRegionOutlierRemoval(bool extract_removed_indices = false)
      : FilterIndices<PointT>(extract_removed_indices)
  {
    filter_name_ = "GridRegionOutlierRemoval";
  }

  /** @brief Sets the edge of a cell, metres, > 0 (default 0.05), at least the leaf
   * size. */
  void setGridSize(double size) { cell_size_ = size; }
  double getGridSize() const { return cell_size_; }

  /** @brief Writes the kept points to `output`, which may be the input cloud. */
  void filter(PointCloud& output);

  /** @brief Writes the indices of the kept points to `indices`, in input order. */
  void filter(Indices& indices);

  /** @brief Returns the region of each input point after the last run: 1 .. n for the
   * kept regions by decreasing size, 0 for all other points. */
  const std::vector<int>& getRegionLabels() const { return regions_.labels; }

  /** @brief Returns the sizes of all regions, kept or not: cells, decreasing. */
  const std::vector<std::size_t>& getRegionSizes() const { return regions_.sizes; }

  /** @brief Returns the adaptive threshold, in cells: larger regions were kept. */
  std::size_t getThreshold() const { return regions_.threshold; }

  /** @brief Returns the number of regions that the last run kept. */
  std::size_t getNumberOfRegions() const { return regions_.kept; }

protected:
  using FilterIndices<PointT>::filter_name_;
  using FilterIndices<PointT>::input_;
  using FilterIndices<PointT>::indices_;
  using FilterIndices<PointT>::negative_;
  using FilterIndices<PointT>::keep_organized_;
  using FilterIndices<PointT>::removed_indices_;
  using FilterIndices<PointT>::extract_removed_indices_;
  using FilterIndices<PointT>::applyFilter;

  void applyFilter(Indices& indices) override;

private:
  void clearResults();

  bool validate();

  double cell_size_ = 0.05;
  sedr::GridRegions regions_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_filters/impl/grid_region_outlier_removal.hpp>
#endif
