// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

#include <cstddef>

namespace pcl::sedr {

/** @brief Cuts off what hangs together with the rest of an outline by a neck only:
 * slits, spikes and pockets, inside of it first, then outside.
 *
 * A neck leads from a corner to the nearest place of another element, and the way
 * around what lies behind is at least four times as long: so a step in a wall, however
 * small, is none. The narrowest is cut first. A part of the room is wider than the
 * noise of a wall, one of its walls as thick as a partition; what is not small stays.
 * @param loop counter-clockwise, without crossings; none is made
 * @return how many were cut. O(n^2) for n elements, and O(n) for every neck tried */
std::size_t cutNecks(PlanLoop& loop, const Priors& priors = {});

} // namespace pcl::sedr
