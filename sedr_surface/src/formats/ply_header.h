// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::sedr::ply {

/** @brief Number types of a PLY file. */
enum class Type { None, Int8, UInt8, Int16, UInt16, Int32, UInt32, Float, Double };

/** @brief A number, or a list of numbers, in every row of an element. */
struct Property {
  std::string name;
  Type type = Type::None;
  Type count_type = Type::None; ///< type of a list's length; None: not a list
};

/** @brief A table of the file: vertices, faces, ... */
struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

/** @brief Encoding of numbers. */
enum class Encoding { Ascii, LittleEndian, BigEndian };

/** @brief Content of a PLY header. */
struct Header {
  Encoding encoding = Encoding::Ascii;
  std::vector<Element> elements;
  std::size_t size = 0; ///< bytes before the first value
};

/** @brief Returns the number of bytes of a type. */
std::size_t sizeOf(Type type);

/** @brief Reads the header of a PLY file.
 * @return an empty string or an error message, to follow the file's name */
std::string parseHeader(const std::string& content, Header& header);

} // namespace pcl::sedr::ply
