// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "stair_chains.h"

#include <pcl/sedr_filters/floorplan.h>

#include <vector>

namespace pcl::sedr {

/** @brief Returns the flights of a chain, which landings part. Risers are where the
 * fronts of the treads lie: of a straight flight in the mean, at equal distances.
 * @param cell edge of the columns of the patches, metres */
std::vector<PlanFlight> flightsOf(const std::vector<StairStep>& chain,
                                  const std::vector<LevelPatch>& patches,
                                  double cell);

/** @brief Leads a flight on, as it runs and turns, to the floor at its foot or its
 * head, over treads that nobody saw.
 * @return the floor; none: the flight stays as it is */
RoomFloors::Floor
leadToFloor(PlanFlight& flight, const RoomFloors& floors, bool is_foot);

/** @brief Gives a flight the rise that equal steps between two floors have. A straight
 * one gets as many as fit best: treads that were not seen may have been miscounted. */
void fitBetween(double bottom, double top, PlanFlight& flight);

} // namespace pcl::sedr
