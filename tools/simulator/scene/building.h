// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"
#include "simulator/scan/scan.h"

#include <cstddef>
#include <filesystem>

namespace pcl::sedr::sim {

/** @brief The result of writeBuilding(). */
struct BuildingScan {
  std::size_t points = 0;
  std::size_t copies = 0; ///< of the scene
};

/** @brief Writes a scan of a large storey, made of copies of a scene with 30 cm of wall
 * between them.
 *
 * The file is a binary PCD of x y z (float32) and label (uint32). The scene is scanned
 * once, without noise and without the outside; each copy gets its own noise along the
 * rays. The number of copies, at least one, comes closest to @p points; they form an
 * approximately square array. Memory is that of one copy's points. The same scene,
 * number, seed and options give the same bytes.
 * @throw std::invalid_argument if the scene cannot be built
 * @throw std::runtime_error if the file cannot be written
 */
BuildingScan writeBuilding(const std::filesystem::path& path,
                           const Scene& scene,
                           std::size_t points,
                           const ScanOptions& options);

} // namespace pcl::sedr::sim
