// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/cell_mask.h"
#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A point on its way to a level: with its coordinates, as those of neighbours
 * in a column are far apart in the cloud. */
struct Candidate {
  int index;
  std::uint32_t cell; ///< position of its cell in the set of all cells
  float x;
  float y;
  float z;

  Eigen::Vector3f position() const { return {x, y, z}; }
};

/** @brief The points of a scan by grid column and by height: what the levels of a scan
 * are looked for in, what mirrors, and what is whose, made once for all of them. Points
 * that are not finite or too far away for cells are left out. O(n log n); the same for
 * any number of threads. */
class LevelColumns {
public:
  /** @param points    must outlive this
   * @param cell_size of the grid, metres
   * @param tolerance distance of an inlier from its plane, metres
   * @param threads   0: as many as there are processors */
  LevelColumns(const PointView& points,
               const std::vector<int>& indices,
               double cell_size,
               double tolerance,
               unsigned threads = 0);

  const PointView& points() const { return points_; }
  const CellGrid& grid() const { return grid_; }

  /** @brief How many threads may go through them side by side; 0: as many as there are
   * processors. */
  unsigned threads() const { return threads_; }

  /** @brief Cells with a point in them. */
  const CellSet& cells() const { return cells_; }

  /** @brief The smallest rectangle around them. */
  const CellBox& box() const { return box_; }

  /** @brief All points, sorted by cell and height. */
  const std::vector<Candidate>& all() const { return all_; }

  /** @brief Their heights alone, side by side: of most columns no more is looked at. */
  const std::vector<float>& heights() const { return heights_; }

  /** @brief Where the points of a cell of cells() begin in all(), and end. */
  std::size_t first(std::size_t cell) const { return first_[cell]; }
  std::size_t last(std::size_t cell) const { return first_[cell + 1]; }

  /** @brief Those that are not of vertical surfaces, sorted by height. Left out are
   * those that see others both above and below, between one and three tolerances away,
   * in their own column or one of the eight around it. Noise spreads a wall over
   * several columns, of which the outer ones alone hold too few points to tell. A
   * ceiling has nothing above it, a floor nothing below, and a soffit hides the wall
   * that it meets. */
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
  std::vector<std::size_t> first_; ///< of the points of each cell, and the end
  std::vector<Candidate> without_walls_;
};

} // namespace sedr
} // namespace pcl
