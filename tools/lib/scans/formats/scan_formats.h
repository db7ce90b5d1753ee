// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bytes/input_file.h"
#include "point_reader.h"
#include "scan_settings.h"

#include <memory>
#include <optional>
#include <string>

namespace pcl::sedr::tools {

/** @brief What a file of any format holds. */
struct ScanContent {
  std::unique_ptr<const PointReader> points;
  std::uint64_t faces = 0;   ///< of a mesh, including strips of triangles
  bool may_be_local = false; ///< whether VIEWPOINT of a PCD of floats may be the origin
  std::optional<Eigen::Vector3d> viewpoint; ///< in the unit of the file, if known
  Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
  Origin counted_from; ///< what was subtracted when the file was written
};

using InputFilePtr = std::shared_ptr<const InputFile>;

/** @brief Opens a scan of any format, told by its content. Throws ToolError if the file
 * is no scan, invalid or cut off, has no points, or settings do not fit its format. */
ScanContent openScan(const std::string& path, const ScanSettings& settings);

bool looksLikePcd(const InputFile& file);
bool looksLikePly(const InputFile& file);
bool looksLikeE57(const InputFile& file);
bool looksLikeLas(const InputFile& file);

/** @brief Returns whether a file holds at least three numbers in one of its first
 * lines, and no byte that a text cannot have. */
bool looksLikeColumns(const InputFile& file);

/** @brief Opens a PCD 0.5 to 0.7, ascii, binary or binary_compressed. */
ScanContent openPcd(const InputFilePtr& file);

/** @brief Opens the vertices of a PLY, ascii or binary of either byte order. */
ScanContent openPly(const InputFilePtr& file);

/** @brief Opens a LAS 1.0 to 1.4 of the point formats 0 to 10: x, y, z, `intensity`,
 * and `rgb` if it has colours, of which the upper byte counts, or the lower one if
 * none of 10,000 points uses the upper. */
ScanContent openLas(const InputFilePtr& file);

/** @brief Opens columns of numbers. `columns` names them, separated by blanks or
 * commas; if empty, a line before the numbers does, such as "//X Y Z Intensity", or
 * else they are x y z, then intensity (4 columns), red green blue (6 columns, whole
 * numbers up to 255), or both (7 columns). */
ScanContent openText(const InputFilePtr& file, const std::string& columns);

/** @brief Opens the scans of an E57 file, or the one that the settings name, each
 * moved by its pose: x, y, z, then `intensity` and `rgb` if any scan has them. Points
 * marked as invalid, or as a direction only, are NaN. */
ScanContent openE57(const InputFilePtr& file, const ScanSettings& settings);

/** @brief Where the points of a file stand, records of one size one behind the other,
 * as its header tells. */
struct Records {
  std::string format; ///< in messages
  StoredRow row;
  std::size_t begin = 0; ///< byte of the first record
  std::uint64_t points = 0;
  std::uint64_t end = 0; ///< byte behind what may be points
  bool are_last = true;  ///< whether nothing else comes before `end`
  bool is_big_endian = false;
};

/** @brief The points of binary PCD and PLY and of LAS. */
class RecordReader : public PointReader {
public:
  /** @brief Throws ToolError if the header counts more points than there are, or fewer:
   * a whole number of records follows the last. Warns of other bytes there, unless they
   * are less than a record. */
  RecordReader(std::shared_ptr<const InputFile> file, const Records& records);

protected:
  void read(Chunk& chunk) const override;

private:
  std::shared_ptr<const InputFile> file_;
  std::size_t begin_;
  bool is_big_endian_;
};

} // namespace pcl::sedr::tools
