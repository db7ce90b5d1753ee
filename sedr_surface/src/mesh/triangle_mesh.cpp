// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_surface/triangle_mesh.h>

#include <limits>

namespace pcl::sedr {
using Attribute = std::vector<std::uint32_t>;

double
TriangleMesh::area() const
{
  double twice = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    twice += scaledNormal(t).norm();
  return twice / 2;
}

double
TriangleMesh::signedVolume() const
{
  if (empty())
    return 0;
  // Relative to a vertex of the mesh, to keep precision at large coordinates.
  const Eigen::Vector3d origin = corner(0, 0);
  double six_fold = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    six_fold += (corner(t, 0) - origin)
                    .dot((corner(t, 1) - origin).cross(corner(t, 2) - origin));
  return six_fold / 6;
}

Eigen::AlignedBox3d
TriangleMesh::bounds() const
{
  Eigen::AlignedBox3d box;
  for (const Triangle& triangle : triangles)
    for (const auto v : triangle)
      box.extend(vertices[v]);
  return box;
}

void
TriangleMesh::flip()
{
  for (Triangle& triangle : triangles)
    std::swap(triangle[1], triangle[2]);
}

void
TriangleMesh::append(const TriangleMesh& other)
{
  const auto shift = static_cast<std::uint32_t>(vertices.size());
  const std::size_t before = triangles.size();
  const std::size_t added = other.triangles.size();
  for (Attribute TriangleMesh::*const of :
       {&TriangleMesh::labels, &TriangleMesh::rooms, &TriangleMesh::elements})
    if (!(this->*of).empty() || !(other.*of).empty()) {
      (this->*of).resize(before, 0);
      (this->*of).insert((this->*of).end(), (other.*of).begin(), (other.*of).end());
      (this->*of).resize(before + added, 0);
    }
  vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
  for (std::size_t t = 0; t < added; ++t) {
    const Triangle& triangle = other.triangles[t];
    triangles.push_back(
        {triangle[0] + shift, triangle[1] + shift, triangle[2] + shift});
  }
}

std::size_t
TriangleMesh::keepTriangles(const std::vector<bool>& keep)
{
  std::size_t kept = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!keep[t])
      continue;
    triangles[kept] = triangles[t];
    for (Attribute* attribute : attributes())
      if (!attribute->empty())
        (*attribute)[kept] = (*attribute)[t];
    ++kept;
  }
  const std::size_t removed = triangles.size() - kept;
  triangles.resize(kept);
  for (Attribute* attribute : attributes())
    if (!attribute->empty())
      attribute->resize(kept);
  return removed;
}

std::size_t
TriangleMesh::removeUnusedVertices()
{
  constexpr auto unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> new_index(vertices.size(), unused);
  for (const Triangle& triangle : triangles)
    for (const auto v : triangle)
      new_index[v] = 0;
  std::uint32_t kept = 0;
  for (std::size_t v = 0; v < vertices.size(); ++v)
    if (new_index[v] != unused) {
      vertices[kept] = vertices[v];
      new_index[v] = kept++;
    }
  const std::size_t removed = vertices.size() - kept;
  vertices.resize(kept);
  for (Triangle& triangle : triangles)
    for (auto& v : triangle)
      v = new_index[v];
  return removed;
}

std::string
TriangleMesh::problem() const
{
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (const auto v : triangles[t])
      if (v >= vertices.size())
        return "triangle " + std::to_string(t) + " uses vertex " + std::to_string(v) +
               ", the mesh has " + std::to_string(vertices.size()) + " vertices";
  for (std::size_t v = 0; v < vertices.size(); ++v)
    if (!vertices[v].allFinite())
      return "vertex " + std::to_string(v) + " is not finite";
  const auto isOfAnotherLength = [this](const Attribute& attribute) {
    return !attribute.empty() && attribute.size() != triangles.size();
  };
  if (isOfAnotherLength(labels) || isOfAnotherLength(rooms) ||
      isOfAnotherLength(elements))
    return "the mesh has " + std::to_string(triangles.size()) + " triangles, but " +
           std::to_string(labels.size()) + " labels, " + std::to_string(rooms.size()) +
           " rooms and " + std::to_string(elements.size()) + " elements";
  return {};
}

} // namespace pcl::sedr
