// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_points.h"
#include "sedr_filters/src/grids/cell_set.h"
#include "sedr_segmentation/src/plan/room_shares.h"

#include <pcl/sedr_segmentation/floorplan_fitting.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace sedr_test {

using namespace pcl::sedr;

/** Returns a room's points as the previous stages label them: points in a cell with a
 * wall are not ceiling. */
inline PlanEvidence
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
  PlanEvidence evidence;
  evidence.all = points.all();
  evidence.ceiling = besideWalls(parts.ceiling);
  evidence.details = parts.details;
  evidence.floor = parts.floor;
  evidence.walls = parts.walls;
  return evidence;
}

/** Adds the evidence of a room whose points were added last. */
inline void
addRoom(const RoomPoints& points,
        const RoomParts& parts,
        std::uint32_t number,
        PlanEvidence& evidence)
{
  const PlanEvidence own = evidenceOf(points, parts);
  evidence.all = own.all;
  evidence.ceiling = joined(evidence.ceiling, own.ceiling);
  evidence.details = joined(evidence.details, own.details);
  evidence.floor = joined(evidence.floor, own.floor);
  evidence.walls = joined(evidence.walls, own.walls);
  evidence.room.resize(points.size(), number);
}

using Fitting = pcl::FloorplanFitting<pcl::PointXYZ>;

/** Gives a fit its input. */
inline void
setEvidence(const RoomPoints& points, const PlanEvidence& evidence, Fitting& fitting)
{
  fitting.setInputCloud(points.cloud());
  fitting.setIndices(shared(evidence.all));
  fitting.setCeilingIndices(shared(evidence.ceiling));
  fitting.setDetailIndices(shared(evidence.details));
  fitting.setFloorIndices(shared(evidence.floor));
  if (!evidence.walls.empty())
    fitting.setWallIndices(shared(evidence.walls));
  fitting.setRooms(evidence.room);
}

/** Returns the plan of points, which must have one; empty otherwise. */
inline Floorplan
planOf(const RoomPoints& points,
       const PlanEvidence& evidence,
       std::vector<PlanWarning>* warnings = nullptr)
{
  Fitting fitting;
  setEvidence(points, evidence, fitting);
  Floorplan plan;
  EXPECT_TRUE(fitting.segment(plan)) << fitting.getErrorMessage();
  if (warnings)
    *warnings = fitting.getWarnings();
  return plan;
}

/** Returns the only room of points; an empty one if there is another number. */
inline PlanRoom
fitted(const RoomPoints& points, const PlanEvidence& evidence)
{
  const Floorplan plan = planOf(points, evidence);
  EXPECT_EQ(plan.rooms.size(), 1u);
  return plan.rooms.size() == 1 ? plan.rooms[0] : PlanRoom();
}

inline PlanRoom
fitted(const RoomPoints& points, const RoomParts& parts)
{
  return fitted(points, evidenceOf(points, parts));
}

/** Returns the room fitted to points of a room, every 5 cm. */
inline PlanRoom
fitted(const PlanRoom& truth, double noise)
{
  RoomPoints points(0.05, noise);
  const RoomParts parts = points.room(truth);
  return fitted(points, parts);
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
