// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/plan_warning.h>

#include "room_ceilings.h"
#include "room_shares.h"

#include <string>
#include <vector>

namespace pcl::sedr {

/** @brief Fits all rooms of a plan: outlines by StoreyEnergy, ceilings and floors by
 * the facets' energy.
 * @param scan the raw scan, may be empty; it tells glass from walls
 * @param scan_indices the points of it to use; empty: all
 * @param[out] problem the reason if there is no room, a sentence; else empty
 * @param[out] warnings rooms that could not be fitted
 * @param[out] boundaries the boundary points of walls and columns
 * @param[out] noise of the walls of each storey
 * @param[out] sheets the ceilings and floors that are more than a plane. giveCeilings()
 * makes their facets when the walls are final; until then they are reliefs */
Floorplan fitPlanByEnergy(const PointView& points,
                          const PlanEvidence& evidence,
                          const PointView& scan,
                          const std::vector<int>& scan_indices,
                          const RoomFitParameters& parameters,
                          std::string& problem,
                          std::vector<PlanWarning>& warnings,
                          std::vector<FittedBoundary>& boundaries,
                          std::vector<WallNoise>& noise,
                          std::vector<RoomSheet>& sheets);

} // namespace pcl::sedr
