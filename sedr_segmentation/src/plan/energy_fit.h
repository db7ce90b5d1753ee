// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/plan_warning.h>

#include "room_ceilings.h"
#include "room_shares.h"

#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief The rooms of a plan as they are labelled. */
struct FittedPlan {
  Floorplan plan;
  std::string problem;               ///< why there is no room, a sentence; else empty
  std::vector<PlanWarning> warnings; ///< rooms that could not be fitted
  std::vector<FittedBoundary> boundaries; ///< boundary points of walls and columns
  std::vector<WallNoise> noise;           ///< of the walls of each storey
  /** @brief The ceilings and floors that are more than a plane. giveCeilings() makes
   * their facets when the walls are final; until then they are reliefs. */
  std::vector<RoomSheet> sheets;
};

/** @brief Fits all rooms of a plan: outlines by StoreyEnergy, ceilings and floors by
 * the facets' energy.
 * @param scan the raw scan, may be empty; it tells glass from walls
 * @param scan_indices the points of it to use; empty: all */
FittedPlan fitPlanByEnergy(const PointView& points,
                           const PlanEvidence& evidence,
                           const PointView& scan,
                           const std::vector<int>& scan_indices,
                           const RoomFitParameters& parameters);

} // namespace pcl::sedr
