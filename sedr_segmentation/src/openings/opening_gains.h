// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "opening_labels.h"
#include "wall_map.h"

#include <vector>

namespace pcl::sedr {

/** @brief The side behind a cell of a map. */
struct MapBehind {
  const WallMap* map = nullptr; ///< null: none is known
  double along = 0;             ///< place on it
};

/** @brief Returns the gains of openings on a map.
 * @param behind of each cell
 * @param is_wall of each column, whether the side is there: not where the room goes on
 * to another wall behind it */
CellGains openingGains(const WallMap& map,
                       const std::vector<MapBehind>& behind,
                       const std::vector<bool>& is_wall,
                       const OpeningWeights& weights,
                       const OpeningSizes& sizes);

} // namespace pcl::sedr
