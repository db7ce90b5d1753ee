// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

#include <cstddef>
#include <vector>

namespace pcl::sedr {

/** @brief Returns the walls of other rooms to which a part of a room's boundary wrongly
 * comes closer than the minimum partition thickness. A partition has two faces, and the
 * points of one face do not belong to the other. The part may run along that wall or
 * lead to it where furniture hides the room's own face. The longer wall is right. */
std::vector<PlanElement>
facesOfOthers(const Floorplan& plan, std::size_t room, const Priors& priors = {});

} // namespace pcl::sedr
