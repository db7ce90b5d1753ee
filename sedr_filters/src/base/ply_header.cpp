// SPDX-License-Identifier: BSD-3-Clause
#include "ply_header.h"

#include <pcl/PCLPointField.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace pcl::sedr {

namespace {

using Field = pcl::PCLPointField;

/** @brief Returns the type with a name in PLY; 0 if there is none. */
std::uint8_t
typeOf(const std::string& name)
{
  static const std::map<std::string, std::uint8_t> types{
      {"char", Field::INT8},      {"int8", Field::INT8},
      {"uchar", Field::UINT8},    {"uint8", Field::UINT8},
      {"short", Field::INT16},    {"int16", Field::INT16},
      {"ushort", Field::UINT16},  {"uint16", Field::UINT16},
      {"int", Field::INT32},      {"int32", Field::INT32},
      {"uint", Field::UINT32},    {"uint32", Field::UINT32},
      {"float", Field::FLOAT32},  {"float32", Field::FLOAT32},
      {"double", Field::FLOAT64}, {"float64", Field::FLOAT64}};
  const auto found = types.find(name);
  return found == types.end() ? std::uint8_t{0} : found->second;
}

std::string
quoted(const std::string& word)
{
  constexpr std::size_t most = 40;
  return "'" + word.substr(0, most) + (word.size() > most ? "...'" : "'");
}

std::string
takeProperty(std::istream& words, std::vector<PlyElement>& elements)
{
  PlyProperty property;
  std::string type;
  std::string count;
  words >> type;
  const bool is_list = type == "list";
  if (is_list)
    words >> count >> type;
  if (!(words >> property.name) || elements.empty())
    return "its header holds a property without an element, type or name";
  property.type = typeOf(type);
  property.count_type = is_list ? typeOf(count) : std::uint8_t{0};
  if (property.type == 0 || (is_list && property.count_type == 0))
    return "the type " + quoted(property.type == 0 ? type : count) +
           " of a property is unknown";
  if (property.count_type >= Field::FLOAT32)
    return "the list " + quoted(property.name) + " counts its values as " +
           quoted(count) + ", which is no whole number";
  elements.back().properties.push_back(property);
  return {};
}

} // namespace

bool
PlyElement::hasLists() const
{
  return std::any_of(properties.begin(), properties.end(),
                     [](const PlyProperty& p) { return p.count_type != 0; });
}

std::string
PlyHeader::take(std::string_view line)
{
  std::istringstream words{std::string(line)};
  std::string keyword;
  words >> keyword;
  if (keyword.empty() || keyword == "comment" || keyword == "obj_info")
    return {};
  if (keyword == "property")
    return takeProperty(words, elements);
  if (keyword == "element") {
    PlyElement element;
    std::string count;
    words >> element.name >> count;
    if (count.empty() || count.size() > 18 ||
        count.find_first_not_of("0123456789") != std::string::npos)
      return quoted(count) + " is no number of elements";
    element.count = std::stoull(count);
    elements.push_back(element);
    return {};
  }
  if (keyword == "format") {
    words >> format;
    return {};
  }
  is_complete = keyword == "end_header";
  if (!is_complete)
    return "its header holds a line that is none, before end_header";
  if (format != "ascii" && format != "binary_little_endian" &&
      format != "binary_big_endian")
    return "its format is " + quoted(format);
  return {};
}

} // namespace pcl::sedr
