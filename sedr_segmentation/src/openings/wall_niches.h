// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "opening_search.h"

namespace pcl::sedr {

/** @brief Sets the niches of the rooms to those of the candidates for openings that
 * have a back.
 *
 * A niche is a rectangle in a straight wall most cells of which show nothing on the
 * wall or before it and end at one depth behind it, and hardly any shows something
 * farther behind. Shallow ones are closed doors or blinds, those from floor to ceiling
 * parts of the room. None reaches into a room or a niche of another one. Of niches
 * above each other, only the largest one is kept, as a plan has one floor and one
 * ceiling per position. */
void findNiches(const Priors& priors, const OpeningSearch& search, Floorplan& plan);

/** @brief Returns whether a niche of a room overlaps that room, another one of the same
 * heights or a niche of one. */
bool isShared(const Floorplan& plan, const PlanRoom& room, const PlanNiche& niche);

} // namespace pcl::sedr
