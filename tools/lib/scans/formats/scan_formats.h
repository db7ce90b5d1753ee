// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bytes/input_file.h"
#include "scan_settings.h"
#include "sedr_filters/src/base/field_access.h"

#include <Eigen/Geometry>
#include <pcl/PCLPointField.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief A field of a stored point; its value is the stored number * scale + shift. */
struct StoredField : pcl::PCLPointField {
  double scale = 1;
  double shift = 0;
  bool becomes_float = false; ///< whether it is given as FLOAT32, whatever it is here

  double valueIn(const std::uint8_t* row) const
  {
    return readField(row + offset, datatype) * scale + shift;
  }
};

/** @brief The layout of a stored point. */
struct StoredRow {
  std::vector<StoredField> fields;
  std::size_t size = 0; ///< bytes
  /// Whether bytes called red, green and blue, perhaps alpha, become `rgb` or `rgba`.
  bool joins_colours = false;

  /** @brief Appends a field behind the others. */
  StoredField&
  add(const std::string& name, std::uint8_t datatype, std::size_t count = 1)
  {
    StoredField field;
    field.name = name;
    field.datatype = datatype;
    field.offset = static_cast<pcl::uindex_t>(size);
    field.count = static_cast<pcl::uindex_t>(count);
    fields.push_back(field);
    size += fieldSize(datatype) * count;
    return fields.back();
  }

  const StoredField* find(const std::string& name) const
  {
    const auto it = std::find_if(fields.begin(), fields.end(),
                                 [&](const auto& field) { return field.name == name; });
    return it == fields.end() ? nullptr : &*it;
  }
};

/** @brief Consecutive points of a file, as stored but in the machine's byte order. */
struct Chunk {
  std::vector<std::uint8_t> rows;
  std::size_t first = 0; ///< number of the first point in the file
  std::size_t size = 0;  ///< number of points
};

/** @brief Where the scanner stood for a range of points. */
struct ScanStation {
  std::size_t first_row = 0; ///< the range ends at the next station
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< in the unit of the file
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
};

/** @brief The points of a file of some format. */
class PointReader {
public:
  virtual ~PointReader() = default;

  const StoredRow& row() const { return row_; }

  /** @brief Returns the number of points. */
  std::size_t size() const { return size_; }

  /** @brief Replaces a chunk by the points behind it, at least one and at most `most`;
   * there must be any. A default chunk stands before the first point, one of no points
   * before `first`. Thread-safe. Throws ToolError if the file is damaged. */
  void next(Chunk& chunk, std::size_t most) const
  {
    chunk.first += chunk.size;
    chunk.size = std::min(most, size_ - chunk.first);
    read(chunk);
  }

  /** @brief Returns the scanner positions in the order of points; empty if any is
   * unknown. */
  virtual std::vector<ScanStation> stations() const { return {}; }

protected:
  /** @brief Fills the rows of a chunk from its `first` and `size`, which may become
   * less. */
  virtual void read(Chunk& chunk) const = 0;

  StoredRow row_;
  std::size_t size_ = 0;
};

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
