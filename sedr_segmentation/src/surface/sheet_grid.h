// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/plan/plan_geometry.h"
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::sedr {

/** @brief What is believed of ceilings, and how finely they are looked at. Costs are
 * logarithms of probability. */
struct SheetParameters {
  double cell_size = 0.1; ///< of the plan, each of one facet; larger in large rooms
  std::size_t max_cells = 30000; ///< of a room
  double unevenness = 0.005;     ///< by which a ceiling strays from its shape, metres:
                                 ///< plaster within a straightedge's tolerance
  double patch = 0.5;     ///< metres within which it strays as one: what is seen there
                          ///< counts once
  double outlier = 4.5;   ///< cost of a patch that no facet explains: three deviations
  double crease = 0.5;    ///< cost of a metre along which facets meet
  double step = 1;        ///< cost of a metre along which they miss each other by
                          ///< `full_step` or more
  double full_step = 0.2; ///< metres
  double min_area = 0.4;  ///< of a facet, square metres: half is seen of a proposal
  double min_closed_area = 0.25; ///< of a connected part of one
  double min_relief = 1;         ///< of a free form, square metres
  double relief_spacing = 0.25;  ///< between its heights, metres
  double largest_radius = 40;    ///< of a vault; flatter ones are planes, metres
  double min_step = 0.03;        ///< metres: less is unevenness of a level ceiling
  double min_clear_step = 0.06;  ///< metres: lower ones may be panels or rugs
  double min_free_area = 1;      ///< square metres: smaller things may hang or stand
  bool is_floor = false;         ///< no curves, no free forms; seen from above
  unsigned threads = 1;

  /** @brief Those of ceilings or floors of buildings that are built as priors say. */
  static SheetParameters of(const Priors& priors, bool is_floor);
};

/** @brief A part of the plan in square cells, which lie along the walls: steps and
 * beams mostly do, and a border of cells is straight along its rows only. */
struct SheetGrid {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero(); ///< of the first cell's corner
  Eigen::Vector2d axis = Eigen::Vector2d::UnitX();  ///< unit, along a row
  double size = 0.1;                                ///< of a cell, metres
  int columns = 0;
  int rows = 0;

  std::size_t count() const
  {
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }

  std::size_t indexOf(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(x);
  }

  int columnOf(std::size_t cell) const
  {
    return static_cast<int>(cell % static_cast<std::size_t>(columns));
  }

  int rowOf(std::size_t cell) const
  {
    return static_cast<int>(cell / static_cast<std::size_t>(columns));
  }

  bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < columns && y < rows; }

  /** @brief The place that lies so many cells from the origin. */
  Eigen::Vector2d placeOf(double x, double y) const
  {
    return origin + size * (x * axis + y * Eigen::Vector2d(-axis.y(), axis.x()));
  }

  /** @brief How many cells a place lies from the origin. */
  Eigen::Vector2d cellsTo(const Eigen::Vector2d& p) const
  {
    const Eigen::Vector2d off = (p - origin) / size;
    return {axis.dot(off), axis.x() * off.y() - axis.y() * off.x()};
  }

  Eigen::Vector2d centre(std::size_t cell) const
  {
    return placeOf(columnOf(cell) + 0.5, rowOf(cell) + 0.5);
  }

  /** @brief Calls `use(next)` for the cells that share a side with a cell. */
  template <typename Use>
  void forAllSides(std::size_t cell, Use use) const
  {
    const int x = columnOf(cell);
    const int y = rowOf(cell);
    if (x + 1 < columns)
      use(cell + 1);
    if (x > 0)
      use(cell - 1);
    if (y + 1 < rows)
      use(cell + static_cast<std::size_t>(columns));
    if (y > 0)
      use(cell - static_cast<std::size_t>(columns));
  }

  /** @brief Calls `use(near)` for the cells at most `reach` columns and rows from a
   * cell, row by row, itself among them.
   * @return whether none of them lies beside the grid */
  template <typename Use>
  bool forAllWithin(std::size_t cell, int reach, Use use) const
  {
    const int x = columnOf(cell);
    const int y = rowOf(cell);
    for (int row = std::max(0, y - reach); row <= std::min(rows - 1, y + reach); ++row)
      for (int column = std::max(0, x - reach);
           column <= std::min(columns - 1, x + reach); ++column)
        use(indexOf(column, row));
    return x >= reach && y >= reach && x + reach < columns && y + reach < rows;
  }

  /** @brief Index of the cell nearest to a place. */
  std::size_t nearest(const Eigen::Vector2d& p) const
  {
    const Eigen::Vector2i cell = cellsTo(p).array().floor().cast<int>();
    return indexOf(std::clamp(cell.x(), 0, columns - 1),
                   std::clamp(cell.y(), 0, rows - 1));
  }

  /** @brief Index of the cell around a place; count() beside the grid. */
  std::size_t at(const Eigen::Vector2d& p) const
  {
    const Eigen::Vector2d place = cellsTo(p);
    if (!(place.x() >= 0 && place.y() >= 0 && place.x() < columns && place.y() < rows))
      return count();
    return indexOf(static_cast<int>(place.x()), static_cast<int>(place.y()));
  }
};

/** @brief A grid over a part of the plan, with three cells to spare on every side.
 * @param box       around it, in the frame turned by `direction` about the origin
 * @param direction of the rows, radians, counter-clockwise from x */
SheetGrid sheetGrid(const Eigen::AlignedBox2d& box,
                    const SheetParameters& parameters,
                    double direction = 0);

/** @brief A grid over what a loop encloses, along the most frequent direction of its
 * walls. */
SheetGrid gridWithin(const PlanLoop& loop, const SheetParameters& parameters);

/** @brief The cells of a grid that lie within a loop, by their centres, or at most half
 * a cell beside it. */
std::vector<std::uint8_t> cellsWithin(const SheetGrid& grid, const PlanLoop& loop);

/** @brief The directions of a room's straight walls and those square to them, radians,
 * the most frequent first. */
std::vector<double> wallDirections(const PlanLoop& boundary);

} // namespace pcl::sedr
