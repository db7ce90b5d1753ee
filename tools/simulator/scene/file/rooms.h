// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "json_view.h"
#include "simulator/scene/scene.h"

namespace pcl::sedr::sim {

/** @brief Adds the rooms of a list, with furniture and the lobbies behind doors.
 *
 * Openings may lead to any room of the list, by name.
 */
void readRooms(const JsonView& list, Scene& scene);

} // namespace pcl::sedr::sim
