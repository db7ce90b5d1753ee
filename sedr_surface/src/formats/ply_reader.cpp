// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_parsers.h"
#include "ply_header.h"

#include <algorithm>
#include <charconv>
#include <cstring>

namespace pcl::sedr {
namespace {

using namespace ply;

// Reads successive numbers from text or bytes.
class ValueReader {
public:
  ValueReader(const char* first, const char* last, Encoding encoding)
      : at_(first)
      , last_(last)
      , encoding_(encoding)
  {}

  bool read(Type type, double& value)
  {
    return encoding_ == Encoding::Ascii ? readText(value) : readBytes(type, value);
  }

private:
  bool readText(double& value)
  {
    while (at_ != last_ && std::strchr(" \t\r\n", *at_) != nullptr)
      ++at_;
    if (at_ != last_ && *at_ == '+')
      ++at_;
    const auto result = std::from_chars(at_, last_, value);
    at_ = result.ptr;
    return result.ec == std::errc();
  }

  template <typename T>
  static double as(const char* bytes)
  {
    T value = 0;
    std::memcpy(&value, bytes, sizeof(value));
    return static_cast<double>(value);
  }

  bool readBytes(Type type, double& value)
  {
    const std::size_t size = sizeOf(type);
    if (static_cast<std::size_t>(last_ - at_) < size)
      return false;
    char bytes[8];
    std::copy(at_, at_ + size, bytes);
    at_ += size;
    if (encoding_ == Encoding::BigEndian)
      std::reverse(bytes, bytes + size);
    value = decode(type, bytes);
    return true;
  }

  static double decode(Type type, const char* bytes)
  {
    switch (type) {
    case Type::Int8:
      return as<std::int8_t>(bytes);
    case Type::UInt8:
      return as<std::uint8_t>(bytes);
    case Type::Int16:
      return as<std::int16_t>(bytes);
    case Type::UInt16:
      return as<std::uint16_t>(bytes);
    case Type::Int32:
      return as<std::int32_t>(bytes);
    case Type::UInt32:
      return as<std::uint32_t>(bytes);
    case Type::Float:
      return as<float>(bytes);
    default:
      return as<double>(bytes);
    }
  }

  const char* at_;
  const char* last_;
  Encoding encoding_;
};

// Values of a row.
struct Row {
  std::vector<double> scalars;            ///< one per property; a list's length
  std::vector<std::vector<double>> lists; ///< one per property
};

bool
readRow(ValueReader& reader, const Element& element, Row& row)
{
  row.scalars.resize(element.properties.size());
  row.lists.resize(element.properties.size());
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const Property& property = element.properties[p];
    const bool is_list = property.count_type != Type::None;
    if (!reader.read(is_list ? property.count_type : property.type, row.scalars[p]))
      return false;
    if (!is_list)
      continue;
    if (!(row.scalars[p] >= 0 && row.scalars[p] < 1e6)) // no polygon has more corners
      return false;
    row.lists[p].resize(static_cast<std::size_t>(row.scalars[p]));
    for (double& value : row.lists[p])
      if (!reader.read(property.type, value))
        return false;
  }
  return true;
}

int
findProperty(const Element& element,
             std::initializer_list<const char*> names,
             bool list)
{
  for (std::size_t p = 0; p < element.properties.size(); ++p)
    for (const char* name : names)
      if (element.properties[p].name == name &&
          (element.properties[p].count_type != Type::None) == list)
        return static_cast<int>(p);
  return -1;
}

std::string
truncated(const Element& element, std::size_t row)
{
  return "is truncated or damaged: " + std::to_string(row) + " of " +
         std::to_string(element.count) + " rows of '" + element.name + "' can be read";
}

std::string
readVertices(ValueReader& reader, const Element& element, TriangleMesh& mesh)
{
  const int columns[3] = {findProperty(element, {"x"}, false),
                          findProperty(element, {"y"}, false),
                          findProperty(element, {"z"}, false)};
  if (columns[0] < 0 || columns[1] < 0 || columns[2] < 0)
    return "has vertices without x, y and z";
  Row row;
  for (std::size_t i = 0; i < element.count; ++i) {
    if (!readRow(reader, element, row))
      return truncated(element, i);
    Eigen::Vector3d vertex;
    for (int k = 0; k < 3; ++k)
      vertex[k] = row.scalars[static_cast<std::size_t>(columns[k])];
    mesh.vertices.push_back(vertex);
  }
  return {};
}

std::string
readFaces(ValueReader& reader, const Element& element, TriangleMesh& mesh)
{
  const int corners = findProperty(element, {"vertex_indices", "vertex_index"}, true);
  // In the order of TriangleMesh::attributes().
  const int columns[] = {findProperty(element, {"label"}, false),
                         findProperty(element, {"room"}, false),
                         findProperty(element, {"element"}, false)};
  if (corners < 0)
    return "has faces without a list of vertex indices";
  Row row;
  std::vector<std::uint32_t> polygon;
  for (std::size_t i = 0; i < element.count; ++i) {
    if (!readRow(reader, element, row))
      return truncated(element, i);
    polygon.clear();
    for (const double index : row.lists[static_cast<std::size_t>(corners)]) {
      if (!(index >= 0 && index < static_cast<double>(mesh.vertices.size())))
        return "is no mesh: face " + std::to_string(i) +
               " uses a vertex out of range of the " +
               std::to_string(mesh.vertices.size()) + " vertices";
      polygon.push_back(static_cast<std::uint32_t>(index));
    }
    triangulatePolygon(mesh.vertices, polygon, mesh.triangles);
    const auto attribute = [&](int column) {
      const double value = row.scalars[static_cast<std::size_t>(column)];
      return value > 0 && value < 4294967296. ? static_cast<std::uint32_t>(value) : 0u;
    };
    const auto attributes = mesh.attributes();
    for (std::size_t k = 0; k < attributes.size(); ++k)
      if (columns[k] >= 0)
        attributes[k]->resize(mesh.triangles.size(), attribute(columns[k]));
  }
  return {};
}

std::string
skipRows(ValueReader& reader, const Element& element)
{
  Row row;
  for (std::size_t i = 0; i < element.count; ++i)
    if (!readRow(reader, element, row))
      return truncated(element, i);
  return {};
}

} // namespace

std::string
parsePly(const std::string& content, TriangleMesh& mesh)
{
  ply::Header header;
  std::string reason = ply::parseHeader(content, header);
  ValueReader reader(content.data() + header.size, content.data() + content.size(),
                     header.encoding);
  for (const ply::Element& element : header.elements) {
    if (!reason.empty())
      break;
    if (element.name == "tristrips")
      reason = "holds triangle strips, which are not read";
    else if (element.name == "vertex")
      reason = readVertices(reader, element, mesh);
    else if (element.name == "face")
      reason = readFaces(reader, element, mesh);
    else
      reason = skipRows(reader, element);
  }
  return reason;
}

} // namespace pcl::sedr
