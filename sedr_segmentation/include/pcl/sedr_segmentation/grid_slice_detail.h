// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_filters/stage_error.h>

#include <pcl/PointIndices.h>
#include <pcl/pcl_base.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief How structural details are looked for; lengths in metres. */
struct SliceParameters {
  double cell_size = 0.05; ///< cell of the grid (paper, Table 1)
  double tolerance = 0.07; ///< distance within which a point belongs to the ceiling
  std::size_t minimum_cells = 20; ///< smallest detail region (paper, Table 1)
  int trials = 3;               ///< 1/4; then 1/2; then 1/8 and 3/8 of the room height
  double slice_thickness = 0.1; ///< of the slab of points that a slice is
  double widest_niche =
      Priors().max_door_width; ///< a narrower straight opening to a lower head is a
                               ///< door's or a window's
  double minimum_island_area = 0.5; ///< square metres; what hangs free of the walls and
                                    ///< is smaller is a lamp or a vent
  Priors priors;
  unsigned threads = 0; ///< 0: as many as there are processors
};

/** @brief What one trial saw (paper, Figure 4b). */
struct SliceTrial {
  int number = 0; ///< 1, 2 or 3
  std::vector<double>
      fractions;               ///< of the room's height below the ceiling, one a slice
  std::vector<double> heights; ///< z of the slices in the middle of the ceiling
  CellSet slice;               ///< cells of the slices, one more on each side
  CellSet enclosed;            ///< zero-valued cells that slices and ceiling enclose
  std::vector<CellSet> accepted; ///< of these the regions that may be detail
  std::vector<CellSet> rejected; ///< and those that are small, or where nothing is seen
};

/** @brief The structural details of one room's ceiling. */
struct SliceDetails {
  std::vector<int> indices;        ///< points of details, increasing
  std::vector<std::size_t> region; ///< region of each of them, 0 is the largest
  std::vector<std::size_t> sizes;  ///< of the regions in cells, decreasing
  CellSet cells;                   ///< cells of all regions
  double slice_height =
      std::numeric_limits<double>::quiet_NaN(); ///< z above which all of it lies
  int trial = 0; ///< the trial whose slice enclosed it, 0 if none did

  CellSet ceiling;                ///< cells of the main ceiling
  std::vector<SliceTrial> trials; ///< those that were made, the last one decided
  CellSet refused; ///< undersides that are no detail: lamps, heads of doors and windows
};

} // namespace sedr

/** @brief Finds structural details of a ceiling (soffits, beams, recesses) by
 * grid-slices analysis (paper, section 2.3.1): horizontal slices at a quarter and a
 * half, then at an eighth and three eighths of the room's height below the ceiling show
 * where walls stand; cells that slice and ceiling enclose together, and the ceiling
 * alone does not, may be detail. Beyond the paper, so are regions of undersides of one
 * height that join the ceiling, and heads of doors and windows are left out. Frame: z
 * up, metres.
 *
 * Works on one room: give its points by setIndices() and those of its main ceiling by
 * setCeilingIndices(). The planes of ceiling and floor are fitted to the indices unless
 * they are set. Non-finite points are never detail. O(n log n) plus the cells of the
 * room's bounding box.
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

  /** @brief Points of the main ceiling. Needed. */
  void setCeilingIndices(const sedr::StageIndices& ceiling)
  {
    ceiling_ = ceiling.get();
  }
  IndicesConstPtr getCeilingIndices() const { return ceiling_; }

  /** @brief Points of the floor; their mean height is the room's lower end. Needed
   * unless setFloorHeight() is given. */
  void setFloorIndices(const sedr::StageIndices& floor) { floor_ = floor.get(); }
  IndicesConstPtr getFloorIndices() const { return floor_; }

  /** @brief Height of the floor, metres; NaN (default): that of the floor points. */
  void setFloorHeight(double height) { floor_height_ = height; }
  double getFloorHeight() const { return floor_height_; }

  /** @brief Edge of a grid cell, metres, > 0. Default 0.05. */
  void setGridSize(double size) { parameters_.cell_size = size; }
  double getGridSize() const { return parameters_.cell_size; }

  /** @brief Distance within which a point belongs to the ceiling, metres, > 0. Default
   * 0.07. */
  void setDistanceThreshold(double threshold) { parameters_.tolerance = threshold; }
  double getDistanceThreshold() const { return parameters_.tolerance; }

  /** @brief Fewest cells of a detail. Default 20 (paper, Table 1). */
  void setMinimumCells(std::size_t cells) { parameters_.minimum_cells = cells; }
  std::size_t getMinimumCells() const { return parameters_.minimum_cells; }

  /** @brief Number of trials, 1 to 3: a quarter; a half; an eighth and three eighths.
   * Default 3. */
  void setTrials(int trials) { parameters_.trials = trials; }
  int getTrials() const { return parameters_.trials; }

  /** @brief Thickness of a slice, metres, > 0. Default 0.1. */
  void setSliceThickness(double thickness) { parameters_.slice_thickness = thickness; }
  double getSliceThickness() const { return parameters_.slice_thickness; }

  /** @brief What is enclosed by the ceiling all around and smaller is a lamp or a vent,
   * square metres, >= 0. Default 0.5. */
  void setMinimumIslandArea(double area) { parameters_.minimum_island_area = area; }
  double getMinimumIslandArea() const { return parameters_.minimum_island_area; }

  /** @brief What is believed of buildings; the widest door with them. */
  void setPriors(const sedr::Priors& priors)
  {
    parameters_.priors = priors;
    parameters_.widest_niche = priors.max_door_width;
  }
  const sedr::Priors& getPriors() const { return parameters_.priors; }

  /** @brief Number of threads; 0 (default): all processors. Never changes the result.
   */
  void setNumberOfThreads(unsigned threads) { parameters_.threads = threads; }
  unsigned getNumberOfThreads() const { return parameters_.threads; }

  /** @brief Seed of the random samples of the ceiling's plane. Default 1. */
  void setSeed(std::uint64_t seed) { seed_ = seed; }
  std::uint64_t getSeed() const { return seed_; }

  /** @brief Finds the points of the details.
   * @param[out] details increasing indices; empty where the ceiling has no details
   * @return false, with a reason in getErrorMessage(), for bad input or parameters */
  bool segment(PointIndices& details);

  /** @brief Region of every index that segment() gave, 0 is the largest. */
  const std::vector<std::size_t>& getRegionLabels() const { return result_.region; }

  /** @brief Sizes of the regions in cells, decreasing. */
  const std::vector<std::size_t>& getRegionSizes() const { return result_.sizes; }

  /** @brief Height above which all details lie and below which walls go to the outer
   * outline, metres; NaN where there are none. */
  double getSliceHeight() const { return result_.slice_height; }

  /** @brief The trial whose slice enclosed a detail, 1 to 3; 0 if none did, as where an
   * opening breaks the outline of every slice. */
  int getTrial() const { return result_.trial; }

  /** @brief All that the last run looked at: the ceiling's cells, what each trial saw
   * and took, the cells of the details and what was refused. */
  const sedr::SliceDetails& getAnalysis() const { return result_; }

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
