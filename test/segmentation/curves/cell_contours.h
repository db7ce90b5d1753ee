// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_loops.h"

#include "sedr_filters/src/grids/cell_mask.h"
#include "sedr_segmentation/src/curves/contour.h"
#include <pcl/sedr_filters/cell_grid.h>

#include <algorithm>
#include <functional>

namespace sedr_test {

using namespace pcl::sedr;
using Eigen::Vector2d;

constexpr double cell = 0.05;

using Where = std::function<bool(const Vector2d&)>;

inline const Where everywhere = [](const Vector2d&) { return true; };

/** Returns the largest contour, counter-clockwise, of the cells around a loop for which
 * `is_taken(middle)` is true. */
inline Contour
contourOfCells(const PlanLoop& loop, const Where& is_taken)
{
  Vector2d low = Vector2d::Constant(1e9);
  Vector2d high = -low;
  for (const auto& corner : loop.polygon(0.01)) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const CellGrid grid(cell);
  CellMask mask(grown({grid.at(low.x(), low.y()), grid.at(high.x(), high.y())}, 2));
  for (std::size_t i = 0; i < mask.values().size(); ++i)
    mask.values()[i] = is_taken(grid.centre(mask.cellAt(i))) ? 1 : 0;
  const auto contours = traceContours(mask, cell);
  return *std::max_element(contours.begin(), contours.end(), [](auto& a, auto& b) {
    return signedArea(a) < signedArea(b);
  });
}

/** Returns the contour of the cells inside a loop, as those of a room's ceiling, for
 * whose middle `keep` returns true. */
inline Contour
contourIn(const PlanLoop& truth, const Where& keep = everywhere)
{
  return contourOfCells(truth, [&](const Vector2d& middle) {
    bool is_inside = keep(middle);
    for (const double dx : {-0.499, 0.499})
      for (const double dy : {-0.499, 0.499})
        is_inside = is_inside && truth.contains(middle + cell * Vector2d(dx, dy));
    return is_inside;
  });
}

/** Returns the clockwise contour of the cells that a column touches, whose ceiling is
 * hidden. */
inline Contour
holeOf(const PlanLoop& column)
{
  Contour hole = contourOfCells(column, [&](const Vector2d& middle) {
    bool is_touched = false;
    for (double dx = -0.5; dx <= 0.5; dx += 0.25)
      for (double dy = -0.5; dy <= 0.5; dy += 0.25)
        is_touched = is_touched || column.contains(middle + cell * Vector2d(dx, dy));
    return is_touched;
  });
  std::reverse(hole.begin(), hole.end());
  return hole;
}

} // namespace sedr_test
