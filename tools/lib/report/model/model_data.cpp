// SPDX-License-Identifier: BSD-3-Clause
#include "model_data.h"

#include "report/page/html_text.h"
#include "results/shown_mesh.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace sedr {
namespace tools {

namespace {

using Json = nlohmann::ordered_json;

/** @brief Numbers as little-endian bytes. */
class Bytes {
public:
  template <typename NumberT>
  void add(NumberT value)
  {
    for (std::size_t k = 0; k < sizeof value; ++k)
      bytes_ += static_cast<char>(value >> (8 * k) & 0xff);
  }

  std::string text() const { return base64(bytes_); }

private:
  std::string bytes_;
};

/** @brief Places as shares of a box. */
struct Quantised {
  Eigen::Vector3d low;
  Eigen::Vector3d size;

  explicit Quantised(const Eigen::AlignedBox3d& box)
      : low(box.min())
      , size(box.sizes().cwiseMax(1e-6))
  {}

  void add(const Eigen::Vector3d& p, Bytes& bytes) const
  {
    for (int k = 0; k < 3; ++k)
      bytes.add(static_cast<std::uint16_t>(
          std::lround(std::clamp((p[k] - low[k]) / size[k], 0.0, 1.0) * 65535)));
  }

  std::string linesOf(const TriangleMesh& mesh) const
  {
    Bytes bytes;
    for (const auto& [a, b] : elementEdges(mesh)) {
      add(a, bytes);
      add(b, bytes);
    }
    return bytes.text();
  }
};

/** @brief Rooms as the page's palette tells them apart, which goes round every 12: so
 * that any number of them fits a byte. */
std::vector<std::uint32_t>
folded(std::vector<std::uint32_t> rooms)
{
  constexpr std::uint32_t rounds = 21 * 12;
  for (auto& room : rooms)
    room = room == 0 ? 0 : (room - 1) % rounds + 1;
  return rooms;
}

std::string
bytesOf(const std::vector<std::uint32_t>& values, std::size_t count)
{
  Bytes bytes;
  for (std::size_t i = 0; i < count; ++i)
    bytes.add(static_cast<std::uint8_t>(values.empty() ? 0 : values[i] & 0xff));
  return bytes.text();
}

} // namespace

std::string
modelData(const TriangleMesh& mesh, const CeilingRule& rule, bool with_edges)
{
  const Quantised places(mesh.bounds());
  const std::vector<bool> is_ceiling = rule.ofMesh(mesh);
  Bytes positions;
  for (const auto& vertex : mesh.vertices)
    places.add(vertex, positions);
  Bytes corners;
  for (const auto& triangle : mesh.triangles)
    for (const auto v : triangle)
      corners.add(v);
  Bytes ceilings;
  for (const bool flag : is_ceiling)
    ceilings.add(static_cast<std::uint8_t>(flag ? 1 : 0));
  const std::size_t count = mesh.triangles.size();
  Json json{{"vertices", mesh.vertices.size()},
            {"triangles", count},
            {"low", {places.low.x(), places.low.y(), places.low.z()}},
            {"size", {places.size.x(), places.size.y(), places.size.z()}},
            {"positions", positions.text()},
            {"corners", corners.text()},
            {"labels", bytesOf(mesh.labels, count)},
            {"rooms", bytesOf(folded(mesh.rooms), count)},
            {"ceilings", ceilings.text()}};
  if (with_edges) {
    TriangleMesh open = mesh;
    std::vector<bool> keep = is_ceiling;
    keep.flip();
    open.keepTriangles(keep);
    json["edges"] = places.linesOf(mesh);
    json["open_edges"] = places.linesOf(open);
  }
  return json.dump();
}

} // namespace tools
} // namespace sedr
} // namespace pcl
