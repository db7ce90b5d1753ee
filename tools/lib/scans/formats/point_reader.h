// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/base/field_access.h"
#include <pcl/PCLPointField.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <cstdint>
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

} // namespace pcl::sedr::tools
