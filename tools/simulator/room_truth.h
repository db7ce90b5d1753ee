// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"
#include "truth_mesh.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr::sim {

/** @brief What is true of a room, in the frame of the files: metres, square and cubic
 * metres.
 *
 * The loops are exact; height and volume are those of the truth mesh, so that whatever
 * it shows of soffits, steps and niches counts. Its chords are at most kChordTolerance
 * off an arc.
 */
struct RoomTruth {
  std::string name;
  std::uint32_t id = 0;          ///< the `room` of its points, from 1
  Loop outline;                  ///< counter-clockwise
  std::vector<Loop> columns;     ///< counter-clockwise
  double area = 0.0;             ///< inside the outline, without the columns
  double perimeter = 0.0;        ///< of the outline
  double column_perimeter = 0.0; ///< of all columns
  double height = 0.0;           ///< mean from floor to ceiling inside the outline
  double volume = 0.0;           ///< of all the mesh encloses, niches included
};

/** @brief The truth of every room of a scene, in its order.
 * @throw std::invalid_argument as truthMesh()
 */
std::vector<RoomTruth> roomTruths(const Scene& scene);

/** @brief The same from a mesh that is there already.
 * @param truth truthMesh() of the scene
 */
std::vector<RoomTruth> roomTruths(const Scene& scene, const Mesh& truth);

/** @brief The rooms as JSON: {"format": "sedr-room-truth", "version": 1, "unit": "m",
 * "scene": name, "rooms": [...]}. Loops are lists of elements as in a floor plan: start
 * and end, for arcs centre, radius and counter_clockwise.
 */
std::string roomTruthsToJson(const std::string& scene,
                             const std::vector<RoomTruth>& rooms);

} // namespace pcl::sedr::sim
