// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_surface/mesh_repair.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <unordered_map>

namespace pcl {
namespace sedr {
namespace {

// The vertex that each vertex becomes, equal positions becoming the lowest of them.
std::vector<std::uint32_t>
matchEqual(const std::vector<Eigen::Vector3d>& vertices)
{
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&vertices](std::uint32_t v) {
    return std::make_tuple(vertices[v].x(), vertices[v].y(), vertices[v].z());
  };
  std::sort(order.begin(), order.end(), [&key](std::uint32_t a, std::uint32_t b) {
    return key(a) != key(b) ? key(a) < key(b) : a < b;
  });
  std::vector<std::uint32_t> target(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    target[order[i]] =
        i > 0 && key(order[i]) == key(order[i - 1]) ? target[order[i - 1]] : order[i];
  return target;
}

struct CellHash {
  std::size_t operator()(const std::array<std::int64_t, 3>& cell) const
  {
    std::uint64_t hash = 0;
    for (const auto c : cell)
      hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x9e3779b97f4a7c15ull;
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }
};

// The same within a tolerance: each vertex joins the first earlier one that joined no
// other.
std::vector<std::uint32_t>
matchWithin(const std::vector<Eigen::Vector3d>& vertices, double tolerance)
{
  std::unordered_map<std::array<std::int64_t, 3>, std::vector<std::uint32_t>, CellHash>
      cells;
  std::vector<std::uint32_t> target(vertices.size());
  const Eigen::Vector3d origin =
      vertices.empty() ? Eigen::Vector3d(0, 0, 0) : vertices.front();
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    const Eigen::Vector3d scaled = (vertices[v] - origin) / tolerance;
    std::array<std::int64_t, 3> cell{};
    for (int k = 0; k < 3; ++k)
      cell[static_cast<std::size_t>(k)] =
          static_cast<std::int64_t>(std::floor(scaled[k]));
    std::uint32_t found = v;
    for (int n = 0; n < 27; ++n) {
      const auto neighbours = cells.find(
          {cell[0] + n % 3 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n / 9 - 1});
      if (neighbours == cells.end())
        continue;
      for (const auto other : neighbours->second)
        if (other < found && (vertices[other] - vertices[v]).norm() <= tolerance)
          found = other;
    }
    target[v] = found;
    if (found == v)
      cells[cell].push_back(v);
  }
  return target;
}

// True if the triangle runs through its vertices in ascending order, cyclically.
bool
isAscending(const Triangle& t)
{
  return (t[0] < t[1] && t[1] < t[2]) || (t[1] < t[2] && t[2] < t[0]) ||
         (t[2] < t[0] && t[0] < t[1]);
}

constexpr auto none = std::numeric_limits<std::uint32_t>::max();

} // namespace

std::size_t
weldVertices(TriangleMesh& mesh, double tolerance)
{
  const auto target =
      tolerance > 0 ? matchWithin(mesh.vertices, tolerance) : matchEqual(mesh.vertices);
  std::size_t welded = 0;
  for (std::uint32_t v = 0; v < target.size(); ++v)
    welded += target[v] != v;
  for (Triangle& triangle : mesh.triangles)
    for (auto& v : triangle)
      v = target[v];
  return welded;
}

std::size_t
dropDegenerateTriangles(TriangleMesh& mesh)
{
  std::vector<std::pair<Triangle, std::uint32_t>> sorted;
  std::vector<bool> keep(mesh.triangles.size(), true);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    Triangle triangle = mesh.triangles[t];
    std::sort(triangle.begin(), triangle.end());
    keep[t] = triangle[0] != triangle[1] && triangle[1] != triangle[2];
    if (keep[t])
      sorted.emplace_back(triangle, t);
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t first = 0; first < sorted.size();) {
    std::size_t last = first;
    std::array<std::uint32_t, 2> representative = {none, none};
    std::int64_t balance = 0;
    for (; last < sorted.size() && sorted[last].first == sorted[first].first; ++last) {
      const bool ascending = isAscending(mesh.triangles[sorted[last].second]);
      balance += ascending ? 1 : -1;
      auto& front = representative[ascending ? 1 : 0];
      front = std::min(front, sorted[last].second);
    }
    if (last - first > 1) {
      for (std::size_t i = first; i < last; ++i)
        keep[sorted[i].second] = false;
      if (balance != 0)
        keep[representative[balance > 0 ? 1 : 0]] = true;
    }
    first = last;
  }
  return mesh.keepTriangles(keep);
}

} // namespace sedr
} // namespace pcl
