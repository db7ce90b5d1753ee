// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "panes.h"

#include <Eigen/Core>

#include <vector>

namespace pcl::sedr {

using Places = std::vector<Eigen::Vector3d>;

constexpr double mirror_cube = 0.1; ///< metres, edge of cubes of likenesses

/** @brief How much of what lies behind a pane looks like a reflection in it. */
struct MirrorLikeness {
  double share = 0;  ///< of the places behind, that have their like in front
  double chance = 0; ///< the same of planes beside the pane
  bool is_at_several_depths =
      false; ///< one wall may be as far behind as another before

  /** @brief Returns 0 for no more than planes beside have by chance, 1 for all. */
  double value() const
  {
    return is_at_several_depths && chance < 1 ? (share - chance) / (1 - chance) : 0;
  }

  /** @brief Whether the pane is a mirror. */
  bool isMirror() const { return value() >= 0.5; }
};

/** @brief Moves a pane, whose normal points away from the scanner, to where it mirrors
 * most: it may stand behind its wall's face. O(places).
 * @param behind places behind it
 * @param filled cubes that hold points */
MirrorLikeness moveToMirror(Pane& pane, const Places& behind, const CubeTable& filled);

/** @brief Returns how surely what lies behind a wall is a reflection in it: the share
 * of it that has its like before the wall, less the share of the wall behind which
 * there is another face, as rooms have that are built alike; 0 if it looks like none.
 * O(places).
 * @param border places about where the wall is
 * @param before places before the wall, and on it
 * @param behind places behind it */
double mirroredBehind(const Places& border, const Places& before, const Places& behind);

} // namespace pcl::sedr
