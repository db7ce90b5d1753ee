// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../walls/plan_walls.h"
#include "ifc_shapes.h"

#include <vector>

namespace pcl {
namespace sedr {
namespace ifc {

/** @brief How high a wall is. */
struct WallHeights {
  struct Top {
    double along = 0; ///< share of its stretch, 0 to 1
    double height = 0;
  };

  double bottom = 0;     ///< the lowest floor beside it, metres
  std::vector<Top> tops; ///< two of one height where it is level
  /** The planes of a roof that the wall ends below, a x + b y + c z + d = 0, c > 0: the
   * lowest of them is its top. None where the ceiling is level or curved, or where two
   * parts of it do not meet in a ridge. */
  std::vector<Eigen::Vector4d> roof{};

  /** @brief Whether it is as high all along its face. */
  bool isLevel() const { return tops.size() == 2 && tops[0].height == tops[1].height; }
  /** @brief Whether its body is swept, and cut by a roof. */
  bool isSwept() const { return isLevel() || !roof.empty(); }

  double highest() const;
};

/** @brief The heights of the floors and ceilings on both sides of a wall: the higher
 * ceiling, soffits left out; below a sloping one the wall follows it. */
WallHeights heightsOf(const Floorplan& plan, const PlanWall& wall);

/** @brief The plan of a wall in its frame, counter-clockwise. A wall all around a room
 * has a hole. */
struct WallProfile {
  PlanLoop boundary;
  std::vector<PlanLoop> holes;
};

WallProfile profileOf(const Floorplan& plan, const PlanWall& wall);

/** @brief Above all of a wall's top, before its roof's planes cut it; metres. */
double
heightAbove(const Floorplan& plan, const PlanWall& wall, const WallHeights& heights);

/** @brief A wall whose top is not level, in its frame, z from its bottom. */
TriangleMesh
meshOf(const Floorplan& plan, const PlanWall& wall, const WallHeights& heights);

} // namespace ifc
} // namespace sedr
} // namespace pcl
