// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room_links.h"
#include "simulator/scene/scene.h"
#include "truth_mesh.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr::sim {

/** @brief The true measures of a room, in the frame of the files: metres, square and
 * cubic metres.
 *
 * The loops are exact. Height and volume are those of the truth mesh, and so include
 * its soffits, steps and niches; its chords are at most kChordTolerance off an arc.
 */
struct RoomTruth {
  std::string name;
  std::uint32_t id = 0;          ///< the `room` field of its points, from 1
  Loop outline;                  ///< counter-clockwise; at the floor
  std::vector<double> tilts;     ///< of the walls, radians, positive into the room
  std::vector<Loop> columns;     ///< counter-clockwise
  double area = 0.0;             ///< inside the outline, without the columns
  double perimeter = 0.0;        ///< of the outline
  double column_perimeter = 0.0; ///< of all columns
  double height = 0.0;           ///< mean from floor to ceiling inside the outline
  double volume = 0.0;           ///< enclosed by the mesh, including niches
  double floor = 0.0;            ///< z of the floor's main plane, mean over the plan
  double ceiling = 0.0;          ///< z of the ceiling's main plane, mean over the plan
  std::size_t storey = 1;        ///< from 1, the lowest
  std::vector<Loop> voids;       ///< where its ceiling is open to a room above
  std::vector<Loop> floor_voids; ///< where its floor is open to a room below
};

/** @brief Returns the truth of every room of a scene, in the scene's order.
 * @throw std::invalid_argument as truthMesh()
 */
std::vector<RoomTruth> roomTruths(const Scene& scene);

/** @brief Returns the truth of every room from an existing mesh.
 * @param truth truthMesh() of the scene
 */
std::vector<RoomTruth> roomTruths(const Scene& scene, const Mesh& truth);

/** @brief Returns the truth as JSON: {"format": "sedr-room-truth", "version": 1,
 * "unit": "m", "scene": name, "storeys": [...], "rooms": [...], "links": [...]}. Loops
 * are lists of elements as in a floor plan: start and end, for arcs also centre, radius
 * and counter_clockwise. */
std::string roomTruthsToJson(const std::string& scene,
                             const std::vector<RoomTruth>& rooms,
                             const std::vector<RoomLink>& links = {});

} // namespace pcl::sedr::sim
