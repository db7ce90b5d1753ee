// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "las_header.h"

#include <pcl/PCLPointField.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::sedr::tools {

/** @brief The used parts of a LAS or LAZ point. */
struct LasPoint {
  std::array<std::int32_t, 3> whole{}; ///< integer x, y and z
  std::uint16_t intensity = 0;
  std::array<std::uint16_t, 3> colour{}; ///< red, green, blue
};

/** @brief Converts points of LAS or LAZ to rows: x, y, z, `intensity`, and `rgb` if the
 * format has colours. Colours of 16 bits become 8 bits. Some programs write 8-bit
 * values; these are assumed if all inspected ones are below 256. */
class LasRows {
public:
  explicit LasRows(const LasHeader& header);

  const std::vector<pcl::PCLPointField>& fields() const { return fields_; }

  /** @brief Inspects the colour of one of the points to convert. */
  void lookAt(const LasPoint& point);

  /** @brief Writes a row.
   * @return the position of the next one */
  std::uint8_t* write(const LasPoint& point, std::uint8_t* row) const;

private:
  Eigen::Vector3d scale_;
  Eigen::Vector3d shift_;
  bool has_colour_;
  std::vector<pcl::PCLPointField> fields_;
  unsigned colour_shift_ = 0; ///< bits
};

} // namespace pcl::sedr::tools
