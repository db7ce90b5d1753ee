// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/cell_mask.h"
#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief A candidate point of a level. It holds its coordinates because neighbours in
 * a profile are far apart in the cloud. */
struct Candidate {
  int index;
  std::uint32_t cell; ///< position of its cell in the set of all cells
  float x;
  float y;
  float z;

  Eigen::Vector3f position() const { return {x, y, z}; }
};

/** @brief The points of a scan, sorted into profiles and by height, for the detection
 * of levels and inliers. Points not finite or beyond the grid are left out. O(n log n);
 * the result does not depend on the number of threads. */
class LevelColumns {
public:
  /** @param points    must outlive this
   * @param cell_size of the grid, metres
   * @param tolerance distance of an inlier from its plane, metres
   * @param threads 0: all processors */
  LevelColumns(const PointView& points,
               const std::vector<int>& indices,
               double cell_size,
               double tolerance,
               unsigned threads = 0);

  const PointView& points() const { return points_; }
  const CellGrid& grid() const { return grid_; }

  /** @brief Returns the number of threads to use; 0: all processors. */
  unsigned threads() const { return threads_; }

  /** @brief Returns the occupied cells. */
  const CellSet& cells() const { return cells_; }

  /** @brief Returns the bounding rectangle of the occupied cells. */
  const CellBox& box() const { return box_; }

  /** @brief Returns all points, sorted by cell and height. */
  const std::vector<Candidate>& all() const { return all_; }

  /** @brief Returns the heights of all(), contiguous, as most searches read only these.
   */
  const std::vector<float>& heights() const { return heights_; }

  /** @brief Returns the begin and end of a cell's points in all(). */
  std::size_t first(std::size_t cell) const { return first_[cell]; }
  std::size_t last(std::size_t cell) const { return first_[cell + 1]; }

  /** @brief Returns the points not on vertical surfaces, sorted by height. Points are
   * left out if others lie one to three tolerances both above and below, in the 3 x 3
   * profiles around them. Noise spreads a wall over several profiles, and the outer
   * ones alone have too few points. A ceiling has nothing above it, a floor nothing
   * below, and a soffit hides the wall above. */
  const std::vector<Candidate>& withoutWalls() const { return without_walls_; }

private:
  void sortIntoColumns(const std::vector<int>& indices);
  void leaveOutWalls(double tolerance);

  PointView points_;
  CellGrid grid_;
  unsigned threads_;
  CellSet cells_;
  CellBox box_;
  std::vector<Candidate> all_;
  std::vector<float> heights_;
  std::vector<std::size_t> first_; ///< first point of each cell, and the end
  std::vector<Candidate> without_walls_;
};

} // namespace pcl::sedr
