// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "las_header.h"

#include <pcl/PCLPointField.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief What is kept of a point of LAS or LAZ. */
struct LasPoint {
  std::array<std::int32_t, 3> whole{}; ///< stand for x, y and z
  std::uint16_t intensity = 0;
  std::array<std::uint16_t, 3> colour{}; ///< red, green, blue
};

/** @brief Makes rows of the points of LAS or LAZ: x, y, z, `intensity`, and `rgb` where
 * the format has colours. Colours of 16 bits become 8, unless all that were looked at
 * are below 256, as some programs write them. */
class LasRows {
public:
  explicit LasRows(const LasHeader& header);

  const std::vector<pcl::PCLPointField>& fields() const { return fields_; }

  /** @brief Looks at the colour of one of the points that rows will be made of. */
  void lookAt(const LasPoint& point);

  /** @brief Writes a row.
   * @return where the next one begins */
  std::uint8_t* write(const LasPoint& point, std::uint8_t* row) const;

private:
  Eigen::Vector3d scale_;
  Eigen::Vector3d shift_;
  bool has_colour_;
  std::vector<pcl::PCLPointField> fields_;
  unsigned colour_shift_ = 0; ///< bits
};

} // namespace tools
} // namespace sedr
} // namespace pcl
