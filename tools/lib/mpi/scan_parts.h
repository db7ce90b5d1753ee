// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan_file.h"

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief A file of a scan that may have several. */
struct ScanInput {
  std::string path;
  ScanHead head;
  std::size_t first = 0; ///< number of its first row in the whole scan
};

/** @brief Some rows of a file. */
struct RowRange {
  std::string path;
  std::size_t begin = 0; ///< first of them in the file
  std::size_t end = 0;   ///< one past the last
  std::size_t first = 0; ///< number of the first of them in the whole scan

  std::size_t size() const { return end - begin; }
};

/** @brief "rows 0 to 99 of 'a.pcd' and rows 0 to 9 of 'b.pcd'"; of more than three only
 * the first two are named. */
std::string textOf(const std::vector<RowRange>& ranges);

/** @brief The files of a scan, see scanFilesOf(); their heads are read. What is
 * missing, no scan, or a folder without any is a ToolError. */
std::vector<ScanInput> findInputs(const std::vector<std::string>& paths,
                                  const ScanSettings& settings = {});

std::size_t rowsOf(const std::vector<ScanInput>& inputs);

/** @brief Where the rows of the whole scan were taken from, as JointScan::positions()
 * tells it. */
ScanPositions positionsOf(const std::vector<ScanInput>& inputs,
                          const ScanSettings& settings);

/** @brief Deals the rows out to `ranks`, in their order and as evenly as can be: a file
 * whose rows cannot be had one without the others goes to one rank, with the size of
 * what that has to unpack. */
std::vector<std::vector<RowRange>> dealRows(const std::vector<ScanInput>& inputs,
                                            std::size_t ranks);

} // namespace tools
} // namespace sedr
} // namespace pcl
