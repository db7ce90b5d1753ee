// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/base/field_access.h"
#include "sedr_filters/src/base/labels.h"

#include <pcl/sedr_surface/triangle_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <unordered_map>
#include <vector>

namespace pcl::sedr {
namespace {

/** @brief Returns a label or room per vertex: that with the largest area around it, the
 * smallest of equals; 0 for a vertex without triangles.
 * @param values one per triangle: TriangleMesh::labels or rooms; or none */
std::vector<std::uint32_t>
vertexValues(const TriangleMesh& mesh, const std::vector<std::uint32_t>& values)
{
  std::unordered_map<std::uint64_t, double> areas; // of vertex, value
  areas.reserve(mesh.vertices.size());
  for (std::size_t t = 0; t < values.size(); ++t)
    for (const std::uint32_t v : mesh.triangles[t])
      areas[std::uint64_t{v} << 32U | values[t]] += mesh.scaledNormal(t).norm();
  std::vector<std::uint32_t> result(mesh.vertices.size(), 0);
  std::vector<double> largest(mesh.vertices.size(), -1);
  for (const auto& [of, area] : areas) {
    const auto vertex = static_cast<std::size_t>(of >> 32U);
    const auto value = static_cast<std::uint32_t>(of);
    if (area > largest[vertex] || (area == largest[vertex] && value < result[vertex])) {
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
    appendBytes(bytes, static_cast<std::uint8_t>(std::lround(255 * channel)));
}

} // namespace

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
        appendBytes(bytes, mesh.vertices[v][k]);
      else
        appendBytes(bytes, static_cast<float>(mesh.vertices[v][k]));
    if (has_colours) {
      appendBytes(bytes, colours[v].rgb);
      appendBytes(bytes, std::uint8_t(colours[v].is_seen ? 1 : 0));
    }
    else if (!mesh.labels.empty())
      addColour(bytes, labels[v]);
    if (!mesh.labels.empty())
      appendBytes(bytes, labels[v]);
    if (!mesh.rooms.empty())
      appendBytes(bytes, rooms[v]);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    appendBytes(bytes, std::uint8_t{3});
    for (const std::uint32_t v : mesh.triangles[t])
      appendBytes(bytes, v);
    for (const auto* attribute : {&mesh.labels, &mesh.rooms, &mesh.elements})
      if (!attribute->empty())
        appendBytes(bytes, (*attribute)[t]);
    if (!has_colours && !mesh.labels.empty())
      addColour(bytes, mesh.labels[t]);
  }
  return bytes;
}

} // namespace pcl::sedr
