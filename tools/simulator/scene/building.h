// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"
#include "simulator/scan/scan.h"

#include <cstddef>
#include <filesystem>

namespace pcl::sedr::sim {

/** @brief What writeBuilding() wrote. */
struct BuildingScan {
  std::size_t points = 0;
  std::size_t copies = 0; ///< of the scene
};

/** @brief Writes the scan of a storey of a large building as a binary PCD of x y z
 * (float32) and label (uint32): copies of a scene side by side, 30 cm of wall between
 * them.
 *
 * The scene is scanned once, without noise and without what lies outside; each copy
 * gets noise of its own along the rays. There are as many copies as come nearest to
 * `points`, one at least, in rows that make about a square. Memory is that of the
 * points of one copy, however many there are. Same scene, number, seed and options:
 * same bytes.
 * @throw std::invalid_argument if the scene cannot be built, std::runtime_error if the
 * file cannot be written
 */
BuildingScan writeBuilding(const std::filesystem::path& path,
                           const Scene& scene,
                           std::size_t points,
                           const ScanOptions& options);

} // namespace pcl::sedr::sim
