// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "direction_sectors.h"

#include "sedr_filters/src/grids/cell_mask.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief The points of a slab by cell: tells of nearly each whether its nearest
 * neighbours leave a wide gap, without a search tree.
 *
 * All points within a few cells of one are known. As more neighbours never widen a gap,
 * there is none where those of fewer points than are asked about leave none, and there
 * is one where those of more leave one. Else the nearest are taken out of them, unless
 * which ones are depends on the order of points equally far. O(n); a look is O(points
 * within a few cells). */
class NeighbourCells {
public:
  /** @brief Points around one, kept from one look to the next. */
  struct Around {
    struct Point {
      float square; ///< of its distance
      float x;      ///< way to it
      float y;
    };
    std::vector<Point> points;
    std::vector<float> directions;
  };

  /** @param places     of all points; z is 0 where only the plane counts
   * @param neighbours nearest points that count, the point itself among them
   * @param angle      widest gap of an inner point, radians
   * @param threads    that share the work of filling it, 0: all processors */
  NeighbourCells(const std::vector<Eigen::Vector3f>& places,
                 std::size_t neighbours,
                 float angle,
                 unsigned threads);

  /** @brief Whether the nearest neighbours of a place, one of those given, leave a gap
   * wider than the angle. */
  Gap gapAt(const Eigen::Vector3f& place, Around& around) const;

private:
  /** @brief Points within some cells of a place. */
  struct Ball {
    std::uint64_t seen = 0; ///< their sectors
    std::size_t count = 0;
  };

  double cellSizeFor(const std::vector<Eigen::Vector3f>& places,
                     unsigned threads) const;
  bool isInner(const Eigen::Vector3f& place, int farthest) const;
  std::size_t countAround(const Eigen::Vector3f& place, int reach) const;
  Ball ballAround(const Eigen::Vector3f& place, int reach, Around& around) const;
  Gap gapOfNearest(Around& around) const;

  /** @brief Calls `see(first, last)` for the points of each row of cells around a
   * place, nearer rows first. */
  template <typename See>
  void forEachRow(const Eigen::Vector3f& place, int reach, See see) const;

  std::size_t neighbours_;
  float angle_;
  DirectionSectors sectors_;
  CellGrid grid_;
  CellMask frame_;                      ///< numbers the cells
  std::vector<std::uint32_t> first_;    ///< of the points of each cell, and the end
  std::vector<Eigen::Vector3f> places_; ///< by cell
};

} // namespace pcl::sedr
