// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../shapes/shape_fit.h"
#include "sheet_grid.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl::sedr {

/** @brief Connected cells of a set, eight neighbours each. */
std::vector<std::vector<std::size_t>> piecesOf(const SheetGrid& grid,
                                               const std::vector<std::uint8_t>& is_in);

/** @brief The cells of each label in parts that hang together by sides. O(n). */
std::vector<std::vector<std::size_t>> piecesOf(const SheetGrid& grid,
                                               const std::vector<std::int32_t>& label);

/** @brief Gives cells whose label is below 0 that of the nearest one with, by steps. */
void fillNearest(const SheetGrid& grid, std::vector<std::int32_t>& label);

/** @brief At which heights points were seen in and beside each cell of a grid: which
 * share of a step a vertical face closes. 64 bins, at least a voxel high. */
class RiserBins {
public:
  static constexpr double min_step = 0.1; ///< metres: lower steps have no bin of
                                          ///< their own
  static constexpr double margin = 0.03;  ///< metres: noise of the surfaces
  static constexpr int to_wall = 2;       ///< cells beside which points may be a wall's

  /** @param domain cells of the room: points in those at its rim are of walls, and no
   * riser's within it
   * @param points of all that was seen in and near the room; those below `low` or
   * above `high` are left out. O(n). */
  RiserBins(const SheetGrid& grid,
            const std::vector<std::uint8_t>& domain,
            const std::vector<Eigen::Vector3d>& points,
            double low,
            double high);

  /** @brief Returns the share of the bins between two heights, without those of the
   * surfaces themselves, that hold points at the border of two cells; 0 if the step is
   * too low to tell. */
  double share(std::size_t cell, std::size_t next, double low, double high) const;

  /** @brief Checks whether a cell lies at the rim of the room. */
  bool isAtWall(std::size_t cell) const { return is_at_wall_[cell] != 0; }

  /** @brief Checks whether points were seen in a cell between two heights. */
  bool isSeen(std::size_t cell, double low, double high) const;

private:
  double bottom_ = 0;
  double bin_ = 0.05;               ///< metres
  std::vector<std::uint64_t> own_;  ///< of each cell, from the bottom up
  std::vector<std::uint64_t> seen_; ///< in and beside it, of no wall
  std::vector<std::uint8_t> is_at_wall_;
};

/** @brief A ball around the points of a cell. */
struct CellBall {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0;
};

/** @brief Whether the k-th of `size` is one of about `most` that are evenly chosen. */
inline bool
isChosen(std::uint64_t k, std::uint64_t size, std::uint64_t most)
{
  return size <= most || k * most / size != (k + 1) * most / size;
}

/** @brief The points of a sheet, cell by cell of its grid. */
class CellPoints {
public:
  /** @brief Points beside the cells of `domain` are left out, and those of a cell that
   * are more than `most`, evenly. O(n). */
  CellPoints(const SheetGrid& grid,
             const std::vector<std::uint8_t>& domain,
             const std::vector<Eigen::Vector3d>& points,
             std::size_t most = std::numeric_limits<std::uint32_t>::max());

  const SheetGrid& grid() const { return grid_; }
  std::size_t size() const { return points_.size(); }
  double lowest() const { return lowest_; } ///< z of all points
  double highest() const { return highest_; }
  bool isEmpty(std::size_t cell) const { return first_[cell] == first_[cell + 1]; }
  bool isInside(std::size_t cell) const { return domain_[cell] != 0; }

  const Eigen::Vector3d* begin(std::size_t cell) const
  {
    return points_.data() + first_[cell];
  }
  const Eigen::Vector3d* end(std::size_t cell) const
  {
    return points_.data() + first_[cell + 1];
  }

  /** @brief Number of the first point of a cell among all of them, which are sorted by
   * cell; of the number of cells: how many points there are. */
  std::size_t first(std::size_t cell) const { return first_[cell]; }

  /** @brief All points, row_size in a row. */
  const std::vector<PointRow>& rows() const { return rows_; }

  const CellBall& ball(std::size_t cell) const { return balls_[cell]; }

  /** @brief The cells with points, increasing, and the middles of their balls. */
  const std::vector<std::size_t>& seen() const { return seen_; }
  const std::vector<PointRow>& middles() const { return middles_; }

  /** @brief The points of some cells, no more than about `most`, evenly chosen. */
  std::vector<Eigen::Vector3d> pointsOf(const std::vector<std::size_t>& cells,
                                        std::size_t most) const;

  /** @brief Cells with points, at most `reach` cells from one. */
  std::vector<std::size_t> window(std::size_t cell, int reach) const;

  /** @brief Standard deviation of the points about smooth patches of 3 x 3 cells, of
   * which a third have less, metres, at least 0.1 mm. */
  double noise() const;

private:
  const SheetGrid& grid_;
  const std::vector<std::uint8_t>& domain_;
  std::vector<std::size_t> first_;
  std::vector<Eigen::Vector3d> points_;
  double lowest_ = std::numeric_limits<double>::infinity();
  double highest_ = -std::numeric_limits<double>::infinity();
  std::vector<CellBall> balls_;
  std::vector<std::size_t> seen_;
  std::vector<PointRow> middles_;
  std::vector<PointRow> rows_;
};

} // namespace pcl::sedr
