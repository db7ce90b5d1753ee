// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/scan/scan.h"
#include "simulator/scene/scene.h"
#include "truth_mesh.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/** @file
 * Binary PCD and PLY, and text. Each file is written beside its name and renamed when
 * complete, so that nobody ever reads half of one. Failure throws std::runtime_error
 * with a sentence.
 */

namespace pcl::sedr::sim {

/** @brief Writes x y z (float32) label room (uint32) as an unorganised binary PCD. */
void writePcd(const std::filesystem::path& path, const std::vector<ScanPoint>& points);

/** @brief A point of a building: what a row of its file holds. */
struct LabelledPoint {
  float x;
  float y;
  float z;
  std::uint32_t label;
};

using PointSink = std::function<void(const LabelledPoint&)>;

/** @brief Writes x y z (float32) label (uint32) as an unorganised binary PCD, as the
 * points come: `make` is to hand `count` of them to the sink it gets.
 */
void writePcdStream(const std::filesystem::path& path,
                    std::size_t count,
                    const std::function<void(const PointSink&)>& make);

/** @brief Writes the mesh, moved by @p placement, as a binary PLY.
 *
 * Vertices are float32; every face has its int properties label and room.
 */
void writePly(const std::filesystem::path& path,
              const Mesh& mesh,
              const Placement& placement);

/** @brief Writes a line for each position: x y z in metres, and how many of the points
 * of the scan, which stand in the same order, are from there. */
void writePositions(const std::filesystem::path& path,
                    const std::vector<ScanPosition>& positions);

/** @brief Writes the text as it is. */
void writeText(const std::filesystem::path& path, const std::string& text);

} // namespace pcl::sedr::sim
