// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan_file.h"

#include <memory>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief The files that paths name, in their order; of a folder its .pcd, .ply, .e57,
 * .las and .laz files sorted by name. A folder without any is a ToolError. */
std::vector<std::string> scanFilesOf(const std::vector<std::string>& paths);

/** @brief Puts together where the rows of several files were scanned from: each file
 * tells that of its own, NaN where it does not. */
class JointPositions {
public:
  /** @brief Appends the rows of a file. */
  void add(const ScanFile& scan);

  /** @brief The positions of all rows that were added; empty if none is known. */
  ScanPositions get() const;

private:
  ScanPositions positions_;
  std::size_t rows_ = 0;
};

/** @brief Several files that are one scan: their rows one after the other, with all
 * fields where there is one file, else x, y and z. All are counted from the origin of
 * the first unless the settings give one. */
class JointScan : public RowSource {
public:
  /** @param paths files and folders, see scanFilesOf(); one at least */
  JointScan(const std::vector<std::string>& paths, const ScanSettings& settings);

  const std::vector<pcl::PCLPointField>& fields() const override { return fields_; }
  std::size_t rowSize() const override { return row_size_; }
  std::size_t size() const override { return size_; }
  void forEachPiece(const std::function<bool(const Piece&)>& see) const override;

  /** @brief What all coordinates are counted from. */
  const Origin& origin() const { return files_.front()->origin(); }

  /** @brief Where the rows were scanned from: by the file of positions that the
   * settings name, in the frame of the first file, or by what each file tells. */
  ScanPositions positions() const;

private:
  std::vector<std::unique_ptr<ScanFile>> files_;
  std::vector<pcl::PCLPointField> fields_;
  std::string positions_; ///< file of them, may be empty
  std::size_t row_size_ = 0;
  std::size_t size_ = 0;
};

} // namespace tools
} // namespace sedr
} // namespace pcl
