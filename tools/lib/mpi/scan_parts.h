// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan_file.h"

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief A file of a scan, which may have several. */
struct ScanInput {
  std::string path;
  ScanHead head;
  std::size_t first = 0; ///< number of its first row in the whole scan
};

/** @brief A range of rows of a file. */
struct RowRange {
  std::string path;
  std::size_t begin = 0; ///< first row in the file
  std::size_t end = 0;   ///< one past the last
  std::size_t first = 0; ///< number of its first row in the whole scan

  std::size_t size() const { return end - begin; }
};

/** @brief Returns "rows 0 to 99 of 'a.pcd' and rows 0 to 9 of 'b.pcd'"; of more than
 * three ranges only the first two are named. */
std::string textOf(const std::vector<RowRange>& ranges);

/** @brief Finds the files of a scan, see scanFilesOf(), and reads their headers. Throws
 * ToolError if a file is missing or no scan, or a folder is empty. */
std::vector<ScanInput> findInputs(const std::vector<std::string>& paths,
                                  const ScanSettings& settings = {});

std::size_t rowsOf(const std::vector<ScanInput>& inputs);

/** @brief Returns the scanner positions of the whole scan, as
 * JointScan::positions(). */
ScanPositions positionsOf(const std::vector<ScanInput>& inputs,
                          const ScanSettings& settings);

/** @brief Distributes the rows to `ranks`, in order and as evenly as possible. A
 * file whose rows cannot be read separately goes to one rank, weighted by its
 * unpacked size. */
std::vector<std::vector<RowRange>> dealRows(const std::vector<ScanInput>& inputs,
                                            std::size_t ranks);

} // namespace pcl::sedr::tools
