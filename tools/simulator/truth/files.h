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

/** @file Binary PCD and PLY, and text, each by tools::writeWhole(): completely or not
 * at all. */

namespace pcl::sedr::sim {

/** @brief Writes x y z (float32) label room (uint32) as an unorganised binary PCD. */
void writePcd(const std::filesystem::path& path, const std::vector<ScanPoint>& points);

/** @brief A point of a building file. */
struct LabelledPoint {
  float x;
  float y;
  float z;
  std::uint32_t label;
};

using PointSink = std::function<void(const LabelledPoint&)>;

/** @brief Streams @p count points to an unorganised binary PCD of x y z (float32) and
 * label (uint32); @p make passes them to its sink. */
void writePcdStream(const std::filesystem::path& path,
                    std::size_t count,
                    const std::function<void(const PointSink&)>& make);

/** @brief Writes the mesh, moved by @p placement, as a binary PLY.
 *
 * Vertices are float32; every face has the int properties label and room.
 */
void writePly(const std::filesystem::path& path,
              const Mesh& mesh,
              const Placement& placement);

/** @brief Writes a line for each position: x y z in metres and its number of points,
 * which are in the same order in the scan. */
void writePositions(const std::filesystem::path& path,
                    const std::vector<ScanPosition>& positions);

/** @brief Writes the text unchanged. */
void writeText(const std::filesystem::path& path, const std::string& text);

} // namespace pcl::sedr::sim
