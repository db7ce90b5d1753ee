// SPDX-License-Identifier: BSD-3-Clause
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
#include <utility>

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

/** @brief The bytes of a PLY: little-endian, like all platforms of PCL. */
class PlyContent {
public:
  PlyContent(const TriangleMesh& mesh, const std::vector<std::string>& comments)
      : mesh_(mesh)
      , needs_doubles_(std::any_of(
            mesh.vertices.begin(),
            mesh.vertices.end(),
            [](const auto& v) { return v.cwiseAbs().maxCoeff() >= farthest_float; }))
      , bytes_(header(comments))
  {
    bytes_.reserve(bytes_.size() + (needs_doubles_ ? 35 : 23) * mesh.vertices.size() +
                   28 * mesh.triangles.size());
    addVertices();
    addFaces();
  }

  std::string take() { return std::move(bytes_); }

private:
  /** @brief Beyond this, floats are off by 0.015 mm or more, metres. */
  static constexpr double farthest_float = 256;

  std::string header(const std::vector<std::string>& comments) const
  {
    const char* const colour =
        mesh_.labels.empty()
            ? ""
            : "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    std::ostringstream text;
    text << "ply\nformat binary_little_endian 1.0\ncomment metres, z up\n";
    for (const std::string& comment : comments)
      text << "comment " << comment << '\n';
    text << "element vertex " << mesh_.vertices.size() << '\n';
    for (const char* axis : {"x", "y", "z"})
      text << "property " << (needs_doubles_ ? "double " : "float ") << axis << '\n';
    text << colour << (mesh_.labels.empty() ? "" : "property uint label\n")
         << (mesh_.rooms.empty() ? "" : "property uint room\n") << "element face "
         << mesh_.triangles.size() << "\nproperty list uchar int vertex_indices\n"
         << (mesh_.labels.empty() ? "" : "property int label\n")
         << (mesh_.rooms.empty() ? "" : "property int room\n")
         << (mesh_.elements.empty() ? "" : "property int element\n") << colour
         << "end_header\n";
    return text.str();
  }

  template <typename T>
  void add(T value)
  {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }

  void addColour(std::uint32_t label)
  {
    const LabelColour colour = colourOf(label);
    for (const double channel : {colour.red, colour.green, colour.blue})
      add(static_cast<std::uint8_t>(std::lround(255 * channel)));
  }

  void addVertices()
  {
    const auto labels = vertexValues(mesh_, mesh_.labels);
    const auto rooms = vertexValues(mesh_, mesh_.rooms);
    for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) {
      for (int k = 0; k < 3; ++k)
        if (needs_doubles_)
          add(mesh_.vertices[v][k]);
        else
          add(static_cast<float>(mesh_.vertices[v][k]));
      if (!mesh_.labels.empty()) {
        addColour(labels[v]);
        add(labels[v]);
      }
      if (!mesh_.rooms.empty())
        add(rooms[v]);
    }
  }

  void addFaces()
  {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      add(std::uint8_t{3});
      for (const auto v : mesh_.triangles[t])
        add(v);
      for (const auto* attribute : {&mesh_.labels, &mesh_.rooms, &mesh_.elements})
        if (!attribute->empty())
          add((*attribute)[t]);
      if (!mesh_.labels.empty())
        addColour(mesh_.labels[t]);
    }
  }

  const TriangleMesh& mesh_;
  bool needs_doubles_;
  std::string bytes_;
};

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
meshToPly(const TriangleMesh& mesh, const std::vector<std::string>& comments)
{
  return PlyContent(mesh, comments).take();
}

} // namespace pcl::sedr
