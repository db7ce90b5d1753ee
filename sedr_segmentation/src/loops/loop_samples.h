// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../curves/plan_points.h"
#include "loop_energy.h"
#include "sedr_filters/src/grids/cell_mask.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief A sample of the contour of a region and what was seen beside it. */
struct LoopSample {
  Eigen::Vector2d place;          ///< on the contour
  Eigen::Vector2d normal;         ///< unit, out of the room
  std::array<double, 3> offset{}; ///< of up to three surfaces along the normal, metres
  std::array<double, 3> weight{}; ///< their points; 0: none
  std::array<double, 3> before{}; ///< share of them that stands before, or is missing
  double seen = 0;        ///< share of an observation: 1 if a wall was seen clearly
  Eigen::Vector2d anchor; ///< on the surface that costs least, else the place

  std::size_t points = 0; ///< of the densest surface

  bool isSeen() const { return seen > 0.3; }
};

/** @brief A closed contour of a region, the room on its left. */
struct LoopContour {
  std::size_t room = 0; ///< index of the room
  bool is_hole = false; ///< of a column: clockwise
  std::vector<LoopSample> samples;
  std::vector<Eigen::Vector2d> points; ///< beside the samples, sample by sample
  std::vector<std::size_t> first;      ///< first point of each sample, and the end

  /** @brief Cost of the strip between each sample and a curve at an offset along its
   * normal, nats: `area_steps` values a sample. */
  std::vector<float> area;
};

/** @brief Offsets of the table of areas: half a cell apart, from -reach to reach. */
struct AreaTable {
  double step = 0.025; ///< metres
  int half = 60;       ///< steps to each side

  int columns() const { return 2 * half + 1; }

  int at(double offset) const
  {
    const int k = half + static_cast<int>(std::lround(offset / step));
    return std::min(std::max(k, 0), columns() - 1);
  }
};

/** @brief The cells around a contour that tell what a curve beside it cuts or adds. */
struct LoopCells {
  const CellMask* region = nullptr;
  const CellMask* seen = nullptr;   ///< air that the room saw; null: all of the region
  const CellMask* others = nullptr; ///< of other rooms; null: none
};

/** @brief Traces the contours of a region: the outer one first. Contours shorter than
 * half a metre are left out. */
std::vector<LoopContour>
contoursOf(const CellMask& region, const CellGrid& grid, std::size_t room);

/** @brief Gives each sample of a contour the points beside it, and the areas of curves
 * there. */
void gatherBeside(const PlanPoints& walls,
                  const LoopCells& cells,
                  const CellGrid& grid,
                  const LoopEnergy& energy,
                  LoopContour& contour);

/** @brief Finds the surfaces beside all samples. */
void findSurfaces(std::vector<LoopContour>& contours,
                  const LoopEnergy& energy,
                  double spacing);

} // namespace pcl::sedr
