// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>

namespace pcl {
namespace sedr {

/** @brief What is too narrow to be a part of a room, or of what stands in it. */
struct NeckParameters {
  double inside_width = 0.05;  ///< of a part of the room, metres: less than a cell
  double outside_width = 0.04; ///< of a part of its walls; partitions are thicker
  double most_area = 0.1;      ///< that is cut off at a neck, square metres
};

/** @brief Cuts off what hangs together with the rest of an outline by a neck only:
 * slits, spikes and pockets, inside of it first, then outside.
 *
 * A neck leads from a corner to the nearest place of another element, and the way
 * around what lies behind is at least four times as long: so a step in a wall, however
 * small, is none. The narrowest is cut first.
 * @param loop counter-clockwise, without crossings; none is made
 * @return how many were cut. O(n^2) for n elements, and O(n) for every neck tried */
std::size_t cutNecks(PlanLoop& loop, const NeckParameters& parameters = {});

} // namespace sedr
} // namespace pcl
