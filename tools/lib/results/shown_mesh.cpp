// SPDX-License-Identifier: BSD-3-Clause
#include "shown_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::sedr::tools {

Colour
litColour(Colour colour, const Eigen::Vector3d& normal)
{
  // One light from above and one from the side: floors are brightest, walls vary by
  // direction.
  static const Eigen::Vector3d side = Eigen::Vector3d(0.8, 0.6, 0).normalized();
  const double brightness =
      0.72 + 0.16 * std::abs(normal.dot(side)) + 0.28 * std::abs(normal.z());
  return darkened(colour, 1 - std::min(1.0, brightness));
}

std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>
elementEdges(const TriangleMesh& mesh)
{
  const auto& kinds = mesh.elements.empty() ? mesh.labels : mesh.elements;
  const auto kindOf = [&](std::size_t t) { return kinds.empty() ? 0 : kinds[t]; };
  struct Uses {
    std::uint32_t kind = 0;
    int count = 0;
    bool differ = false;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, Uses> edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      Uses& uses =
          edges[std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3])];
      uses.differ = uses.differ || (uses.count > 0 && uses.kind != kindOf(t));
      uses.kind = kindOf(t);
      ++uses.count;
    }
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> lines;
  for (const auto& [ends, uses] : edges)
    if (uses.differ || uses.count == 1)
      lines.emplace_back(mesh.vertices[ends.first], mesh.vertices[ends.second]);
  return lines;
}

} // namespace pcl::sedr::tools
