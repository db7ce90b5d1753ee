// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/point_view.h>

#include <array>
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

/** @brief The points with their cells, sorted by cell and height. O(n log n). */
std::vector<Candidate> sortIntoColumns(const PointView& points,
                                       const std::vector<int>& indices,
                                       const CellGrid& grid,
                                       const CellSet& cells);

/** @brief Positions of up to nine cells. */
class CellBlock {
public:
  void add(std::size_t cell) { cells_[size_++] = cell; }

  const std::size_t* begin() const { return cells_.data(); }
  const std::size_t* end() const { return cells_.data() + size_; }

private:
  std::array<std::size_t, 9> cells_{};
  std::size_t size_ = 0;
};

/** @brief Positions of a cell and of the eight around it, those that are in the set. */
CellBlock blockAround(const CellSet& cells, std::size_t at);

/** @brief Leaves out the points of vertical surfaces, and sorts the others by height:
 * those that see others both above and below, between one and three tolerances away, in
 * their own column or one of the eight around it. Noise spreads a wall over several
 * columns, of which the outer ones alone hold too few points to tell. A ceiling has
 * nothing above it, a floor nothing below, and a soffit hides the wall that it meets.
 * O(n log n).
 * @param columns as sortIntoColumns() gives them
 * @param cells   the set that their cells are positions in */
std::vector<Candidate> withoutWalls(const std::vector<Candidate>& columns,
                                    const CellSet& cells,
                                    double tolerance);

/** @brief Marks the columns of walls: those that go on beyond a plane, with points one
 * and a half to four tolerances above it where `direction` is 1, below it where it is
 * -1, and right beside it, up to 2.25 tolerances, in a block of three by three; below a
 * ceiling in the gap that gapBelow() gives, too: a tall cupboard ends before. O(n log
 * n). */
std::vector<std::uint8_t> columnsThatGoOn(const std::vector<Candidate>& columns,
                                          const CellSet& cells,
                                          const PlanSlab& slab,
                                          double direction,
                                          double tolerance);

} // namespace sedr
} // namespace pcl
