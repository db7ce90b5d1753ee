// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cell_mask.h"
#include <pcl/sedr_filters/cell_grid.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Lists of numbers by cell, to look up in O(1) what may be near a place. */
class CellTable {
public:
  /** @brief A number and the rectangle of cells that list it. */
  struct Entry {
    CellBox box;
    std::uint32_t number;
  };

  /** @brief The numbers near a place, increasing and unique. */
  struct Numbers {
    const std::uint32_t* first = nullptr;
    const std::uint32_t* last = nullptr;

    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return last; }
  };

  explicit CellTable(double cell_size)
      : grid_(cell_size)
  {}

  /** @brief Returns the cells of the rectangle from `low` to `high`; empty if these are
   * too far away for a grid. */
  CellBox boxAround(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const;

  /** @brief Fills the table with entries of increasing numbers.
   * @return why it cannot be filled, as a sentence; empty otherwise */
  std::string fill(const std::vector<Entry>& entries);

  const CellGrid& grid() const { return grid_; }

  /** @brief Returns the cells that may have numbers. */
  const CellBox& box() const { return frame_.box(); }

  Numbers at(const Eigen::Vector2d& p) const
  {
    return grid_.holds(p.x(), p.y()) ? ofCell(grid_.at(p.x(), p.y())) : Numbers();
  }

  /** @brief Returns the numbers of a cell of grid(). */
  Numbers ofCell(Cell cell) const
  {
    if (!frame_.isInside(cell))
      return {};
    const std::size_t i = frame_.indexOf(cell);
    return {numbers_.data() + first_[i], numbers_.data() + last_[i]};
  }

private:
  CellGrid grid_;
  CellMask frame_; ///< gives the index of each cell
  std::vector<std::size_t> first_;
  std::vector<std::size_t> last_;
  std::vector<std::uint32_t> numbers_;
};

} // namespace pcl::sedr
