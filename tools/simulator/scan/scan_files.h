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

} // namespace pcl::sedr::sim
