// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cell_set.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the number of cells of a length, rounded, at least `least`. Lengths
 * in metres thus hold for any cell size. */
inline int
cellsFor(double metres, double cell_size, int least = 1)
{
  return std::max(least, static_cast<int>(std::lround(metres / cell_size)));
}

/** @brief A rectangle of cells. */
struct CellBox {
  Cell low;
  Cell high; ///< inclusive

  /** @brief Returns the number of cells, 0 for an empty box. */
  std::uint64_t count() const;
};

CellBox boxOf(const CellSet& cells);

/** @brief Returns `box` enlarged by `margin` cells on each side. */
CellBox grown(const CellBox& box, int margin);

/** @brief Returns the intersection of two boxes; empty if they do not overlap. */
CellBox overlapOf(const CellBox& a, const CellBox& b);

/** @brief Returns the smallest box around both. */
CellBox around(const CellBox& a, const CellBox& b);

/** @brief The maximum number of cells of a mask: a region of 579 m by 579 m at 5 cm.
 * Algorithms on masks (distances, labels, fronts) take 20 bytes a cell and more, so
 * memory stays within a few GiB. */
constexpr std::uint64_t max_mask_cells = std::uint64_t{1} << 27;

/** @brief Returns a sentence why a mask of this box is impossible, else empty. */
std::string maskProblem(const CellBox& box);

/** @brief A bounded part of the grid with one byte a cell; cells outside are 0. */
class CellMask {
public:
  CellMask() = default;

  /** @brief Sets all cells to 0. maskProblem(box) must be empty. */
  explicit CellMask(const CellBox& box);

  /** @brief Sets the cells of `cells` within `box` to 1, the others to 0. */
  CellMask(const CellSet& cells, const CellBox& box);

  const CellBox& box() const { return box_; }

  int width() const { return width_; }

  int height() const { return height_; }

  bool isInside(Cell cell) const
  {
    return cell.x >= box_.low.x && cell.x <= box_.high.x && cell.y >= box_.low.y &&
           cell.y <= box_.high.y;
  }

  std::uint8_t at(Cell cell) const
  {
    return isInside(cell) ? values_[indexOf(cell)] : 0;
  }

  /** @brief Sets a cell of the box. */
  void set(Cell cell, std::uint8_t value) { values_[indexOf(cell)] = value; }

  std::size_t indexOf(Cell cell) const
  {
    return static_cast<std::size_t>(cell.y - box_.low.y) *
               static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(cell.x - box_.low.x);
  }

  Cell cellAt(std::size_t index) const
  {
    return {box_.low.x +
                static_cast<std::int32_t>(index % static_cast<std::size_t>(width_)),
            box_.low.y +
                static_cast<std::int32_t>(index / static_cast<std::size_t>(width_))};
  }

  std::vector<std::uint8_t>& values() { return values_; }
  const std::vector<std::uint8_t>& values() const { return values_; }

  /** @brief Returns the number of cells that are not 0. */
  std::size_t count() const;

  CellSet toSet() const;

private:
  CellBox box_{{0, 0}, {-1, -1}};
  int width_ = 0;
  int height_ = 0;
  std::vector<std::uint8_t> values_;
};

/** @brief Returns the cells of the box within `radius` cells of a set cell (Euclidean).
 * O(cells). */
CellMask dilated(const CellMask& mask, double radius);

/** @brief Returns the cells of the mask farther than `radius` cells from every cell
 * that is not set. Cells outside the box count as not set. O(cells). */
CellMask eroded(const CellMask& mask, double radius);

/** @brief Returns the complement within the box. */
CellMask inverted(const CellMask& mask);

/** @brief Returns the squared distance, in cells, of each cell of the box from the
 * nearest set cell (Felzenszwalb and Huttenlocher 2012); infinity if no cell is set.
 * Exact up to 4096 cells, whose square fits the digits of a float; rounded beyond.
 * O(cells). */
std::vector<float> squaredDistances(const CellMask& mask);

/** @brief The connected regions of a mask. */
struct MaskRegions {
  std::vector<std::int32_t> label; ///< region of each cell of the box; -1 if not set
  std::vector<std::size_t> sizes;  ///< cells, in the order of the first cells
};

/** @brief Labels the regions of the set cells, four- or eight-connected. O(cells). */
MaskRegions labelRegions(const CellMask& mask, bool eight_connected);

/** @brief Returns the cells of region `region` as a mask of the same box. */
CellMask
regionMask(const CellMask& mask, const MaskRegions& regions, std::int32_t region);

/** @brief Returns the holes of the mask: unset cells without a four-connected path of
 * unset cells to the edge of the box. O(cells). */
CellMask enclosedCells(const CellMask& mask);

/** @brief Returns the union of `a` and `b`, in the box of `a`; boxes may differ. */
CellMask unite(const CellMask& a, const CellMask& b);

/** @brief Adds the cells of a mask that are in the box of `sum`. O(cells of both boxes'
 * overlap). */
void addCells(const CellMask& mask, CellMask& sum);

/** @brief Returns `a` without `b`, in the box of `a`; boxes may differ. */
CellMask subtract(const CellMask& a, const CellMask& b);

/** @brief Returns what `a` and `b` share, in the box of `a`; boxes may differ. */
CellMask intersect(const CellMask& a, const CellMask& b);

/** @brief Returns the cells of `mask` within another box. */
CellMask cropped(const CellMask& mask, const CellBox& box);

} // namespace pcl::sedr
