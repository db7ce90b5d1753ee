// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/mesh/scene_mesh.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::sedr::sim {

/** @brief One record of a scan, in the layout of the file. */
struct ScanPoint {
  float x = 0.0F;
  float y = 0.0F;
  float z = 0.0F;
  std::uint32_t label = 0; ///< see StructureLabel
  std::uint32_t room = 0;  ///< counts from 1; 0 none
};

/** @brief Settings of a scan; those that are set replace the scanners' own. */
struct ScanOptions {
  std::uint64_t seed = 1;
  std::optional<double> noise;                 ///< metres along the ray
  std::optional<std::size_t> rays_per_station; ///< approximate, to fill whole rows
  std::optional<double> max_range;             ///< metres
  unsigned threads = 0;                        ///< 0: one per core
};

/** @brief A scanner position in the frame of the files and its number of points. */
struct ScanPosition {
  Vec3 place;
  std::size_t points = 0;
};

/** @brief The points of a scan and the number of rays that were cast. */
struct Scan {
  std::vector<ScanPoint> points;       ///< grouped by position
  std::vector<ScanPosition> positions; ///< in the order of their points
  std::size_t rays = 0;
};

/** @brief Returns the nearest hit of every ray, in the frame of the files.
 *
 * A window pane returns some of the rays, mirrors some and transmits the others. A
 * mirrored ray is recorded along its original direction, as a real scanner does. The
 * same scene, seed and options give the same points in the same order for any number of
 * threads. Cost: rays times the logarithm of the number of triangles.
 * @throw std::invalid_argument if the scene cannot be built: see meshOf() */
Scan scan(const Scene& scene, const ScanOptions& options = {});

/** @brief As above, with meshOf(scene) made before. */
Scan scan(const Scene& scene, const SceneMesh& mesh, const ScanOptions& options = {});

} // namespace pcl::sedr::sim
