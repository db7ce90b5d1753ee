// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_points.h"

#include "sedr_segmentation/src/plan/room_fit.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sedr_test {

using namespace pcl::sedr;

/** Returns a room's points as the previous stages label them: points in a cell with a
 * wall are not ceiling. */
inline RoomEvidence
evidenceOf(const RoomPoints& points, const RoomParts& parts)
{
  const CellGrid grid(0.05);
  const CellSet walls(grid, points.view(), parts.walls);
  const auto besideWalls = [&](const std::vector<int>& slab) {
    std::vector<int> kept;
    for (const int i : slab)
      if (!walls.contains(grid.at(points[i].x(), points[i].y())))
        kept.push_back(i);
    return kept;
  };
  RoomEvidence evidence;
  evidence.around = points.all();
  evidence.ceiling = besideWalls(parts.ceiling);
  evidence.details = parts.details;
  evidence.floor = parts.floor;
  evidence.walls = parts.walls;
  return evidence;
}

inline PlanRoom
fitted(const RoomPoints& points, const RoomParts& parts)
{
  std::string problem = "none yet";
  const PlanRoom room = fitRoom(points.view(), evidenceOf(points, parts), {}, problem);
  EXPECT_EQ(problem, "");
  return room;
}

/** Returns the maximum distance from an end in `truth` to the nearest in `loop`. */
inline double
cornerError(const PlanLoop& loop, const PlanLoop& truth)
{
  double worst = 0;
  for (const auto& e : truth.elements) {
    double least = 1e9;
    for (const auto& f : loop.elements)
      least = std::min(least, (f.start - e.start).norm());
    worst = std::max(worst, least);
  }
  return worst;
}

/** Returns the maximum distance from the outline of `truth` to `loop`. */
inline double
outlineError(const PlanLoop& loop, const PlanLoop& truth)
{
  double worst = 0;
  for (const auto& e : truth.elements)
    for (double share = 0.05; share < 1; share += 0.1)
      worst = std::max(worst, loop.distance(e.pointAt(share * e.length())));
  return worst;
}

} // namespace sedr_test
