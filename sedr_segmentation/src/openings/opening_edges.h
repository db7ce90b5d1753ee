// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "opening_weights.h"
#include "wall_map.h"

namespace pcl::sedr {

/** @brief Returns the rectangle with edges moved to the planes of the reveals, else to
 * the rim of the face's points. An arched head stays.
 * @param cells extent of the rectangle found on the map */
WallRectangle
fittedEdges(const WallMap& map, const WallRectangle& cells, const OpeningSizes& sizes);

} // namespace pcl::sedr
