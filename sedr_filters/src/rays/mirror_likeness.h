// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "panes.h"

namespace pcl::sedr {

/** @brief Moves a pane, whose normal points away from the scanner, to where it mirrors
 * most: it may stand behind its wall's face.
 * @param behind places that rays through the pane met behind it
 * @param filled cubes that hold points
 * @return whether the pane is a mirror: a good part of the places has its like in front
 * of it, more than planes beside it have by chance, at several depths */
bool moveToMirror(Pane& pane,
                  const std::vector<Eigen::Vector3d>& behind,
                  const CubeTable& filled);

} // namespace pcl::sedr
