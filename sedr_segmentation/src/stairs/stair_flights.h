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

/** @brief Returns the flight of three treads or more that turn: risers half way between
 * their middles, as wide as they are. */
PlanFlight turningFlight(const std::vector<Tread>& treads);

/** @brief Leads a flight on, as it runs and turns, to the floor at its foot or its
 * head, over treads that nobody saw.
 * @return the floor; none: the flight stays as it is */
RoomFloors::Floor
leadToFloor(PlanFlight& flight, const RoomFloors& floors, bool is_foot);

} // namespace pcl::sedr
