// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "picture.h"

#include <pcl/sedr_segmentation/building.h>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief How the air of a building was parted into rooms: for each storey its rooms,
 * each with its number and area, what something hid of them darker, doorways, and the
 * heights of their ceilings beside. */
Picture drawRooms(const Building& building);

} // namespace tools
} // namespace sedr
} // namespace pcl
