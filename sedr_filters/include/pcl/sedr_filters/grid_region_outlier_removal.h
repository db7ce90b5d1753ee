// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/filters/filter_indices.h>
#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/stage_error.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief The regions of a plan and which of them are kept (paper, Figure 3c). */
struct RegionMap {
  double cell_size = 0;      ///< metres
  CellSet cells;             ///< all occupied cells: 1 in the binary map
  CellRegions regions;       ///< of the cells, largest first
  std::vector<int> number;   ///< of each region: 1 .. n if kept, 0 if not
  std::size_t threshold = 0; ///< in cells, regions above it are kept

  /** @brief The cells of every region. O(cells). */
  std::vector<CellSet> regionCells() const;

  /** @brief The cells of all regions that are kept. O(cells). */
  CellSet keptCells() const;
};

/** @brief How GridRegionOutlierRemoval chooses regions, see its setters. */
struct RegionParameters {
  double cell_size = 0.05;                   ///< metres
  int opening_radius = 0;                    ///< cells
  std::size_t minimum_part = 400;            ///< cells
  double minimum_support = 0.5;              ///< share of a region's cells
  std::size_t minimum_supported_cells = 400; ///< of a region kept for its support
};

/** @brief What is wrong with the parameters, a sentence; empty if nothing is. */
std::string problemOf(const RegionParameters& parameters);

/** @brief The regions of `points[indices]`, numbered where they are kept.
 * @param support points that speak for a region; null: size alone decides */
RegionMap selectRegions(const PointView& points,
                        const pcl::Indices& indices,
                        const pcl::Indices* support,
                        const RegionParameters& parameters);

/** @brief The number of the region of each point of the cloud, 0 where it is not kept
 * or not among the indices, -1 for points that are not finite. */
std::vector<int>
labelPoints(const RegionMap& map, const PointView& points, const pcl::Indices& indices);

} // namespace sedr

/** @brief Removes what is not part of a large region in plan (paper, section 2.3.1):
 * pieces of neighbouring rooms or of the street, seen through doors and windows at the
 * height of a ceiling.
 *
 * The points are divided into square cells of the x-y plane (z up, metres); occupied
 * cells that touch, corners included, form a region; the sizes of the regions in cells
 * are sorted, and regions above the smaller side of their largest difference are kept.
 * One region alone, or several of one size, are all kept. The kept regions are the
 * first segmentation into rooms.
 *
 * Non-finite points are never kept, with setNegative(true) neither, and always among
 * the removed indices. An empty cloud gives an empty output. A grid size that is not
 * above 0, an index beyond the cloud, and the like: PCL_ERROR, nothing is kept, and
 * getErrorMessage() says why. O(n log n) in time, O(n) in memory at any extent; no
 * threads, no chance.
 * @code
 * pcl::GridRegionOutlierRemoval<pcl::PointXYZ> removal;
 * removal.setInputCloud(scan);
 * removal.setIndices(ceiling);
 * pcl::Indices kept;
 * removal.filter(kept);
 * const std::size_t rooms = removal.getNumberOfRegions();
 * @endcode */
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

  /** @brief Edge of a cell, metres, > 0 (default 0.05): the leaf of the thinning, or
   * more. */
  void setGridSize(double size) { parameters_.cell_size = size; }

  double getGridSize() const { return parameters_.cell_size; }

  /** @brief Beyond the paper: necks narrower than 2 radius + 1 cells do not join
   * regions (default 0: off). The regions are those of the cells eroded by so many,
   * grown back. */
  void setOpeningRadius(int cells) { parameters_.opening_radius = cells; }

  int getOpeningRadius() const { return parameters_.opening_radius; }

  /** @brief Of what an opening parts, pieces under so many cells go back to a larger
   * one that they touch (default 400, one square metre). Without an opening of no
   * effect. */
  void setMinimumPart(std::size_t cells) { parameters_.minimum_part = cells; }

  std::size_t getMinimumPart() const { return parameters_.minimum_part; }

  /** @brief Beyond the paper: points of the input cloud, say the floor, that speak for
   * a region: one below the threshold is kept too if enough of its cells have such a
   * point within a cell. Null: off (default). */
  void setSupportIndices(const sedr::StageIndices& support)
  {
    support_ = support.get();
  }

  IndicesConstPtr getSupportIndices() const { return support_; }

  /** @brief Share of a region's cells that must be supported, 0 to 1 (default 0.5). */
  void setMinimumSupport(double share) { parameters_.minimum_support = share; }

  double getMinimumSupport() const { return parameters_.minimum_support; }

  /** @brief Cells that a region must have to be kept for its support (default 400, one
   * square metre). */
  void setMinimumSupportedCells(std::size_t cells)
  {
    parameters_.minimum_supported_cells = cells;
  }

  std::size_t getMinimumSupportedCells() const
  {
    return parameters_.minimum_supported_cells;
  }

  /** @brief Writes the points kept to `output`, which may be the input. */
  void filter(PointCloud& output);

  /** @brief Writes the indices of the points kept to `indices`, in the order they were
   * given. */
  void filter(Indices& indices);

  /** @brief Of each point of the input cloud its region after the last run: 1 .. n the
   * kept ones by decreasing size, 0 for all other points. */
  const std::vector<int>& getRegionLabels() const { return region_labels_; }

  /** @brief Sizes of all regions of the last run, kept or not: cells, decreasing. */
  const std::vector<std::size_t>& getRegionSizes() const
  {
    return region_map_.regions.sizes;
  }

  /** @brief The adaptive threshold of the last run, in cells: larger regions were kept.
   */
  std::size_t getThreshold() const { return region_map_.threshold; }

  /** @brief How many regions the last run kept. */
  std::size_t getNumberOfRegions() const { return number_of_regions_; }

  /** @brief The cells of the last run, their regions, and which of these were kept: the
   * paper's binary and region maps. Empty after a failure. */
  const sedr::RegionMap& getRegionMap() const { return region_map_; }

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

  sedr::RegionParameters parameters_;
  IndicesConstPtr support_;

  std::vector<int> region_labels_;
  sedr::RegionMap region_map_;
  std::size_t number_of_regions_ = 0;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_filters/impl/grid_region_outlier_removal.hpp>
#endif
