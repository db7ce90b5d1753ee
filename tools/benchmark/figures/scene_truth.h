// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scene/scene.h"
#include "simulator/truth/room_truth.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <memory>
#include <vector>

namespace pcl {
namespace sedr {
namespace benchmark {

/** @brief What a reconstruction of a scene is compared with, in the frame of the scan.
 */
struct SceneTruth {
  std::shared_ptr<const TriangleMesh> mesh; ///< with label and room of every triangle
  std::vector<sim::RoomTruth> rooms;
  /// The same surface with chords of at most 0.01 mm off its arcs, which count for
  /// nothing where solids are measured.
  std::shared_ptr<const TriangleMesh> fine_mesh;
};

/** @brief The truth of a scene.
 * @throw std::invalid_argument as sim::truthMesh() */
SceneTruth truthOf(const sim::Scene& scene);

/** @brief The triangles of details and columns, labels 4 and 5; empty without. */
TriangleMesh detailsOf(const TriangleMesh& truth);

} // namespace benchmark
} // namespace sedr
} // namespace pcl
