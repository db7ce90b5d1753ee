// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_fit.h"

#include <pcl/sedr_filters/straightening.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Input of the plan fit: indices into the points. `room` has one entry per
 * point, 0 for none, or is empty for one room. */
struct PlanEvidence {
  std::vector<int> all;     ///< all points to use
  std::vector<int> ceiling; ///< of the main ceilings
  std::vector<int> details;
  std::vector<int> floor;
  std::vector<int> walls; ///< empty: all
  std::vector<std::uint32_t> room;
  std::vector<int> sheets;   ///< of ceilings that are not level
  bool finds_sheets = false; ///< whether ceilings that slope are found, not given
};

/** @brief Ceiling points of a room whose ceiling is not level. */
struct RoomSheet {
  std::uint32_t room = 0; ///< PlanRoom::id
  std::vector<Eigen::Vector3d> points;
};

/** @brief Fits all rooms of a plan, by increasing number, see fitRoom().
 *
 * Ceiling and detail points belong to their labelled room. Walls, floor and all other
 * points belong to the room with the nearest ceiling in plan, so each face of a thin
 * partition belongs to its own room.
 * @param[out] problem the reason if there is no room, a sentence; else empty
 * @param[out] warnings a sentence per room that could not be fitted
 * @param[out] boundaries the fitted boundary points of walls and columns; optional
 * @param[out] sheets of rooms with ceilings of facets. giveCeilings() makes the facets
 * when the walls are final; until then such a ceiling is a relief */
Floorplan fitPlan(const PointView& points,
                  const PlanEvidence& evidence,
                  const RoomFitParameters& parameters,
                  std::string& problem,
                  std::vector<std::string>& warnings,
                  std::vector<FittedBoundary>* boundaries = nullptr,
                  std::vector<RoomSheet>* sheets = nullptr);

/** @brief Sets the ceiling facets of rooms. A room without facets is not changed.
 * @param scan the raw scan, if known, for the fit of the facets
 * @param indices the points of the scan to use; empty: all
 * @param tilts of the walls of `plan`; points are where they were scanned */
void giveCeilings(const std::vector<RoomSheet>& sheets,
                  const PointView* scan,
                  const std::vector<int>& indices,
                  unsigned threads,
                  Floorplan& plan,
                  const WallTilts& tilts = {});

} // namespace pcl::sedr
