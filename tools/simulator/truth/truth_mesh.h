// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scan/vec.h"
#include "simulator/scene/scene.h"

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::sedr::sim {

/** @brief A triangle of the truth mesh, counter-clockwise seen from outside. */
struct Face {
  std::array<std::uint32_t, 3> vertices{};
  Label label = Label::Other;
  std::uint32_t room = 0; ///< counts from 1
};

/** @brief An indexed triangle mesh with a label and a room for every face. */
struct Mesh {
  std::vector<Vec3> vertices;
  std::vector<Face> faces;
};

/** @brief Maximum distance in metres between an arc and its chords. */
constexpr double kChordTolerance = 0.0005;

/** @brief Meshes the structure of a scene: floors, ceilings with details, walls,
 * columns.
 *
 * Every room is one closed, edge-manifold component. Normals point out of the room, so
 * that its signed volume is that of the room. Openings are closed flush with the room's
 * side of the wall. Vertices are in the scene's own frame: see placed().
 *
 * @param chord_tolerance maximum distance between an arc and its chords, in metres
 * @throw std::invalid_argument if a room's outlines cross or touch in single points
 */
Mesh truthMesh(const Scene& scene, double chord_tolerance = kChordTolerance);

} // namespace pcl::sedr::sim
