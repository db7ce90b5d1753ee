// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../walls/plan_area.h"
#include "sedr_filters/src/walls/plan_walls.h"
#include "wall_heights.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl::sedr::ifc {

/** @brief How far the sides of a wall are tilted: metres along y for each metre up. */
struct WallRuns {
  double near = 0; ///< of its face
  double far = 0;  ///< of the other side

  /** @brief Returns whether the wall is as thick at any height. */
  bool areAlike() const { return std::abs(near - far) < 0.01; } // half a degree
};

/** @brief Returns the runs of a straight wall. The other side of a wall with one known
 * face is tilted like that. */
WallRuns runsOf(const Floorplan& plan, const PlanWall& wall);

constexpr double no_area =
    0.001; ///< smaller openings and walls are none, square metres
constexpr double min_wall_height = 0.01; ///< lower walls are none, metres

/** @brief Returns the plan of a wall in its frame, counter-clockwise, without the rooms
 * at its heights that reach behind its face: beside a niche or at a mitre. A wall that
 * surrounds a room has a hole. Empty if nothing is left. */
PlanArea profileOf(const WallSite& site);

/** @brief Returns a wall whose top is not level, or with sides of different runs, as a
 * mesh in its frame, with z from its bottom.
 * @param profile its plan, from profileOf() */
TriangleMesh meshOf(const Floorplan& plan,
                    const PlanWall& wall,
                    const WallHeights& heights,
                    const WallRuns& runs,
                    const PlanArea& profile);

/** @brief What is cut out of a wall between two heights. */
struct WallCut {
  PlanLoop plan; ///< in the frame of the wall, at its bottom if it is tilted
  PlanSlab bottom;
  PlanSlab top;
  bool is_recess = false; ///< not all through the wall
};

/** @brief Returns the volume of a wall without its cuts, which may overlap and reach
 * beyond it, cubic metres.
 * @param profile its plan, from profileOf() */
double volumeOf(const Floorplan& plan,
                const PlanWall& wall,
                const WallHeights& heights,
                const WallRuns& runs,
                const PlanArea& profile,
                const std::vector<WallCut>& cuts);

} // namespace pcl::sedr::ifc
