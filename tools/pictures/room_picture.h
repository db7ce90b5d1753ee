// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include <pcl/sedr_segmentation/room_segmentation.h>

#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief How the ceilings were parted into rooms: each with its number, and what
 * belongs to none.
 * @param ceilings cells of all ceilings that outlier removal has kept
 * @param cell_size metres */
Picture drawRooms(const std::vector<RoomRegion>& rooms,
                  const CellSet& ceilings,
                  double cell_size);

} // namespace tools
} // namespace sedr
} // namespace pcl
