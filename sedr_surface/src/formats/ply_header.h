// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace pcl {
namespace sedr {
namespace ply {

/** @brief Number types of a PLY file. */
enum class Type { None, Int8, UInt8, Int16, UInt16, Int32, UInt32, Float, Double };

/** @brief A number, or a list of numbers, of every row of an element. */
struct Property {
  std::string name;
  Type type = Type::None;
  Type count_type = Type::None; ///< of a list
};

/** @brief A table of the file: vertices, faces, ... */
struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

/** @brief How numbers are written. */
enum class Encoding { Ascii, LittleEndian, BigEndian };

/** @brief What a PLY file says of its content. */
struct Header {
  Encoding encoding = Encoding::Ascii;
  std::vector<Element> elements;
  std::size_t size = 0; ///< bytes up to the first value
};

/** @brief Bytes of a number. */
std::size_t sizeOf(Type type);

/** @brief Reads the header of a PLY file.
 * @return an empty string or what is wrong with it, to stand behind the file's name */
std::string parseHeader(const std::string& content, Header& header);

} // namespace ply
} // namespace sedr
} // namespace pcl
