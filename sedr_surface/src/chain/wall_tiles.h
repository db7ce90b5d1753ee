// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/grids/cell_set.h"
#include "sedr_filters/src/plan/plan_surfaces.h"

#include <pcl/sedr_filters/plan_warning.h>
#include <pcl/sedr_filters/priors.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace pcl::sedr {

constexpr double min_patch = 0.25; ///< of what is told, square metres
constexpr double off_wall = 0.05;  ///< metres from the model
constexpr double off_edge = 0.02;  ///< of a ceiling beyond a wall, metres
constexpr double off_slab = 0.1;   ///< metres; columns of air end on voxels
constexpr double wall_tile = 0.1;  ///< metres
constexpr double min_strip = 0.5;  ///< of what is told, metres of tiles
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double sigmas = 3; ///< of noise, off a surface

/** @brief A cell and a value that was found in it. */
using CellValue = std::pair<CellKey, double>;

/** @brief Returns the cells of some values, which must be in their order. */
CellSet cellsOf(const std::vector<CellValue>& values);

/** @brief Connected cells, of `least` square metres and more. */
struct Patches {
  std::size_t count = 0; ///< of cells
  double area = 0;
  double low = infinite; ///< of the values of the cells
  double high = -infinite;
  double mean = 0;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero(); ///< of the largest patch

  /** @param values in the order of their cells
   * @param size of a cell, metres */
  Patches(const std::vector<CellValue>& values, double size, double least = min_patch);
};

/** @brief Returns a warning about a floor or ceiling that was seen off its model. */
PlanWarning slabWarning(bool is_floor, const Patches& found, const PlanRoom& room);

/** @brief Checks whether something takes up a wall from end to end and is no door. */
bool isAsLongAs(const PlanElement& wall, double width, const Priors& priors);

/** @brief What was seen in each tile of a wall, the side of a column or a riser. */
class WallTiles {
public:
  explicit WallTiles(const VerticalSurface& surface);

  const VerticalSurface& surface() const { return surface_; }

  /** @brief Nothing is looked for where an opening is, or its reveals. One as long as
   * its wall may be what is seen of the wall behind cupboards. */
  void leaveOut(const PlanOpening& opening, const Priors& priors);

  /** @brief Returns how far a point is before the wall; infinite if it is not beside
   * it. */
  double offsetOf(const Eigen::Vector3d& p) const;

  bool isOn(double offset) const { return std::abs(offset) <= tolerance_; }

  void add(const Eigen::Vector3d& p, double offset);

  /** @brief Returns the patches of tiles with nothing on the wall: with something close
   * before them, or only with something behind, as a ceiling that goes on there. */
  Patches patches(bool is_behind) const;

  /** @brief Returns the columns of tiles behind which the ceiling goes on, half a metre
   * of them or more: no wall can be there. */
  Patches passedUnder() const;

  double height() const { return wall_tile * static_cast<double>(rows_); }

  static constexpr double reach = 0.9;   ///< before and behind a wall, metres
  static constexpr double relief = 0.15; ///< metres; furniture is deeper

private:
  struct Tile {
    bool is_on = false;
    double before = infinite;
    double behind = -infinite;
  };

  double middleOf(std::size_t row) const;

  VerticalSurface surface_;
  double edge_; ///< a ceiling that goes on farther behind the wall passes it
  double tolerance_;
  std::vector<VerticalSpan> spans_; ///< of each column of tiles
  double low_ = 0;
  std::size_t rows_ = 0;
  std::vector<Tile> tiles_; ///< row by row; then the ceiling behind, from the wall on
};

} // namespace pcl::sedr
