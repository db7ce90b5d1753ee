// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/cell_grid.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief A rectangle of cells. */
struct CellBox {
  Cell low;
  Cell high; ///< inclusive

  /** @brief Number of cells, 0 for an empty box. */
  std::uint64_t count() const;
};

CellBox boxOf(const CellSet& cells);

/** @brief `box` with `margin` more cells on each side. */
CellBox grown(const CellBox& box, int margin);

/** @brief The cells of both; empty where there are none. */
CellBox overlapOf(const CellBox& a, const CellBox& b);

/** @brief The smallest box around both. */
CellBox around(const CellBox& a, const CellBox& b);

/** @brief The most cells a mask may have: a region of 579 m by 579 m at 5 cm. What
 * works on masks (distances, labels, fronts) takes 20 bytes a cell and more: this keeps
 * it at a few GiB. */
constexpr std::uint64_t most_mask_cells = std::uint64_t{1} << 27;

/** @brief What is wrong with a mask of that box, a sentence; empty if nothing is. */
std::string maskProblem(const CellBox& box);

/** @brief A bounded part of the grid with one byte a cell; outside of the box every
 * cell is 0. */
class CellMask {
public:
  CellMask() = default;

  /** @brief All cells 0. maskProblem(box) must be empty. */
  explicit CellMask(const CellBox& box);

  /** @brief 1 for the cells of `cells` within `box`, else 0. */
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

  /** @brief Number of cells that are not 0. */
  std::size_t count() const;

  CellSet toSet() const;

private:
  CellBox box_{{0, 0}, {-1, -1}};
  int width_ = 0;
  int height_ = 0;
  std::vector<std::uint8_t> values_;
};

/** @brief Cells within `radius` cells (Euclidean) of a set cell; the box stays.
 * O(cells). */
CellMask dilated(const CellMask& mask, double radius);

/** @brief Cells of the mask farther than `radius` cells from every cell that is not
 * set; what lies outside of the box counts as not set. O(cells). */
CellMask eroded(const CellMask& mask, double radius);

/** @brief The complement within the box. */
CellMask inverted(const CellMask& mask);

/** @brief Squared distance, in cells, of each cell of the box from the nearest set cell
 * (Felzenszwalb and Huttenlocher 2012); infinity where nothing is set. Exact up to
 * distances of 4096 cells, whose square a float still holds; rounded to a float beyond.
 * O(cells). */
std::vector<float> squaredDistances(const CellMask& mask);

/** @brief Connected regions of a mask. */
struct MaskRegions {
  std::vector<std::int32_t>
      label; ///< of each cell of the box: -1 where not set, else from 0
  std::vector<std::size_t>
      sizes; ///< in cells, in the order in which regions are met row by row
  std::vector<std::uint8_t>
      touches_border; ///< whether the region reaches the edge of the box
};

/** @brief Regions of the set cells, four- or eight-connected. O(cells). */
MaskRegions labelRegions(const CellMask& mask, bool eight_connected);

/** @brief The cells of region `region`, 1 in a mask of the same box. */
CellMask
regionMask(const CellMask& mask, const MaskRegions& regions, std::int32_t region);

/** @brief The regions of `mask`, four- or eight-connected, of which a cell is set in
 * `marks`, a mask of the same box. O(cells). */
CellMask
markedRegions(const CellMask& mask, const CellMask& marks, bool eight_connected);

/** @brief The largest four-connected region, the first of several as large. O(cells).
 */
CellMask largestRegion(const CellMask& mask);

/** @brief Gives `number` to those of some cells that have no label (-1) yet; labels are
 * of the cells of `frame`. O(the cells' box). */
void labelCells(const CellMask& cells,
                const CellMask& frame,
                std::int32_t number,
                std::vector<std::int32_t>& label);

/** @brief Takes labels (-1: none) outwards through the cells of `domain`, step by step
 * to the four neighbours, at most `steps` steps: each cell gets the label that reaches
 * it first. O(cells). */
void growLabels(const CellMask& domain, int steps, std::vector<std::int32_t>& label);

/** @brief As growLabels(), but tells the ways too, at 8 bytes a cell.
 * @return for each cell the index of the one it was reached from, CellSet::npos for
 * seeds and for cells not reached */
std::vector<std::size_t> growLabelsWithParents(const CellMask& domain,
                                               int steps,
                                               std::vector<std::int32_t>& label);

/** @brief The cells that are not set from which no four-connected way of such cells
 * leads to the edge of the box: the holes of the mask. O(cells). */
CellMask enclosedCells(const CellMask& mask);

/** @brief `a` and `b` joined cell by cell; `b` may have another box, `a`'s is kept. */
CellMask unite(const CellMask& a, const CellMask& b);

/** @brief `a` without `b`; `b` may have another box, `a`'s is kept. */
CellMask subtract(const CellMask& a, const CellMask& b);

/** @brief The part of `a` that is in `b` too; `a`'s box is kept. */
CellMask intersect(const CellMask& a, const CellMask& b);

/** @brief The same cells within another box. */
CellMask cropped(const CellMask& mask, const CellBox& box);

/** @brief Adds to `mask` the `cells` within its box. O(the cells' box). */
void add(const CellMask& cells, CellMask& mask);

} // namespace sedr
} // namespace pcl
