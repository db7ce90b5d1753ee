// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulator/truth/truth_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

/** @file Measures of a mesh that tests compare with closed forms; room 0 means all. */

namespace pcl::sedr::sim::test {

inline bool
isOf(const Face& face, std::uint32_t room)
{
  return room == 0 || face.room == room;
}

/** @brief Returns the enclosed volume, positive if normals point outwards. */
inline double
signedVolume(const Mesh& mesh, std::uint32_t room = 0)
{
  double volume = 0.0;
  for (const Face& face : mesh.faces)
    if (isOf(face, room))
      volume +=
          dot(mesh.vertices[face.vertices[0]],
              cross(mesh.vertices[face.vertices[1]], mesh.vertices[face.vertices[2]])) /
          6.0;
  return volume;
}

/** @brief Returns the normal of a face with twice its area as length. */
inline Vec3
doubledNormal(const Mesh& mesh, const Face& face)
{
  const Vec3 a = mesh.vertices[face.vertices[0]];
  return cross(mesh.vertices[face.vertices[1]] - a,
               mesh.vertices[face.vertices[2]] - a);
}

inline double
areaOf(const Mesh& mesh, Label label, std::uint32_t room = 0)
{
  double area = 0.0;
  for (const Face& face : mesh.faces)
    if (face.label == label && isOf(face, room))
      area += 0.5 * length(doubledNormal(mesh, face));
  return area;
}

/** @brief Returns true if every directed edge has exactly one opposite edge. */
inline bool
isClosedManifold(const Mesh& mesh)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const Face& face : mesh.faces)
    for (int i = 0; i < 3; ++i)
      ++uses[{face.vertices[i], face.vertices[(i + 1) % 3]}];
  return std::all_of(uses.begin(), uses.end(), [&uses](const auto& use) {
    const auto partner = uses.find({use.first.second, use.first.first});
    return use.second == 1 && partner != uses.end();
  });
}

/** @brief Returns vertices - edges + faces of a closed mesh. */
inline long
eulerCharacteristic(const Mesh& mesh, std::uint32_t room = 0)
{
  std::set<std::uint32_t> vertices;
  long faces = 0;
  for (const Face& face : mesh.faces)
    if (isOf(face, room)) {
      vertices.insert(face.vertices.begin(), face.vertices.end());
      ++faces;
    }
  return static_cast<long>(vertices.size()) - faces * 3 / 2 + faces;
}

/** @brief Returns the number of edge-connected components. */
inline std::size_t
componentCount(const Mesh& mesh)
{
  std::vector<std::uint32_t> parent(mesh.vertices.size());
  for (std::uint32_t i = 0; i < parent.size(); ++i)
    parent[i] = i;
  const auto root = [&parent](std::uint32_t i) {
    while (parent[i] != i)
      i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const Face& face : mesh.faces)
    for (int i = 1; i < 3; ++i)
      parent[root(face.vertices[i])] = root(face.vertices[0]);
  std::set<std::uint32_t> roots;
  for (const Face& face : mesh.faces)
    roots.insert(root(face.vertices[0]));
  return roots.size();
}

/** @brief Returns the distance of a point from a segment. */
inline double
distanceToSegment(Vec3 p, Vec3 a, Vec3 b)
{
  const Vec3 along = b - a;
  const double t = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
  return length(p - (a + t * along));
}

inline double
distanceToFace(Vec3 p, const Mesh& mesh, const Face& face)
{
  const Vec3 corners[3] = {mesh.vertices[face.vertices[0]],
                           mesh.vertices[face.vertices[1]],
                           mesh.vertices[face.vertices[2]]};
  const Vec3 normal = doubledNormal(mesh, face);
  bool above = true;
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Vec3 a = corners[i];
    const Vec3 b = corners[(i + 1) % 3];
    above = above && dot(cross(b - a, p - a), normal) >= 0.0;
    nearest = std::min(nearest, distanceToSegment(p, a, b));
  }
  return above ? std::abs(dot(p - corners[0], normal)) / length(normal) : nearest;
}

} // namespace pcl::sedr::sim::test
