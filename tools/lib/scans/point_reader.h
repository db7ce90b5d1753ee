// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointField.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Scanner position of a range of points. */
struct ScanStation {
  std::size_t first_row = 0; ///< the range ends at the next station
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< in the unit of the file
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  std::string name; ///< may be empty
};

/** @brief Interface of files whose rows must be decoded: x, y and z as FLOAT64 in the
 * unit and frame of the file, then further fields, without padding. Invalid points are
 * NaN. */
class PointReader {
public:
  virtual ~PointReader() = default;

  virtual const std::vector<pcl::PCLPointField>& fields() const = 0;

  /** @brief Returns the total number of rows. */
  virtual std::size_t size() const = 0;

  /** @brief Decodes `size` rows from `first` on; thread-safe. Throws ToolError if
   * damaged. */
  virtual void read(std::size_t first, std::size_t size, std::uint8_t* rows) const = 0;

  /** @brief Returns the approximate byte offset of a row; size() gives the end. */
  virtual std::size_t placeOf(std::size_t row) const = 0;

  /** @brief Returns the scanner positions in the order of rows; empty if unknown for
   * any. */
  virtual std::vector<ScanStation> stations() const { return {}; }
};

/** @brief Returns the fields of a PointReader: x, y and z, then some of FLOAT32. */
inline std::vector<pcl::PCLPointField>
decodedFields(const std::vector<std::string>& more)
{
  std::vector<pcl::PCLPointField> fields;
  const auto add = [&](const std::string& name, std::uint8_t datatype) {
    pcl::PCLPointField field;
    field.name = name;
    field.datatype = datatype;
    field.count = 1;
    fields.push_back(field);
  };
  for (const char* name : {"x", "y", "z"})
    add(name, pcl::PCLPointField::FLOAT64);
  for (const auto& name : more)
    add(name, pcl::PCLPointField::FLOAT32);
  return fields;
}

} // namespace pcl::sedr::tools
