// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan.h"

#include <cstddef>
#include <filesystem>

/** @file Scans as files, each written completely or not at all. PCD files are binary
 * and unorganised: x y z (float32), label room (uint32). */

namespace pcl::sedr::sim {

void writePcd(const std::filesystem::path& path, const std::vector<ScanPoint>& points);

/** @brief Writes a line for each position: x y z in metres and its number of points,
 * which are in the same order in the scan. */
void writePositions(const std::filesystem::path& path,
                    const std::vector<ScanPosition>& positions);

/** @brief The result of writeBuilding(). */
struct BuildingScan {
  std::size_t points = 0;
  std::size_t copies = 0; ///< of the scene
};

/** @brief Streams a PCD of a large storey: copies of a scene with 30 cm of wall between
 * them.
 *
 * The scene is scanned once, without noise and without the outside; each copy gets its
 * own noise along the rays, and rooms of its own. The number of copies, at least one,
 * comes closest to @p points; they form an approximately square array. Memory is that
 * of one copy's points. The same scene, number, seed and options give the same bytes.
 * @throw std::invalid_argument if the scene cannot be built */
BuildingScan writeBuilding(const std::filesystem::path& path,
                           const Scene& scene,
                           std::size_t points,
                           const ScanOptions& options);

} // namespace pcl::sedr::sim
