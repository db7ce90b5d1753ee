// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pcl::sedr {

/** @brief A number, or a list of numbers, in every row of an element; types are
 * constants of PCLPointField. */
struct PlyProperty {
  std::string name;
  std::uint8_t type = 0;
  std::uint8_t count_type = 0; ///< of a list's length; 0: a number
};

/** @brief A table of a PLY: vertices, faces, ... */
struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  bool hasLists() const;
};

/** @brief The header of a PLY, read line by line. */
struct PlyHeader {
  std::string format; ///< ascii, binary_little_endian or binary_big_endian
  std::vector<PlyElement> elements;
  bool is_complete = false; ///< whether end_header was read

  /** @brief Reads a line, without its end.
   * @return what is wrong with it, to follow a colon; empty if nothing is */
  std::string take(std::string_view line);
};

} // namespace pcl::sedr
