// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scan/vec.h"
#include "simulator/scene/scene.h"

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::sedr::sim {

/** @brief A triangle of the truth, counter-clockwise seen from outside of the room. */
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

/** @brief Largest distance in metres between an arc and its chords. */
constexpr double kChordTolerance = 0.0005;

/** @brief The structure of a scene: floors, ceilings with details, walls, columns.
 *
 * One closed, edge-manifold component a room, normals out of the room, so that its
 * signed volume is that of the room. Openings are shut flush with the wall's room side.
 * Vertices are in the scene's own frame: see placed().
 *
 * @param chord_tolerance how far from an arc its chords may be, in metres
 * @throw std::invalid_argument if a room's outlines cross or touch in single points
 */
Mesh truthMesh(const Scene& scene, double chord_tolerance = kChordTolerance);

} // namespace pcl::sedr::sim
