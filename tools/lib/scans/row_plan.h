// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointField.h>
#include <pcl/sedr_filters/scan_frame.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::sedr::tools {

/** @brief Converts rows of a file to output rows: no padding, x, y and z as metres,
 * FLOAT32 or FLOAT64. Scale and origin are applied in double precision. */
class RowPlan {
public:
  /** @param raw fields as in the file, with offsets
   * @param raw_size bytes per row in the file
   * @param unit metres per unit
   * @param shift subtracted from coordinates, metres
   * @param datatype of x, y and z unless they stay as they are, floats in metres
   * @param path for the ToolError thrown if rows would be too long */
  RowPlan(const std::vector<pcl::PCLPointField>& raw,
          std::size_t raw_size,
          double unit,
          const Eigen::Vector3d& shift,
          std::uint8_t datatype,
          const std::string& path);

  const std::vector<pcl::PCLPointField>& fields() const { return fields_; }
  std::size_t rowSize() const { return row_size_; }

  /** @brief Returns whether rows stay unchanged. */
  bool isPlain() const { return is_plain_; }

  void bring(const std::uint8_t* raw, std::size_t rows, std::uint8_t* to) const;

private:
  /** @brief Conversion of a field. */
  struct Move {
    std::size_t from = 0;
    std::size_t to = 0;
    std::size_t size = 0;      ///< bytes to copy
    bool converts = false;     ///< to metres
    std::uint8_t datatype = 0; ///< in the file
    double shift = 0;          ///< metres
  };

  /** @brief Writes the field of `move` as metres of type OutT. */
  template <typename OutT>
  void convert(const Move& move,
               const std::uint8_t* raw,
               std::size_t rows,
               std::uint8_t* to) const;

  std::vector<pcl::PCLPointField> fields_;
  std::vector<Move> moves_;
  std::size_t raw_size_;
  std::size_t row_size_ = 0;
  std::uint8_t datatype_; ///< of what is converted
  double unit_;
  bool is_plain_ = true;
};

} // namespace pcl::sedr::tools
