// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formats/point_reader.h"

namespace pcl::sedr::tools {

/** @brief Converts stored points to rows of a cloud: no padding, x, y and z in metres
 * as FLOAT32. Unit and origin are applied in double precision. */
class RowPlan {
public:
  /** @param unit metres per unit of the file
   * @param shift subtracted from coordinates, metres */
  RowPlan(const StoredRow& stored, double unit, const Eigen::Vector3d& shift);

  const std::vector<pcl::PCLPointField>& fields() const { return fields_; }
  std::size_t rowSize() const { return row_size_; }

  /** @brief Returns whether rows are as stored. */
  bool isPlain() const { return is_plain_; }

  void convert(const std::uint8_t* stored, std::size_t rows, std::uint8_t* to) const;

private:
  /** @brief What becomes a field or, of a joined colour, a byte of one. */
  struct Move {
    StoredField from;
    std::size_t to = 0;
    bool is_number = false; ///< converted to a float; else its bytes are copied
    double unit = 1;
    double shift = 0;
  };

  void addField(const std::string& name, std::uint8_t datatype, std::size_t count = 1);
  void addColour(const StoredRow& stored);

  /** @brief Writes a field as floats. */
  void convert(const Move& move,
               const std::uint8_t* stored,
               std::size_t rows,
               std::uint8_t* to) const;

  std::vector<pcl::PCLPointField> fields_;
  std::vector<Move> moves_;
  std::size_t stored_size_;
  std::size_t row_size_ = 0;
  std::ptrdiff_t opaque_ = -1; ///< offset of an alpha that is not stored
  bool is_plain_ = true;
};

} // namespace pcl::sedr::tools
