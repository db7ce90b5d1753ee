// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_grid.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Tells quickly, of most points that lie within a slab, that they do: without a
 * search for their nearest neighbours.
 *
 * The plane is divided into cells. Where all sectors around a point, each half as wide
 * as the gap asked about or less, hold points no farther than two cells in space, there
 * is no such gap; and where the block of five by five cells holds no more points than
 * there are to be neighbours, all of those are among them. */
class SurroundedPoints {
public:
  /** @param places     of all points; z is 0 where only the plane counts
   * @param cell_size  metres, above 0
   * @param neighbours nearest points that count, the point itself among them
   * @param angle      widest gap of an inner point, radians */
  SurroundedPoints(std::vector<Eigen::Vector3f> places,
                   double cell_size,
                   std::size_t neighbours,
                   float angle);

  /** @brief True: no gap among the nearest neighbours of point `i` is wider than the
   * angle. False: not known. */
  bool contains(std::size_t i) const;

private:
  std::vector<Eigen::Vector3f> places_;
  CellGrid grid_;
  CellSet cells_;
  std::vector<std::size_t> first_;   ///< of the points of each cell, and the end
  std::vector<std::uint32_t> order_; ///< points by cell
  std::size_t neighbours_;
  unsigned sectors_;
};

} // namespace sedr
} // namespace pcl
