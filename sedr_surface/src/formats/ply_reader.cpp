// SPDX-License-Identifier: BSD-3-Clause
#include "ply_reader.h"

#include "sedr_filters/src/base/field_access.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <sstream>
#include <utility>

namespace pcl::sedr {
namespace {

/** @brief A number, or a list of numbers, in every row of an element; types are
 * constants of PCLPointField. */
struct PlyProperty {
  std::string name;
  std::uint8_t type = 0;
  std::uint8_t count_type = 0; ///< type of a list's length; 0: not a list
};

/** @brief A table of the file: vertices, faces, ... */
struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;

  /** @brief Returns the column of a number or a list; -1 if there is none. */
  int column(std::initializer_list<const char*> names, bool is_list) const
  {
    for (std::size_t p = 0; p < properties.size(); ++p)
      for (const char* name : names)
        if (properties[p].name == name && (properties[p].count_type != 0) == is_list)
          return static_cast<int>(p);
    return -1;
  }
};

struct PlyHeader {
  std::string encoding;
  std::vector<PlyElement> elements;
};

/** @brief Returns the type with a name in PLY; 0 if there is none. */
std::uint8_t
typeOf(const std::string& name)
{
  using Field = pcl::PCLPointField;
  static const std::pair<const char*, std::uint8_t> types[] = {
      {"char", Field::INT8},      {"int8", Field::INT8},
      {"uchar", Field::UINT8},    {"uint8", Field::UINT8},
      {"short", Field::INT16},    {"int16", Field::INT16},
      {"ushort", Field::UINT16},  {"uint16", Field::UINT16},
      {"int", Field::INT32},      {"int32", Field::INT32},
      {"uint", Field::UINT32},    {"uint32", Field::UINT32},
      {"float", Field::FLOAT32},  {"float32", Field::FLOAT32},
      {"double", Field::FLOAT64}, {"float64", Field::FLOAT64}};
  for (const auto& [known, type] : types)
    if (name == known)
      return type;
  return 0;
}

/** @brief Reads a line of a header.
 * @return false if the line is malformed */
bool
readHeaderLine(const std::string& line, PlyHeader& header)
{
  std::istringstream words(line);
  std::string keyword;
  words >> keyword;
  if (keyword == "format")
    return !!(words >> header.encoding);
  if (keyword == "element") {
    PlyElement element;
    if (!(words >> element.name >> element.count))
      return false;
    header.elements.push_back(element);
  }
  else if (keyword == "property") {
    std::string type;
    PlyProperty property;
    words >> type;
    if (type == "list") {
      words >> type;
      property.count_type = typeOf(type);
      if (property.count_type == 0)
        return false;
      words >> type;
    }
    property.type = typeOf(type);
    if (!(words >> property.name) || property.type == 0 || header.elements.empty())
      return false;
    header.elements.back().properties.push_back(property);
  }
  return true;
}

/** @brief Reads a header and moves `at` behind it.
 * @return an empty string or an error message, to follow the file's name */
std::string
readHeader(const std::string& content, PlyHeader& header, std::size_t& at)
{
  for (std::size_t end; (end = content.find('\n', at)) != std::string::npos;) {
    std::string line = content.substr(at, end - at);
    line.erase(line.find_last_not_of(" \r") + 1);
    at = end + 1;
    if (!readHeaderLine(line, header))
      return "has a PLY header with the bad line '" + line + "'";
    if (line != "end_header")
      continue;
    for (const char* known : {"ascii", "binary_little_endian", "binary_big_endian"})
      if (header.encoding == known)
        return {};
    return "has the unknown PLY format '" + header.encoding + "'";
  }
  return "is truncated: its PLY header does not end";
}

/** @brief Values of a row. */
struct Row {
  std::vector<double> scalars;            ///< one per property; a list's length
  std::vector<std::vector<double>> lists; ///< one per property
};

/** @brief Reads successive rows from text or bytes. */
class RowReader {
public:
  RowReader(const std::string& content, std::size_t begin, const std::string& encoding)
      : at_(content.data() + begin)
      , last_(content.data() + content.size())
      , is_text_(encoding == "ascii")
      , is_swapped_(encoding == "binary_big_endian")
  {}

