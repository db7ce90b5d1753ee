// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_mask.h>
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>

#include <cstddef>
#include <limits>
#include <string>
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
  double widest_niche = 1.6;    ///< a narrower straight opening to a lower head is a
                                ///< door's or a window's
  double minimum_island_area = 0.5; ///< square metres; what hangs free of the walls and
                                    ///< is smaller is a lamp or a vent
  unsigned threads = 0;             ///< 0: as many as there are processors
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

/** @brief Grid-slices analysis (paper, section 2.3.1).
 *
 * Slices of the points at a quarter and a half, then at an eighth and three eighths of
 * the room's height below the ceiling are laid over the ceiling's cells; empty cells
 * that ceiling and slice enclose together, and the ceiling alone does not, are
 * structural detail if points are seen there between slice and ceiling. Beyond the
 * paper, what those points are is looked at: regions of undersides of one height, above
 * half the room's height, that join the ceiling, have floor below and are not the head
 * of a door or window are detail, whether or not an opening breaks the slice's outline;
 * empty cells that a slice encloses with them belong to them. Nothing farther than 5 m
 * beyond the ceiling's bounding box is looked at.
 *
 * @param points the scan
 * @param indices the points of the room
 * @param ceiling those of its main ceiling
 * @param slab the plane of the ceiling
 * @param floor_height z of the floor
 * @param[out] problem why nothing could be done, a sentence; empty otherwise
 * O(n log n) in the points plus the cells of their bounding box. */
SliceDetails findSliceDetails(const PointView& points,
                              const std::vector<int>& indices,
                              const std::vector<int>& ceiling,
                              const PlanSlab& slab,
                              double floor_height,
                              const SliceParameters& parameters,
                              std::string& problem);

} // namespace sedr
} // namespace pcl
