// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cell_table.h"
#include <pcl/sedr_filters/floorplan.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Tells which of some numbered things in plan may be at a place, however many
 * there are. What is too far apart for a CellTable may be anywhere. */
class PlaceTable {
public:
  /** @param cell_size metres; about the size of most things */
  explicit PlaceTable(double cell_size)
      : table_(cell_size)
  {}

  /** @brief Adds what is in a box; the numbers must not decrease. */
  void addIn(const Eigen::AlignedBox2d& box, std::uint32_t number);

  /** @brief Adds what is within `reach` metres of an element. */
  void addAlong(const PlanElement& element, double reach, std::uint32_t number);

  /** @brief To be called after the last was added, before the first question. */
  void finish();

  /** @brief The numbers of what may be at a place, increasing, each once. */
  CellTable::Numbers at(const Eigen::Vector2d& p) const
  {
    return all_.empty() ? table_.at(p)
                        : CellTable::Numbers{all_.data(), all_.data() + all_.size()};
  }

private:
  CellTable table_;
  std::vector<CellTable::Entry> entries_;
  std::vector<std::uint32_t> all_; ///< numbers, where there is no table
};

} // namespace sedr
} // namespace pcl