  bool read(const PlyElement& element, Row& row)
  {
    row.scalars.resize(element.properties.size());
    row.lists.resize(element.properties.size());
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const auto& [name, type, count_type] = element.properties[p];
      double& scalar = row.scalars[p];
      if (!readValue(count_type != 0 ? count_type : type, scalar))
        return false;
      if (count_type == 0)
        continue;
      if (!(scalar >= 0 && scalar < 1e6)) // no polygon has more corners
        return false;
      row.lists[p].resize(static_cast<std::size_t>(scalar));
      for (double& value : row.lists[p])
        if (!readValue(type, value))
          return false;
    }
    return true;
  }

private:
  bool readValue(std::uint8_t type, double& value)
  {
    if (is_text_) {
      while (at_ != last_ && std::strchr(" \t\r\n+", *at_) != nullptr)
        ++at_;
      const auto result = std::from_chars(at_, last_, value);
      at_ = result.ptr;
      return result.ec == std::errc();
    }
    const std::size_t size = fieldSize(type);
    if (static_cast<std::size_t>(last_ - at_) < size)
      return false;
    std::uint8_t bytes[sizeof(double)];
    std::memcpy(bytes, at_, size);
    at_ += size;
    if (is_swapped_)
      std::reverse(bytes, bytes + size);
    value = readField(bytes, type);
    return true;
  }

  const char* at_;
  const char* last_;
  bool is_text_;
  bool is_swapped_;
};

/** @brief Calls `see(row, i)` for all rows of an element, until it gives a reason not
 * to go on.
 * @return an error message, to follow the file's name, or an empty string */
template <typename SeeT>
std::string
forEachRow(RowReader& reader, const PlyElement& element, SeeT see)
{
  Row row;
  std::string reason;
  for (std::size_t i = 0; i < element.count && reason.empty(); ++i)
    reason = reader.read(element, row)
                 ? see(row, i)
                 : "is truncated or damaged: " + std::to_string(i) + " of " +
                       std::to_string(element.count) + " rows of '" + element.name +
                       "' can be read";
  return reason;
}

std::string
readVertices(RowReader& reader, const PlyElement& element, TriangleMesh& mesh)
{
  const int columns[3] = {element.column({"x"}, false), element.column({"y"}, false),
                          element.column({"z"}, false)};
  if (*std::min_element(columns, columns + 3) < 0)
    return "has vertices without x, y and z";
  return forEachRow(reader, element, [&](const Row& row, std::size_t) {
    Eigen::Vector3d& vertex = mesh.vertices.emplace_back();
    for (int k = 0; k < 3; ++k)
      vertex[k] = row.scalars[static_cast<std::size_t>(columns[k])];
    return std::string();
  });
}

std::string
readFaces(RowReader& reader, const PlyElement& element, TriangleMesh& mesh)
{
  const int corners = element.column({"vertex_indices", "vertex_index"}, true);
  // In the order of TriangleMesh::attributes().
  const int columns[] = {element.column({"label"}, false),
                         element.column({"room"}, false),
                         element.column({"element"}, false)};
  if (corners < 0)
    return "has faces without a list of vertex indices";
  std::vector<std::uint32_t> polygon;
  return forEachRow(reader, element, [&](const Row& row, std::size_t i) -> std::string {
    polygon.clear();
    for (const double index : row.lists[static_cast<std::size_t>(corners)]) {
      if (!(index >= 0 && index < static_cast<double>(mesh.vertices.size())))
        return "is no mesh: face " + std::to_string(i) +
               " uses a vertex out of range of the " +
               std::to_string(mesh.vertices.size()) + " vertices";
      polygon.push_back(static_cast<std::uint32_t>(index));
    }
    triangulatePolygon(mesh.vertices, polygon, mesh.triangles);
    const auto attributes = mesh.attributes();
    for (std::size_t k = 0; k < attributes.size(); ++k) {
      if (columns[k] < 0)
        continue;
      const double value = row.scalars[static_cast<std::size_t>(columns[k])];
      const bool is_number = value > 0 && value < 4294967296.;
      attributes[k]->resize(mesh.triangles.size(),
                            is_number ? static_cast<std::uint32_t>(value) : 0u);
    }
    return {};
  });
}

} // namespace

std::string
parsePly(const std::string& content, TriangleMesh& mesh)
{
  PlyHeader header;
  std::size_t at = 0;
  std::string reason = readHeader(content, header, at);
  RowReader reader(content, at, header.encoding);
  for (const PlyElement& element : header.elements) {
    if (!reason.empty())
      break;
    if (element.name == "tristrips")
      reason = "holds triangle strips, which are not read";
    else if (element.name == "vertex")
      reason = readVertices(reader, element, mesh);
    else if (element.name == "face")
      reason = readFaces(reader, element, mesh);
    else
      reason = forEachRow(reader, element,
                          [](const Row&, std::size_t) { return std::string(); });
  }
  return reason;
}

} // namespace pcl::sedr
