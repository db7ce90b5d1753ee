// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

namespace pcl::sedr {

/** @brief Removes straight elements that are shorter than the noise of a wall
 * (Priors::wall_noise): walls fitted one by one leave them where they do not quite
 * meet.
 *
 * Such an element goes where its neighbours' lines meet beside it, which moves neither
 * line. A step between parallel walls has no such place and stays, unless it is shorter
 * than a tenth of the noise. Of boundaries and columns. O(n squared) a loop of n
 * elements. */
void removeShortElements(Floorplan& plan, const Priors& priors);

} // namespace pcl::sedr
