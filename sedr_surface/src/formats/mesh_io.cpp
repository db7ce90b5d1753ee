// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_surface/triangle_mesh.h>

#include "sedr_filters/src/base/field_access.h"
#include "sedr_filters/src/base/ply_header.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

namespace pcl::sedr {
namespace {

/** @brief Returns the column of a number or a list; -1 if there is none. */
int
columnOf(const PlyElement& element,
         std::initializer_list<const char*> names,
         bool is_list = false)
{
  for (std::size_t p = 0; p < element.properties.size(); ++p)
    for (const char* name : names)
      if (element.properties[p].name == name &&
          (element.properties[p].count_type != 0) == is_list)
        return static_cast<int>(p);
  return -1;
}

/** @brief Reads a header and moves `at` behind it.
 * @return an empty string or an error message, to follow the file's name */
std::string
readHeader(const std::string& content, PlyHeader& header, std::size_t& at)
{
  at = content.find('\n') + 1; // behind "ply"
  for (std::size_t end; (end = content.find('\n', at)) != std::string::npos;) {
    const std::string reason =
        header.take(std::string_view(content).substr(at, end - at));
    at = end + 1;
    if (!reason.empty())
      return "is no PLY that can be read: " + reason;
    if (header.is_complete)
      return {};
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
      const auto& [unused, type, count_type] = element.properties[p];
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
  const int columns[3] = {columnOf(element, {"x"}), columnOf(element, {"y"}),
                          columnOf(element, {"z"})};
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
  const int corners = columnOf(element, {"vertex_indices", "vertex_index"}, true);
  // In the order of TriangleMesh::attributes().
  const int columns[] = {columnOf(element, {"label"}), columnOf(element, {"room"}),
                         columnOf(element, {"element"})};
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

/** @brief Reads the content of a PLY file into `mesh`.
 * @return an empty string or an error message, to follow the file's name */
std::string
parsePly(const std::string& content, TriangleMesh& mesh)
{
  PlyHeader header;
  std::size_t at = 0;
  std::string reason = readHeader(content, header, at);
  RowReader reader(content, at, header.format);
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

std::string
inLine(std::size_t number)
{
  return " in line " + std::to_string(number);
}

/** @brief As parsePly(), for an OBJ file. */
std::string
parseObj(const std::string& content, TriangleMesh& mesh)
{
  std::istringstream lines(content);
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      Eigen::Vector3d vertex;
      if (!(words >> vertex.x() >> vertex.y() >> vertex.z()))
        return "has a vertex without three coordinates" + inLine(number);
      mesh.vertices.push_back(vertex);
    }
    else if (word == "f") {
      std::vector<std::uint32_t> polygon;
      while (words >> word) {
        // "7", "7/1/2" or, for the last vertex, "-1"
        const auto count = static_cast<std::int64_t>(mesh.vertices.size());
        const std::int64_t told = std::strtoll(word.c_str(), nullptr, 10);
        const std::int64_t index = told > 0 ? told - 1 : count + told;
        if (index < 0 || index >= count)
          return "has a face with the bad vertex '" + word + "'" + inLine(number);
        polygon.push_back(static_cast<std::uint32_t>(index));
      }
      if (polygon.size() < 3)
        return "has a face with fewer than three vertices" + inLine(number);
      triangulatePolygon(mesh.vertices, polygon, mesh.triangles);
    }
  }
  return {};
}

/** @brief Reads a mesh from the content of a file.
 * @return an empty string or an error message, to follow the file's name */
std::string
parse(const std::string& content, TriangleMesh& mesh)
{
  if (content.empty())
    return "is empty";
  std::string reason;
  if (content.compare(0, 4, "ply\n") == 0 || content.compare(0, 4, "ply\r") == 0)
    reason = parsePly(content, mesh);
  else if (reason = parseObj(content, mesh); mesh.vertices.empty())
    reason = "is neither a PLY nor an OBJ file";
  if (!reason.empty())
    return reason;
  if (mesh.empty())
    return "is no mesh: it holds " + std::to_string(mesh.vertices.size()) +
           " vertices and no triangles";
  reason = mesh.problem();
  return reason.empty() ? reason : "is no mesh: " + reason;
}

} // namespace

std::string
loadMesh(const std::string& path, TriangleMesh& mesh)
{
  mesh = TriangleMesh();
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    return path + " is a folder, not a mesh";
  std::ifstream file(path, std::ios::binary);
  if (!file)
    return path + " cannot be opened";
  const std::string content((std::istreambuf_iterator<char>(file)),
                            std::istreambuf_iterator<char>());
  const std::string reason = parse(content, mesh);
  if (reason.empty())
    return {};
  mesh = TriangleMesh();
  return path + " " + reason;
}

} // namespace pcl::sedr
