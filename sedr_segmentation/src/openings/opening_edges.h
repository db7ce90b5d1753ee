// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "opening_weights.h"
#include "wall_map.h"

namespace pcl::sedr {

/** @brief A rectangle on a map, metres. */
struct WallRectangle {
  double from = 0; ///< along the side
  double to = 0;
  double bottom = 0;
  double top = 0;       ///< of an arched head: its highest point
  double residual = 0;  ///< standard deviation of its edges
  double rise = 0;      ///< of an arched head
  double deviation = 0; ///< distance from its edges of 95 % of what shows them
};

/** @brief Returns the rectangle with edges moved to the planes of the reveals, else to
 * the rim of the face's points. An arched head stays.
 * @param cells extent of the rectangle found on the map */
WallRectangle
fittedEdges(const WallMap& map, const WallRectangle& cells, const OpeningSizes& sizes);

} // namespace pcl::sedr
