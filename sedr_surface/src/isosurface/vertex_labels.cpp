// SPDX-License-Identifier: BSD-3-Clause
#include "vertex_labels.h"

#include <algorithm>
#include <tuple>

namespace pcl::sedr {

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

} // namespace pcl::sedr
