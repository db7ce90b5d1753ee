// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scene/scene.h"
#include "simulator/truth/room_truth.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <memory>
#include <vector>

namespace pcl::sedr::benchmark {

/** @brief The truth that a reconstruction is compared with, in the frame of the scan.
 */
struct SceneTruth {
  std::shared_ptr<const TriangleMesh> mesh; ///< with label and room of every triangle
  std::vector<sim::RoomTruth> rooms;
  /// The same surface with chords at most 0.01 mm off its arcs, which is negligible
  /// when solids are measured.
  std::shared_ptr<const TriangleMesh> fine_mesh;
};

/** @brief Builds the truth of a scene.
 * @throw std::invalid_argument as sim::truthMesh() */
SceneTruth truthOf(const sim::Scene& scene);

/** @brief Returns the triangles of details and columns, labels 4 and 5; empty without
 * any. */
TriangleMesh detailsOf(const TriangleMesh& truth);

} // namespace pcl::sedr::benchmark
