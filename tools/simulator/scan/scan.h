// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan_point.h"
#include "simulator/scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace pcl::sedr::sim {

/** @brief What to change about a scene's scanners, and how to run. */
struct ScanOptions {
  std::uint64_t seed = 1;
  std::optional<double> noise;                 ///< metres along the ray
  std::optional<std::size_t> rays_per_station; ///< about so many, to fill whole rows
  std::optional<double> max_range;             ///< metres
  unsigned threads = 0;                        ///< 0: as many as the machine has
  /// Called now and then with the share that is done, from one thread at a time.
  std::function<void(double)> progress;
};

/** @brief A position of a scanner, in the frame of the files, and how many points it
 * gave. */
struct ScanPosition {
  Vec3 place;
  std::size_t points = 0;
};

/** @brief The points of a scan and how many rays it took. */
struct Scan {
  std::vector<ScanPoint> points;       ///< one position after the other
  std::vector<ScanPosition> positions; ///< in that order
  std::size_t rays = 0;
};

/** @brief Scans a scene: the nearest hit of every ray, in the frame of the files.
 *
 * Same scene, seed and options give the same points in the same order for any number of
 * threads. Cost: rays times the logarithm of the number of surfaces.
 * @throw std::invalid_argument if the scene cannot be built: see surfacesOf()
 */
Scan scan(const Scene& scene, const ScanOptions& options = {});

} // namespace pcl::sedr::sim
