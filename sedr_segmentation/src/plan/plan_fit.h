// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_fit.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief What a floor plan is fitted to: indices into the points; `room` as long as
 * the cloud, 0 none, or empty for one room. */
struct PlanEvidence {
  std::vector<int> all;     ///< every point that may be looked at
  std::vector<int> ceiling; ///< of the main ceilings
  std::vector<int> details;
  std::vector<int> floor;
  std::vector<int> walls; ///< empty: all
  std::vector<std::uint32_t> room;
  std::vector<int> sheets; ///< of ceilings that are not level, as they were seen
};

/** @brief What a plan's rooms are found on whose ceilings are not level. */
struct RoomSheet {
  std::uint32_t room = 0; ///< PlanRoom::id
  std::vector<Eigen::Vector3d> points;
};

/** @brief Fits every room of a plan, by increasing number, see fitRoom().
 *
 * Ceiling and detail points belong to the room they are labelled with; walls, floor and
 * everything else to the room whose ceiling is nearest in plan, so that each face of a
 * thin partition is looked at from its own room.
 * @param[out] problem why there is no room, a sentence; empty if there is one
 * @param[out] warnings a sentence for every room that could not be fitted while others
 * could
 * @param[out] boundaries what the walls and columns were fitted to, if wanted
 * @param[out] sheets of rooms whose ceilings are facets, which giveCeilings() makes
 * once the walls stand where they stay: till then they are reliefs */
Floorplan fitPlan(const PointView& points,
                  const PlanEvidence& evidence,
                  const RoomFitParameters& parameters,
                  std::string& problem,
                  std::vector<std::string>& warnings,
                  std::vector<FittedBoundary>* boundaries = nullptr,
                  std::vector<RoomSheet>* sheets = nullptr);

/** @brief Gives rooms the facets of their ceilings. A room that has none keeps what it
 * has.
 * @param scan what the points were thinned from, if it is known, to fit the facets to
 * @param indices those of its points that count; empty: all */
void giveCeilings(const std::vector<RoomSheet>& sheets,
                  const PointView* scan,
                  const std::vector<int>& indices,
                  unsigned threads,
                  Floorplan& plan);

} // namespace sedr
} // namespace pcl
