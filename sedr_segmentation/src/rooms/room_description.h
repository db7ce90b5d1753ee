// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../parting/room_parting.h"

#include <pcl/sedr_segmentation/building.h>

#include <vector>

namespace pcl::sedr {

/** @brief Each part of the air as a room, with its columns, heights, area and
 * enclosure, whether it is one or not; in their order, ids from 1. O(gaps). */
std::vector<BuildingRoom> describeRooms(const AirGaps& air, const PartedAir& parted);

/** @brief How densely floor and ceiling of each part were seen: of the columns of the
 * thinned scan where a surface was, the share that has a point of it, of both surfaces
 * the lower. O(columns).
 * @param fine columns of the thinned scan
 * @param grid of the columns of the parts, whose cells are whole ones of `fine` */
std::vector<double> seenDensities(const std::vector<BuildingRoom>& parts,
                                  const VoxelColumns& fine,
                                  const CellGrid& grid);

/** @brief How one knows that a part of the air is of this building. */
enum class PartAccess {
  Reached, ///< one walks into it from another, or it is the largest
  Dense,   ///< seen as densely as the others: a scanner was in it
  None     ///< neither: into what is closed and sparse a scanner looks through glass
};

/** @brief Why a part of the air is no room, for people; empty if it is one.
 * @param[out] kind what it is instead */
std::string noRoomBecause(const BuildingRoom& room,
                          double cell_size,
                          PartAccess access,
                          const BuildingParameters& parameters,
                          LeftOutKind& kind);

/** @brief Why a room that one walks into is none: most of its outline is where the view
 * ended, and not along its walls, as panes are. Empty if it is one.
 * @param box area of the smallest rectangle around it */
std::string seenInPart(const BuildingRoom& room, double box);

} // namespace pcl::sedr
