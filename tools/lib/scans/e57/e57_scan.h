// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "e57_pages.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief One value of every point, and how it is stored: each field has a stream of
 * its own. */
struct E57Field {
  enum class Kind { Float, Double, Integer, Other };

  std::string name;         ///< of the XML, such as cartesianX
  Kind kind = Kind::Other;  ///< Other is not read
  unsigned bits = 0;        ///< of a value; 0 where all are `minimum`
  std::int64_t minimum = 0; ///< what the stored number 0 stands for
  double scale = 1;         ///< of integers
  double offset = 0;        ///< likewise
  double low = 0, high = 0; ///< the range it may take, scaled; 0, 0 if not told
};

/** @brief What the XML says of a scan. */
struct E57Scan {
  std::size_t number = 0; ///< from 1
  std::string name;       ///< may be empty
  std::uint64_t points = 0;
  std::uint64_t section = 0; ///< logical offset of its points
  bool has_pose = false;
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero(); ///< file's unit, metres
  std::vector<E57Field> fields; ///< in the order of their streams
  /// Lowest and highest value of red, green and blue; 0, 0 if not told.
  std::vector<std::pair<double, double>> colour_limits;

  /** @brief Number of the field called `name`, -1 if there is none. */
  int find(const std::string& name) const;

  /** @brief "scan 2 ('kitchen')" */
  std::string title() const;
};

/** @brief A scan, or why it cannot be read. */
struct E57Entry {
  E57Scan scan;
  std::string problem; ///< a sentence; empty if there is none
};

/** @brief The scans that the XML of an E57 file names. An XML that cannot be read is a
 * ToolError; what is amiss with one scan is told with it. */
std::vector<E57Entry> readE57Scans(const E57Pages& pages);

} // namespace tools
} // namespace sedr
} // namespace pcl
