// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Mean height of a room in metres, over samples of its floor every 5 cm, a
 * million at most; 0 if none lies in it. */
double meanHeight(const PlanRoom& room);

/** @brief What a room of this mean height encloses, its niches too, cubic metres. */
double volumeOf(const PlanRoom& room, double mean_height);

/** @brief Thickness of the wall behind an element of a room's boundary, metres: the
 * median distance to the face on its other side, of another room or of this one, where
 * that is parallel (to 5 degrees) and at most `most` away. 0 where less than a fifth
 * of the element has such a face: the wall is known from one side only.
 * @param room,element indices into the plan */
double wallThickness(const Floorplan& plan,
                     std::size_t room,
                     std::size_t element,
                     double most = 0.6);

/** @brief Rooms that lie one beside the other. */
struct PlanStorey {
  double floor = 0;                 ///< the lowest of its rooms' floors, metres
  std::vector<std::uint32_t> rooms; ///< PlanRoom::id, in the order of the plan
};

/** @brief The rooms by storey, from the lowest up: rooms are of one where the heights
 * from floor to ceiling, at the middle of each, have more than half of the lower room's
 * in common with those of a room of it. */
std::vector<PlanStorey> storeysOf(const Floorplan& plan);

} // namespace sedr
} // namespace pcl
