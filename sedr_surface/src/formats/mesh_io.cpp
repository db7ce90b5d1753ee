// SPDX-License-Identifier: BSD-3-Clause
#include "labels.h"
#include "mesh_parsers.h"

#include <pcl/sedr_surface/mesh_io.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <tuple>
#include <vector>

namespace pcl::sedr {

namespace {

/** @brief Returns a label or room per vertex: that with the largest area around it, the
 * smallest of equals; 0 for a vertex without triangles.
 * @param values one per triangle: TriangleMesh::labels or rooms */
std::vector<std::uint32_t>
vertexValues(const TriangleMesh& mesh, const std::vector<std::uint32_t>& values)
{
  struct Share {
    std::uint32_t vertex;
    std::uint32_t value;
    double area;
  };
  std::vector<Share> shares;
  shares.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const std::uint32_t v : mesh.triangles[t])
      shares.push_back({v, values[t], mesh.scaledNormal(t).norm()});
  std::stable_sort(shares.begin(), shares.end(), [](const Share& a, const Share& b) {
    return std::tie(a.vertex, a.value) < std::tie(b.vertex, b.value);
  });
  std::vector<std::uint32_t> result(mesh.vertices.size(), 0);
  std::vector<double> largest(mesh.vertices.size(), -1);
  for (std::size_t i = 0; i < shares.size();) {
    const Share& first = shares[i];
    double area = 0;
    for (; i < shares.size() && shares[i].vertex == first.vertex &&
           shares[i].value == first.value;
         ++i)
      area += shares[i].area;
    if (area > largest[first.vertex]) {
      largest[first.vertex] = area;
      result[first.vertex] = first.value;
    }
  }
  return result;
}

} // namespace
namespace {

template <typename T>
void
appendBytes(std::string& bytes, T value)
{
  // The PLY header says little-endian, like all platforms of PCL.
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

/** @brief Beyond this, floats are off by 0.015 mm or more, metres. */
constexpr double farthest_float = 256;

bool
needsDoubles(const TriangleMesh& mesh)
{
  return std::any_of(mesh.vertices.begin(), mesh.vertices.end(), [](const auto& v) {
    return v.cwiseAbs().maxCoeff() >= farthest_float;
  });
}

constexpr const char* colour_properties =
    "property uchar red\nproperty uchar green\nproperty uchar blue\n";

void
appendColour(std::string& bytes, std::uint32_t label)
{
  const LabelColour colour = colourOf(label);
  for (const double channel : {colour.red, colour.green, colour.blue})
    appendBytes(bytes, static_cast<std::uint8_t>(std::lround(255 * channel)));
}

std::string
plyHeader(const TriangleMesh& mesh, const std::vector<std::string>& comments)
{
  std::ostringstream header;
  header << "ply\nformat binary_little_endian 1.0\ncomment metres, z up\n";
  for (const std::string& comment : comments)
    header << "comment " << comment << '\n';
  header << "element vertex " << mesh.vertices.size() << '\n';
  for (const char* axis : {"x", "y", "z"})
    header << "property " << (needsDoubles(mesh) ? "double " : "float ") << axis
           << '\n';
  if (!mesh.labels.empty())
    header << colour_properties << "property uint label\n";
  if (!mesh.rooms.empty())
    header << "property uint room\n";
  header << "element face " << mesh.triangles.size()
         << "\nproperty list uchar int vertex_indices\n";
  if (!mesh.labels.empty())
    header << "property int label\n";
  if (!mesh.rooms.empty())
    header << "property int room\n";
  if (!mesh.elements.empty())
    header << "property int element\n";
  if (!mesh.labels.empty())
    header << colour_properties;
  header << "end_header\n";
  return header.str();
}

/** @brief Properties of a vertex besides its position: colour of its label, label,
 * room. */
class VertexExtras {
public:
  explicit VertexExtras(const TriangleMesh& mesh)
  {
    if (!mesh.labels.empty())
      labels_ = vertexValues(mesh, mesh.labels);
    if (!mesh.rooms.empty())
      rooms_ = vertexValues(mesh, mesh.rooms);
  }

  void append(std::string& bytes, std::size_t v) const
  {
    if (!labels_.empty()) {
      appendColour(bytes, labels_[v]);
      appendBytes(bytes, labels_[v]);
    }
    if (!rooms_.empty())
      appendBytes(bytes, rooms_[v]);
  }

private:
  std::vector<std::uint32_t> labels_;
  std::vector<std::uint32_t> rooms_;
};

std::string
plyContent(const TriangleMesh& mesh, const std::vector<std::string>& comments)
{
  std::string content = plyHeader(mesh, comments);
  const bool doubles = needsDoubles(mesh);
  content.reserve(content.size() + (doubles ? 35 : 23) * mesh.vertices.size() +
                  28 * mesh.triangles.size());
  const VertexExtras extras(mesh);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    for (int k = 0; k < 3; ++k)
      if (doubles)
        appendBytes(content, mesh.vertices[v][k]);
      else
        appendBytes(content, static_cast<float>(mesh.vertices[v][k]));
    extras.append(content, v);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    appendBytes(content, std::uint8_t(3));
    for (const auto v : mesh.triangles[t])
      appendBytes(content, static_cast<std::int32_t>(v));
    for (const auto* attribute : {&mesh.labels, &mesh.rooms, &mesh.elements})
      if (!attribute->empty())
        appendBytes(content, static_cast<std::int32_t>((*attribute)[t]));
    if (!mesh.labels.empty())
      appendColour(content, static_cast<std::uint32_t>(mesh.labels[t]));
  }
  return content;
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
  if (content.empty())
    return path + " is empty";
  std::string reason;
  if (content.compare(0, 4, "ply\n") == 0 || content.compare(0, 4, "ply\r") == 0)
    reason = parsePly(content, mesh);
  else if (looksLikeObj(content))
    reason = parseObj(content, mesh);
  else
    reason = "is neither a PLY nor an OBJ file";
  if (reason.empty() && mesh.empty())
    reason = "is no mesh: it holds " + std::to_string(mesh.vertices.size()) +
             " vertices and no triangles";
  if (reason.empty()) {
    const std::string problem = mesh.problem();
    if (!problem.empty())
      reason = "is no mesh: " + problem;
  }
  if (reason.empty())
    return {};
  mesh = TriangleMesh();
  return path + " " + reason;
}

std::string
savePly(const std::string& path,
        const TriangleMesh& mesh,
        const std::vector<std::string>& comments)
{
  const std::string problem = mesh.problem();
  if (!problem.empty())
    return path + " is not written: " + problem;
  const std::string beside = path + ".part";
  {
    std::ofstream file(beside, std::ios::binary | std::ios::trunc);
    if (!file)
      return path + " cannot be written: its folder is missing or not writable";
    const std::string content = plyContent(mesh, comments);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    file.close();
    if (!file) {
      std::remove(beside.c_str());
      return path + " cannot be written: the disk took only a part of its " +
             std::to_string(content.size()) + " bytes";
    }
  }
  std::error_code error;
  std::filesystem::rename(beside, path, error);
  if (error) {
    std::remove(beside.c_str());
    return path + " cannot be written: " + error.message();
  }
  return {};
}

} // namespace pcl::sedr
