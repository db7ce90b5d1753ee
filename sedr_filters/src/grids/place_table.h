// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cell_table.h"
#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief Finds which of many numbered objects may be at a place in plan. If they lie
 * too far apart for a CellTable, that is all of them. */
class PlaceTable {
public:
  /** @param cell_size metres; about the size of most objects */
  explicit PlaceTable(double cell_size)
      : table_(cell_size)
  {}

  /** @brief Adds an object within a box; the numbers must not decrease. */
  void addIn(const Eigen::AlignedBox2d& box, std::uint32_t number);

  /** @brief Adds an object that lies within `reach` metres of an element. */
  void addAlong(const PlanElement& element, double reach, std::uint32_t number);

  /** @brief Completes the table after the last addition; required before at(). */
  void finish();

  /** @brief Returns the objects that may be at a place, increasing and unique. */
  CellTable::Numbers at(const Eigen::Vector2d& p) const
  {
    return all_.empty() ? table_.at(p)
                        : CellTable::Numbers{all_.data(), all_.data() + all_.size()};
  }

private:
  CellTable table_;
  std::vector<CellTable::Entry> entries_;
  std::vector<std::uint32_t> all_; ///< all numbers, if there is no table
};

} // namespace pcl::sedr
