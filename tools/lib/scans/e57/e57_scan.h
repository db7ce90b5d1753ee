// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "e57_pages.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr::tools {

/** @brief A value of every point and its encoding; each field has its own stream. */
struct E57Field {
  enum class Kind { Float, Double, Integer, Other };

  std::string name;         ///< in the XML, such as cartesianX
  Kind kind = Kind::Other;  ///< Other is not read
  unsigned bits = 0;        ///< per value; 0 if all are `minimum`
  std::int64_t minimum = 0; ///< value of the stored number 0
  double scale = 1;         ///< for integers
  double offset = 0;        ///< for integers
  double low = 0, high = 0; ///< range of values, scaled; 0, 0 if unknown
};

/** @brief Description of a scan in the XML. */
struct E57Scan {
  std::size_t number = 0; ///< from 1
  std::string name;       ///< may be empty
  std::uint64_t points = 0;
  std::uint64_t section = 0; ///< logical offset of its points
  bool has_pose = false;
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero(); ///< file's unit, metres
  std::vector<E57Field> fields; ///< in the order of their streams
  /// Minimum and maximum of red, green and blue; 0, 0 if unknown.
  std::vector<std::pair<double, double>> colour_limits;

  /** @brief Returns the number of the field called `name`, -1 if there is none. */
  int find(const std::string& name) const;

  /** @brief Returns "scan 2 ('kitchen')". */
  std::string title() const;
};

/** @brief A scan, or the reason why it cannot be read. */
struct E57Entry {
  E57Scan scan;
  std::string problem; ///< a sentence; empty if there is none
};

/** @brief Reads the scans listed in the XML of an E57 file. Throws ToolError if the XML
 * cannot be read; problems of a single scan are stored with it. */
std::vector<E57Entry> readE57Scans(const E57Pages& pages);

} // namespace pcl::sedr::tools
