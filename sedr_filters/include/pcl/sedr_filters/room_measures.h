// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>

#include <cstddef>

namespace pcl {
namespace sedr {

/** @brief Mean height of a room in metres, over samples of its floor every 5 cm, a
 * million at most; 0 if none lies in it. */
double meanHeight(const PlanRoom& room);

/** @brief What a room of this mean height encloses, its niches too, cubic metres. */
double volumeOf(const PlanRoom& room, double mean_height);

/** @brief Thickness of the wall behind an element of a room's boundary, metres: the
 * median distance to the face on its other side, of another room at its heights or of
 * this one, where that is parallel (to 5 degrees) and at most `most` away. 0 where less
 * than a fifth of the element has such a face: the wall is known from one side only.
 * @param room,element indices into the plan */
double wallThickness(const Floorplan& plan,
                     std::size_t room,
                     std::size_t element,
                     double most = 0.6);

} // namespace sedr
} // namespace pcl
