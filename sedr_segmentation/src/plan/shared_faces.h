// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/priors.h>

#include <cstddef>
#include <vector>

namespace pcl {
namespace sedr {

/** @brief Walls of other rooms, seen from the other side, that a part of a room's
 * boundary comes nearer to than any partition is thick, though the room has no business
 * there: what is between two rooms has two faces, and the points of one do not show the
 * other. The part may lie along it or, where furniture hides the room's own face but
 * for its ends, lead from the one to the other. The longer wall is right. */
std::vector<PlanElement>
facesOfOthers(const Floorplan& plan, std::size_t room, const Priors& priors = {});

} // namespace sedr
} // namespace pcl
