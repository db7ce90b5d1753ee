// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../links/loop_chain.h"

#include <vector>

namespace pcl::sedr {

/** @brief What hardly any point shows was led along the edge of the ceiling that was
 * seen, which says little of its shape: it becomes straight, gets the direction of a
 * wall that was seen, or square to it, if that is within 20 degrees, and lies where the
 * ceiling reaches farthest, as what is below it is inside. What runs along no wall ends
 * where the view did: walls beside it that are about square meet instead, up to 1.2 m
 * behind it, as behind a wardrobe across a corner, and such that run alike are joined
 * squarely. A short step beside it that is hardly seen gives way.
 * An arc of which less than half was seen becomes a segment, too, where that agrees as
 * well. */
void squareUnseenLinks(LoopChain& chain,
                       const std::vector<ContourSample>& samples,
                       const PlanPoints& evidence,
                       const LoopParameters& parameters);

} // namespace pcl::sedr
