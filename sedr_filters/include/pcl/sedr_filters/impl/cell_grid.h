// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pcl::sedr {

/** @brief A cell of a horizontal grid, given by its column (x) and row (y). */
struct Cell {
  std::int32_t x = 0;
  std::int32_t y = 0;

  friend bool operator==(Cell a, Cell b) { return a.x == b.x && a.y == b.y; }
};

/** @brief A cell as one number; keys sort row by row. */
using CellKey = std::uint64_t;

inline CellKey
keyOf(Cell cell)
{
  const auto lift = [](std::int32_t v) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(v) + 0x80000000LL);
  };
  return lift(cell.y) << 32 | lift(cell.x);
}

inline Cell
cellOf(CellKey key)
{
  const auto lower = [](std::uint64_t v) {
    return static_cast<std::int32_t>(static_cast<std::int64_t>(v) - 0x80000000LL);
  };
  return {lower(key & 0xffffffffu), lower(key >> 32)};
}

/** @brief A regular grid of square cells in the x-y plane (paper, section 2.3.1). One
 * corner lies at the origin, so grids of the same cell size coincide. */
class CellGrid {
public:
  /** @param size edge of a cell, metres, > 0; 0 for a grid that is not known */
  explicit CellGrid(double size)
      : size_(size)
  {}

  double size() const { return size_; }

  /** @brief Checks that (x, y) is finite and within the range of a 32-bit cell. */
  bool holds(double x, double y) const
  {
    constexpr double limit = std::numeric_limits<std::int32_t>::max() - 16.0;
    return std::abs(x / size_) < limit && std::abs(y / size_) < limit;
  }

  /** @brief Returns the cell of (x, y); holds() must be true (asserted). */
  Cell at(double x, double y) const
  {
    assert(holds(x, y));
    return {floorOf(x / size_), floorOf(y / size_)};
  }

  Eigen::Vector2d centre(Cell cell) const
  {
    return {(cell.x + 0.5) * size_, (cell.y + 0.5) * size_};
  }

private:
  /** @brief Computes std::floor() in the range of int32, without a call. */
  static std::int32_t floorOf(double value)
  {
    const auto whole = static_cast<std::int32_t>(value);
    return whole - (value < whole ? 1 : 0);
  }

  double size_;
};

} // namespace pcl::sedr
