// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan_file.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Returns the files named by paths, in order. A folder stands for its .pcd,
 * .ply, .e57, .las, .xyz and .pts files sorted by name, without those that a
 * report.json in it lists as results. Throws ToolError for a folder without any. */
std::vector<std::string> scanFilesOf(const std::vector<std::string>& paths);

/** @brief Several files as one scan: their rows in sequence, with all fields of a
 * single file, else x, y and z. All coordinates use the origin of the first file unless
 * the settings give one. */
class JointScan : public RowSource {
public:
  /** @param paths files and folders, see scanFilesOf(); at least one */
  JointScan(const std::vector<std::string>& paths, const ScanSettings& settings);

  const std::vector<pcl::PCLPointField>& fields() const override { return fields_; }
  std::size_t rowSize() const override { return row_size_; }
  std::size_t size() const override { return size_; }
  void forEachPiece(const std::function<bool(const Piece&)>& see) const override
  {
    forEachPiece(0, size_, see);
  }

  /** @brief As above for the rows from `begin` to `end`. */
  void forEachPiece(std::size_t begin,
                    std::size_t end,
                    const std::function<bool(const Piece&)>& see) const;

  /** @brief Returns the files, whose rows follow each other. */
  const std::vector<std::unique_ptr<ScanFile>>& files() const { return files_; }

  /** @brief Returns whether any file has colours. */
  bool hasColours() const
  {
    return std::any_of(files_.begin(), files_.end(),
                       [](const auto& file) { return file->colour(); });
  }

  /** @brief Returns the origin of all coordinates. */
  const Origin& origin() const { return files_.front()->origin(); }

  /** @brief Returns the scanner position of each row: from the settings' file of
   * positions, in the frame of the first file, or else from each file. */
  ScanPositions positions() const;

private:
  std::vector<std::unique_ptr<ScanFile>> files_;
  std::vector<pcl::PCLPointField> fields_;
  std::string positions_; ///< file, may be empty
  std::size_t row_size_ = 0;
  std::size_t size_ = 0;
};

} // namespace pcl::sedr::tools
