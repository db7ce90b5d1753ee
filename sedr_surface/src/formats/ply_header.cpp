// SPDX-License-Identifier: BSD-3-Clause
#include "ply_header.h"

#include <sstream>
#include <utility>

namespace pcl::sedr::ply {
namespace {

Type
typeOf(const std::string& name)
{
  static const std::pair<const char*, Type> names[] = {
      {"char", Type::Int8},     {"int8", Type::Int8},     {"uchar", Type::UInt8},
      {"uint8", Type::UInt8},   {"short", Type::Int16},   {"int16", Type::Int16},
      {"ushort", Type::UInt16}, {"uint16", Type::UInt16}, {"int", Type::Int32},
      {"int32", Type::Int32},   {"uint", Type::UInt32},   {"uint32", Type::UInt32},
      {"float", Type::Float},   {"float32", Type::Float}, {"double", Type::Double},
      {"float64", Type::Double}};
  for (const auto& entry : names)
    if (name == entry.first)
      return entry.second;
  return Type::None;
}

std::string
parseHeaderLine(const std::string& line, Header& header)
{
  std::istringstream words(line);
  std::string keyword;
  words >> keyword;
  if (keyword == "format") {
    std::string encoding;
    words >> encoding;
    if (encoding == "binary_little_endian")
      header.encoding = Encoding::LittleEndian;
    else if (encoding == "binary_big_endian")
      header.encoding = Encoding::BigEndian;
    else if (encoding != "ascii")
      return "has the unknown PLY format '" + encoding + "'";
  }
  else if (keyword == "element") {
    Element element;
    if (!(words >> element.name >> element.count))
      return "has a PLY header with the bad line '" + line + "'";
    header.elements.push_back(element);
  }
  else if (keyword == "property") {
    std::string type;
    Property property;
    words >> type;
    if (type == "list") {
      words >> type;
      property.count_type = typeOf(type);
      if (property.count_type == Type::None)
        return "has a PLY header with the bad line '" + line + "'";
      words >> type;
    }
    property.type = typeOf(type);
    if (!(words >> property.name) || property.type == Type::None ||
        header.elements.empty())
      return "has a PLY header with the bad line '" + line + "'";
    header.elements.back().properties.push_back(property);
  }
  return {};
}

} // namespace

std::size_t
sizeOf(Type type)
{
  switch (type) {
  case Type::Int8:
  case Type::UInt8:
    return 1;
  case Type::Int16:
  case Type::UInt16:
    return 2;
  case Type::Double:
    return 8;
  default:
    return 4;
  }
}

std::string
parseHeader(const std::string& content, Header& header)
{
  std::size_t begin = 0;
  while (begin < content.size()) {
    const std::size_t end = content.find('\n', begin);
    if (end == std::string::npos)
      break;
    std::string line = content.substr(begin, end - begin);
    while (!line.empty() && (line.back() == '\r' || line.back() == ' '))
      line.pop_back();
    begin = end + 1;
    if (line == "end_header") {
      header.size = begin;
      return {};
    }
    const std::string reason = parseHeaderLine(line, header);
    if (!reason.empty())
      return reason;
  }
  return "is truncated: its PLY header does not end";
}

} // namespace pcl::sedr::ply
