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
 * @param all cubes that hold points: a surface that goes on along the normal is like
 * itself wherever it is mirrored, and says nothing
 * @param before cubes of those before the pane */
MirrorLikeness moveToMirror(Pane& pane,
                            const Places& behind,
                            const CubeTable& all,
                            const CubeTable& before);

/** @brief What was seen of a part of a building, one place a cube. */
struct SeenPart {
  Places places;
  CubeTable cubes = CubeTable(mirror_cube);

  void add(const Eigen::Vector3d& p)
  {
    places.push_back(p);
    cubes.add(cubes.at(p));
  }
};

/** @brief Whether what lies behind a wall is a reflection in it: there is a wall of one
 * face, and what is behind has its like before it; of rooms that are built alike both
 * faces of the wall between were seen. O(places), and O(points) if the rest holds.
 * @param border places about where the wall is
 * @param before what was seen before the wall, and on it
 * @param behind what was seen behind it
 * @param all cubes of what was seen, see moveToMirror()
 * @param points those of the scan */
bool isReflection(const Places& border,
                  const SeenPart& before,
                  const SeenPart& behind,
                  const CubeTable& all,
                  const PointView& points);

} // namespace pcl::sedr
