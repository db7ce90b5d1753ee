// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bytes/mapped_file.h"

#include <Eigen/Core>

#include <cstdint>
#include <string>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What the header of a LAS file says of its points. */
struct LasHeader {
  std::uint64_t begin = 0; ///< of the points, bytes
  std::uint64_t points = 0;
  std::size_t record = 0;        ///< bytes a point
  std::size_t colour_offset = 0; ///< of red, green and blue in a record; 0: none
  bool is_compressed = false;    ///< LAZ: a record has these bytes once it is unpacked
  Eigen::Vector3d scale;         ///< of the whole numbers that stand for coordinates
  Eigen::Vector3d shift;         ///< added to them, then
};

bool looksLikeLas(const MappedFile& file);

/** @brief Reads the header of LAS 1.0 to 1.4 with points of the formats 0 to 10, and
 * checks it against the size of the file. What is amiss is a ToolError. */
LasHeader readLasHeader(const MappedFile& file, const std::string& path);

} // namespace tools
} // namespace sedr
} // namespace pcl
