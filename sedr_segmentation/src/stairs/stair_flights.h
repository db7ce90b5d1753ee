// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "stair_chains.h"
#include "straight_flight.h"

#include <pcl/sedr_filters/floorplan.h>

#include <vector>

namespace pcl::sedr {

/** @brief Returns the treads of the flights of a chain, which landings part. */
std::vector<std::vector<Tread>> treadsOf(const std::vector<StairStep>& chain,
                                         const std::vector<LevelPatch>& patches);

/** @brief Returns the flight of equal steps, as wide as their patches. */
PlanFlight flightOf(const StraightSteps& steps);

/** @brief Returns the flight of treads that turn, from riser to riser.
 * @param cell edge of the columns of the patches, metres */
PlanFlight turningFlight(std::vector<Tread> treads, double cell);

/** @brief Leads a flight on, as it runs and turns, to the floor at its foot or its
 * head, over treads that nobody saw.
 * @return the floor; none: the flight stays as it is */
RoomFloors::Floor
leadToFloor(PlanFlight& flight, const RoomFloors& floors, bool is_foot);

} // namespace pcl::sedr
