// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cell_mask.h"
#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Finds in O(1) which of many numbered objects may be at a place in plan. If
 * they lie too far apart for a table, that is all of them. */
class PlaceTable {
public:
  /** @brief The objects that may be at a place, increasing and unique. */
  using Numbers = std::vector<std::uint32_t>;

  /** @param cell_size metres; about the size of most objects */
  explicit PlaceTable(double cell_size)
      : grid_(cell_size)
  {}

  /** @brief Adds an object within a box; the numbers must not decrease. */
  void addIn(const Eigen::AlignedBox2d& box, std::uint32_t number);

  /** @brief Adds an object that lies within `reach` metres of an element. */
  void addAlong(const PlanElement& element, double reach, std::uint32_t number);

  /** @brief Completes the table after the last addition; required before at().
   * @return why there is no table, as a sentence; empty otherwise */
  std::string finish();

  const Numbers& at(const Eigen::Vector2d& p) const
  {
    if (!grid_.holds(p.x(), p.y()) || !frame_.isInside(grid_.at(p.x(), p.y())))
      return all_;
    return numbers_[frame_.indexOf(grid_.at(p.x(), p.y()))];
  }

private:
  /** @brief A number and the cells that list it. */
  struct Entry {
    CellBox box;
    std::uint32_t number;
  };

  CellGrid grid_;
  std::vector<Entry> entries_;
  CellMask frame_;               ///< gives the index of each cell
  std::vector<Numbers> numbers_; ///< of each cell
  Numbers all_;                  ///< all numbers, if there is no table
};

} // namespace pcl::sedr
