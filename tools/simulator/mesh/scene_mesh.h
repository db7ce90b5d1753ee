// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scene/scene.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <cstdint>
#include <vector>

/** @file A scene as one triangle mesh: what rays are cast at, and the truth. Vertices
 * are in the scene's own frame; curves are chords and facets within kCurveTolerance. */

namespace pcl::sedr::sim {

/** @brief What a triangle of a scene is. */
enum class Surface : std::uint8_t {
  Structure, ///< of a room, with its normal out of the room
  Gap,       ///< closes a room at an opening or void, where rays pass
  Object,    ///< furniture, reveals, shafts, the world outside
  Pane       ///< of a window
};

/** @brief What a face of a scene is. */
struct FaceLook {
  Surface surface = Surface::Object;
  Label label = Label::Other;
  std::uint32_t room = 0;    ///< 0: none
  std::uint32_t opening = 0; ///< number of the opening, of gaps and panes
};

/** @brief The pane of an opening. */
struct Pane {
  Glazing glazing;
  bool is_flat = true; ///< only flat panes mirror
};

/** @brief The triangles of a scene, each with its label and room (0 none).
 *
 * Structure and gaps of a room are one closed, edge-manifold component with normals out
 * of the room: soffits, niches and columns included, doors and windows closed flush
 * with the room's face of the wall. */
struct SceneMesh {
  TriangleMesh mesh; ///< `elements`: number of the opening, of gaps and panes
  std::vector<Surface> surfaces; ///< of each triangle
  std::vector<Pane> panes;       ///< by the number of their opening, less 1

  std::uint32_t addVertex(const Vec3& position);
  void addFace(const Triangle& corners, const FaceLook& look);
};

/** @brief Returns everything in the scene that a ray can hit, and the gaps.
 * @throw std::invalid_argument if the scene cannot be built: openings that lie on no
 * wall, a ceiling below its floor, rooms that overlap, openings, niches or voids that
 * reach into other rooms, parts that cross in a line between their edges or touch in a
 * single point */
SceneMesh meshOf(const Scene& scene);

/** @brief Returns structure and gaps of a mesh: the truth. */
TriangleMesh truthOf(const SceneMesh& scene);

} // namespace pcl::sedr::sim
