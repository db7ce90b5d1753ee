// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ranks.h"

#include <pcl/sedr_surface/structural_poisson.h>

namespace pcl::sedr::tools {

/** @brief Deals the rooms out by number, and gathers their surfaces at rank 0. */
RoomSharing sharedRooms(const Ranks& ranks);

} // namespace pcl::sedr::tools
