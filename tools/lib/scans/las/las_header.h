// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bytes/mapped_file.h"

#include <Eigen/Core>

#include <cstdint>
#include <string>

namespace pcl::sedr::tools {

/** @brief Description of the points in a LAS header. */
struct LasHeader {
  std::uint64_t begin = 0; ///< first byte of the points
  std::uint64_t points = 0;
  std::size_t record = 0;        ///< bytes per point
  std::size_t colour_offset = 0; ///< of red, green and blue in a record; 0: none
  bool is_compressed = false;    ///< LAZ: `record` is the unpacked size
  Eigen::Vector3d scale;         ///< of integer coordinates
  Eigen::Vector3d shift;         ///< added to scaled coordinates
};

bool looksLikeLas(const MappedFile& file);

/** @brief Reads the header of LAS 1.0 to 1.4 with point formats 0 to 10, and checks it
 * against the file size. Throws ToolError on failure. */
LasHeader readLasHeader(const MappedFile& file, const std::string& path);

} // namespace pcl::sedr::tools
