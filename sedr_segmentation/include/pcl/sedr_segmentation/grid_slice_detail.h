// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/impl/stage_error.h>
#include <pcl/sedr_filters/priors.h>

#include <pcl/PointIndices.h>
#include <pcl/pcl_base.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Parameters of the detection of structural details; lengths in metres. */
struct SliceParameters {
  double cell_size = 0.05; ///< edge of a grid cell (paper, Table 1)
  double tolerance =
      0.07; ///< maximum distance of a ceiling point from the ceiling's plane
  std::size_t minimum_cells = 20; ///< of a detail region (paper, Table 1)
  int trials = 3;               ///< 1/4; then 1/2; then 1/8 and 3/8 of the room height
  double slice_thickness = 0.1; ///< of a slice
  Priors priors;
  unsigned threads = 0; ///< 0: all processors
};

/** @brief The structural details of one room's ceiling. */
struct SliceDetails {
  std::vector<int> indices;        ///< of the points of details, increasing
  std::vector<std::size_t> region; ///< region of each index, 0 is the largest
  std::vector<std::size_t> sizes;  ///< of the regions in cells, decreasing
  double slice_height =
      std::numeric_limits<double>::quiet_NaN(); ///< z above which all details lie
  int trial = 0; ///< trial whose slice encloses a detail, 0 if none does
};

} // namespace sedr

/** @brief Finds structural details of a ceiling (soffits, beams, recesses) by
 * grid-slices analysis (paper, section 2.3.1). Frame: z up, metres.
 *
 * Horizontal slices at 1/4 and 1/2, then at 1/8 and 3/8 of the room height below the
 * ceiling show the walls. Cells that slice and ceiling enclose together, but not the
 * ceiling alone, are detail if points lie between slice and ceiling. The class
 * processes one room: setIndices() gives its points, setCeilingIndices() those of its
 * main ceiling. The planes of ceiling and floor are fitted to the indices. Non-finite
 * points are never detail. O(n log n) plus the cells of the bounding box.
 * @code
 * pcl::GridSliceDetail<pcl::PointXYZ> analysis;
 * analysis.setInputCloud(thinned);
 * analysis.setCeilingIndices(ceiling);
 * analysis.setFloorIndices(floor);
 * pcl::PointIndices details;
 * analysis.segment(details);
 * @endcode */
template <typename PointT>
class GridSliceDetail : public PCLBase<PointT>, public sedr::StageError {
public:
  using Ptr = shared_ptr<GridSliceDetail<PointT>>;
  using ConstPtr = shared_ptr<const GridSliceDetail<PointT>>;

  /** @brief Sets the points of the main ceiling. Required. */
  void setCeilingIndices(const sedr::StageIndices& ceiling)
  {
    ceiling_ = ceiling.get();
  }
  IndicesConstPtr getCeilingIndices() const { return ceiling_; }

  /** @brief Sets the points of the floor; their mean height is the room's lower end.
   * Required unless setFloorHeight() is called. */
  void setFloorIndices(const sedr::StageIndices& floor) { floor_ = floor.get(); }
  IndicesConstPtr getFloorIndices() const { return floor_; }

  /** @brief Sets the floor height, metres; NaN (default): that of the floor points. */
  void setFloorHeight(double height) { floor_height_ = height; }
  double getFloorHeight() const { return floor_height_; }

  /** @brief Sets the edge of a grid cell, metres, > 0. Default 0.05. */
  void setGridSize(double size) { parameters_.cell_size = size; }
  double getGridSize() const { return parameters_.cell_size; }

  /** @brief Sets the maximum distance of a ceiling point from the ceiling's plane,
   * metres, > 0. Default 0.07. */
  void setDistanceThreshold(double threshold) { parameters_.tolerance = threshold; }
  double getDistanceThreshold() const { return parameters_.tolerance; }

  /** @brief Sets the minimum number of cells of a detail. Default 20 (paper, Table 1).
   */
  void setMinimumCells(std::size_t cells) { parameters_.minimum_cells = cells; }
  std::size_t getMinimumCells() const { return parameters_.minimum_cells; }

  /** @brief Sets the number of trials, 1 to 3 (1/4; 1/2; 1/8 and 3/8). Default 3. */
  void setTrials(int trials) { parameters_.trials = trials; }
  int getTrials() const { return parameters_.trials; }

  /** @brief Sets the thickness of a slice, metres, > 0. Default 0.1. */
  void setSliceThickness(double thickness) { parameters_.slice_thickness = thickness; }
  double getSliceThickness() const { return parameters_.slice_thickness; }

  /** @brief Sets the priors about buildings. */
  void setPriors(const sedr::Priors& priors) { parameters_.priors = priors; }
  const sedr::Priors& getPriors() const { return parameters_.priors; }

  /** @brief Sets the number of threads; 0 (default): all processors. The result does
   * not depend on it. */
  void setNumberOfThreads(unsigned threads) { parameters_.threads = threads; }
  unsigned getNumberOfThreads() const { return parameters_.threads; }

  /** @brief Sets the seed of the random samples of the ceiling's plane. Default 1. */
  void setSeed(std::uint64_t seed) { seed_ = seed; }
  std::uint64_t getSeed() const { return seed_; }

  /** @brief Finds the points of the details.
   * @param[out] details increasing indices; empty if the ceiling has no details
   * @return false, with a reason in getErrorMessage(), for bad input or parameters */
  bool segment(PointIndices& details);

  /** @brief Returns the region of every index of segment(), 0 is the largest. */
  const std::vector<std::size_t>& getRegionLabels() const { return result_.region; }

  /** @brief Returns the sizes of the regions in cells, decreasing. */
  const std::vector<std::size_t>& getRegionSizes() const { return result_.sizes; }

  /** @brief Returns the height above which all details lie, metres; NaN if there are
   * none. Below it the walls follow the outer outline. */
  double getSliceHeight() const { return result_.slice_height; }

  /** @brief Returns the trial whose slice encloses a detail, 1 to 3; 0 if none does,
   * e.g. if an opening interrupts the outline of every slice. */
  int getTrial() const { return result_.trial; }

private:
  using PCLBase<PointT>::input_;
  using PCLBase<PointT>::indices_;

  IndicesConstPtr ceiling_;
  IndicesConstPtr floor_;
  double floor_height_ = std::numeric_limits<double>::quiet_NaN();
  std::uint64_t seed_ = 1;
  sedr::SliceParameters parameters_;
  sedr::SliceDetails result_;
};

} // namespace pcl

#ifdef PCL_NO_PRECOMPILE
#include <pcl/sedr_segmentation/impl/grid_slice_detail.hpp>
#endif
