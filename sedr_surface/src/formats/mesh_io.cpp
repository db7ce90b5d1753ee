// SPDX-License-Identifier: BSD-3-Clause
#include "append_bytes.h"
#include "ply_reader.h"
#include "sedr_filters/src/base/labels.h"

#include <pcl/sedr_surface/mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <tuple>

namespace pcl::sedr {

namespace {

/** @brief Returns a label or room per vertex: that with the largest area around it, the
 * smallest of equals; 0 for a vertex without triangles.
 * @param values one per triangle: TriangleMesh::labels or rooms; or none */
std::vector<std::uint32_t>
vertexValues(const TriangleMesh& mesh, const std::vector<std::uint32_t>& values)
{
  struct Share {
    std::uint32_t vertex;
    std::uint32_t value;
    double area;
  };
  std::vector<Share> shares;
  shares.reserve(3 * values.size());
  for (std::size_t t = 0; t < values.size(); ++t)
    for (const std::uint32_t v : mesh.triangles[t])
      shares.push_back({v, values[t], mesh.scaledNormal(t).norm()});
  std::stable_sort(shares.begin(), shares.end(), [](const Share& a, const Share& b) {
    return std::tie(a.vertex, a.value) < std::tie(b.vertex, b.value);
  });
  std::vector<std::uint32_t> result(mesh.vertices.size(), 0);
  std::vector<double> largest(mesh.vertices.size(), -1);
  for (auto first = shares.begin(); first != shares.end();) {
    const auto [vertex, value, unused] = *first;
    double area = 0;
    for (; first != shares.end() && first->vertex == vertex && first->value == value;
         ++first)
      area += first->area;
    if (area > largest[vertex]) {
      largest[vertex] = area;
      result[vertex] = value;
    }
  }
  return result;
}

/** @brief Beyond this, floats are off by 0.015 mm or more, metres. */
constexpr double farthest_float = 256;

std::string
plyHeader(const TriangleMesh& mesh,
          const std::vector<std::string>& comments,
          bool needs_doubles,
          bool has_colours)
{
  constexpr const char* colour =
      "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  std::ostringstream text;
  text << "ply\nformat binary_little_endian 1.0\ncomment metres, z up\n";
  for (const std::string& comment : comments)
    text << "comment " << comment << '\n';
  text << "element vertex " << mesh.vertices.size() << '\n';
  for (const char* axis : {"x", "y", "z"})
    text << "property " << (needs_doubles ? "double " : "float ") << axis << '\n';
  text << (has_colours || !mesh.labels.empty() ? colour : "")
       << (has_colours ? "property uchar seen\n" : "")
       << (mesh.labels.empty() ? "" : "property uint label\n")
       << (mesh.rooms.empty() ? "" : "property uint room\n") << "element face "
       << mesh.triangles.size() << "\nproperty list uchar int vertex_indices\n"
       << (mesh.labels.empty() ? "" : "property int label\n")
       << (mesh.rooms.empty() ? "" : "property int room\n")
       << (mesh.elements.empty() ? "" : "property int element\n")
       << (has_colours || mesh.labels.empty() ? "" : colour) << "end_header\n";
  return text.str();
}

void
addColour(std::string& bytes, std::uint32_t label)
{
  const LabelColour colour = colourOf(label);
  for (const double channel : {colour.red, colour.green, colour.blue})
    append(bytes, static_cast<std::uint8_t>(std::lround(255 * channel)));
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

std::string
meshToPly(const TriangleMesh& mesh,
          const std::vector<std::string>& comments,
          const std::vector<SeenColour>& colours)
{
  const bool has_colours = !colours.empty();
  const bool needs_doubles =
      std::any_of(mesh.vertices.begin(), mesh.vertices.end(), [](const auto& v) {
        return v.cwiseAbs().maxCoeff() >= farthest_float;
      });
  const auto labels = vertexValues(mesh, mesh.labels);
  const auto rooms = vertexValues(mesh, mesh.rooms);
  std::string bytes = plyHeader(mesh, comments, needs_doubles, has_colours);
  bytes.reserve(bytes.size() + (needs_doubles ? 35 : 23) * mesh.vertices.size() +
                28 * mesh.triangles.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    for (int k = 0; k < 3; ++k)
      if (needs_doubles)
        append(bytes, mesh.vertices[v][k]);
      else
        append(bytes, static_cast<float>(mesh.vertices[v][k]));
    if (has_colours) {
      append(bytes, colours[v].rgb);
      append(bytes, std::uint8_t(colours[v].is_seen ? 1 : 0));
    }
    else if (!mesh.labels.empty())
      addColour(bytes, labels[v]);
    if (!mesh.labels.empty())
      append(bytes, labels[v]);
    if (!mesh.rooms.empty())
      append(bytes, rooms[v]);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    append(bytes, std::uint8_t{3});
    for (const std::uint32_t v : mesh.triangles[t])
      append(bytes, v);
    for (const auto* attribute : {&mesh.labels, &mesh.rooms, &mesh.elements})
      if (!attribute->empty())
        append(bytes, (*attribute)[t]);
    if (!has_colours && !mesh.labels.empty())
      addColour(bytes, mesh.labels[t]);
  }
  return bytes;
}

} // namespace pcl::sedr
