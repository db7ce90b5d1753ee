// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_plan.h"
#include "scene_mesh.h"

#include <cstdint>
#include <vector>

namespace pcl::sedr::sim {

/** @brief Adds the closed mesh of one room to the mesh of a scene.
 *
 * Floors and ceilings are the triangles of the plan, lifted to their slabs. Walls,
 * columns, risers and niches are strips over sides of the plan. A strip has all
 * vertices above its ends, so that faces fit their neighbours.
 * @param number of the room, from 1
 * @param openings in its walls, also those given by other rooms
 * @param floor_voids holes in its floor
 * @return the plan of the room
 * @throw std::invalid_argument with the end of a sentence: see meshOf() */
RoomPlan addRoom(const Room& room,
                 std::uint32_t number,
                 const std::vector<Opening>& openings,
                 const std::vector<Loop>& floor_voids,
                 SceneMesh& scene);

} // namespace pcl::sedr::sim
