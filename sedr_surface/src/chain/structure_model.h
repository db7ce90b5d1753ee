// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_surface/structure_chain.h>

namespace pcl::sedr {

/** @brief Moves a cloud to another frame. */
void moveCloud(const BuildingFrame& frame, StructureModel::Cloud& cloud);

/** @brief Turns results in the frame of the building back to the level frame. */
void moveBack(StructureModel& model);

/** @brief Warns of what was left out of the scan before the stages ran.
 * @param raw the points from which it was thinned; may be empty */
void warnOfInput(const PointView& raw, StructureModel& model);

/** @brief Warns of rooms and walls of which little was measured. */
void warnOfGuesses(StructureModel& model);

/** @brief Warns of rooms whose mesh has another volume than their solid. */
void warnOfVolumes(const std::vector<RoomSolidReport>& solids,
                   const std::vector<RoomPoissonReport>& meshes,
                   StructureModel& model);

} // namespace pcl::sedr
