// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl::sedr {

constexpr float no_height = std::numeric_limits<float>::infinity();

/** @brief Lowest and highest point of the ceiling in each cell. */
struct CeilingEnds {
  std::vector<float> low;
  std::vector<float> high;
};

/** @brief Replaces each value by the first in an order of all within `reach` cells
 * along x, then y. */
template <typename Before>
void
spread(const CellMask& frame, int reach, Before before, std::vector<float>& values)
{
  const int width = frame.width();
  const int height = frame.height();
  const auto along = [&](int lines, int length, std::size_t line, std::size_t step) {
    std::vector<float> row(static_cast<std::size_t>(length));
    for (int l = 0; l < lines; ++l) {
      float* const first = values.data() + static_cast<std::size_t>(l) * line;
      for (int k = 0; k < length; ++k) {
        float best = first[static_cast<std::size_t>(k) * step];
        for (int j = std::max(0, k - reach); j <= std::min(length - 1, k + reach); ++j)
          if (const float z = first[static_cast<std::size_t>(j) * step];
              before(z, best))
            best = z;
        row[static_cast<std::size_t>(k)] = best;
      }
      for (int k = 0; k < length; ++k)
        first[static_cast<std::size_t>(k) * step] = row[static_cast<std::size_t>(k)];
    }
  };
  along(height, width, static_cast<std::size_t>(width), 1);
  along(width, height, 1, static_cast<std::size_t>(width));
}

/** @brief Calls `see(index of the cell, point)` for the points in the frame, moved by
 * `place`. */
template <typename See, typename Place>
void
forEachIn(const CellMask& frame,
          const CellGrid& grid,
          const PointView& points,
          const std::vector<int>& indices,
          See see,
          Place place)
{
  for (const int i : indices) {
    const Eigen::Vector3f p = place(points[static_cast<std::size_t>(i)]);
    if (!std::isfinite(p.z()) || !grid.holds(p.x(), p.y()))
      continue;
    const Cell cell = grid.at(p.x(), p.y());
    if (frame.isInside(cell))
      see(frame.indexOf(cell), p);
  }
}

inline Eigen::Vector3f
asScanned(const Eigen::Vector3f& p)
{
  return p;
}

/** @brief Finds the surfaces of a room that reach up to its ceiling, once its ceiling
 * is known. O(points + cells of the box). */
void gatherWalls(const PointView& points,
                 const RoomPoints& room,
                 const WallSlopes& slopes,
                 const CellGrid& grid,
                 const RoomCellsParameters& parameters,
                 const CeilingEnds& ends,
                 RoomCells& cells);

} // namespace pcl::sedr
