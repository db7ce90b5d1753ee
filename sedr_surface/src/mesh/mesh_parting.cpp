// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace pcl::sedr {
namespace {

using Place = std::array<float, 3>;

Place
placeOf(const Eigen::Vector3d& v)
{
  return {static_cast<float>(v.x()), static_cast<float>(v.y()),
          static_cast<float>(v.z())};
}

Eigen::Vector3d
toVector(const Place& place)
{
  return {place[0], place[1], place[2]};
}

// Returns the vertices at the position of another one with a lower number.
std::vector<std::uint32_t>
doublesAmong(const std::vector<Place>& places)
{
  std::vector<std::uint32_t> order(places.size());
  for (std::uint32_t v = 0; v < places.size(); ++v)
    order[v] = v;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return places[a] != places[b] ? places[a] < places[b] : a < b;
  });
  std::vector<std::uint32_t> doubles;
  for (std::size_t i = 1; i < order.size(); ++i)
    if (places[order[i]] == places[order[i - 1]])
      doubles.push_back(order[i]);
  std::sort(doubles.begin(), doubles.end());
  return doubles;
}

// Returns directions along the surface from some vertices: to the centre of all
// triangles there, then to the centre of each.
std::map<std::uint32_t, std::vector<Eigen::Vector3d>>
waysAlongSurface(const TriangleMesh& mesh, const std::vector<std::uint32_t>& vertices)
{
  std::map<std::uint32_t, std::vector<Eigen::Vector3d>> ways;
  for (const auto v : vertices)
    ways[v].emplace_back(Eigen::Vector3d::Zero());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const auto v : mesh.triangles[t])
      if (std::binary_search(vertices.begin(), vertices.end(), v)) {
        ways[v].emplace_back(
            (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3 -
            mesh.vertices[v]);
        ways[v].front() += ways[v].back();
      }
  for (auto& way : ways)
    way.second.front() /=
        std::max<double>(1, static_cast<double>(way.second.size()) - 1);
  return ways;
}

// Returns a free position for a vertex: a little along one of the directions, farther
// if occupied. If they are too short for a float, the next value of x.
Place
freePlace(const Eigen::Vector3d& from,
          const std::vector<Eigen::Vector3d>& ways,
          const std::set<Place>& taken)
{
  constexpr double least = 0.02; // as far as cutNonManifold() moves vertices
  constexpr double most = 0.5;
  for (double share = least; share < most; share *= 2)
    for (const auto& way : ways) {
      const Place place = placeOf(from + share * way);
      if (taken.count(place) == 0)
        return place;
    }
  Place place = placeOf(from);
  while (taken.count(place) > 0)
    place[0] = std::nextafter(place[0], std::numeric_limits<float>::infinity());
  return place;
}

} // namespace

std::size_t
partEqualPositions(TriangleMesh& mesh)
{
  std::vector<Place> places;
  places.reserve(mesh.vertices.size());
  for (const Eigen::Vector3d& v : mesh.vertices)
    places.push_back(placeOf(v));
  for (std::size_t v = 0; v < places.size(); ++v)
    mesh.vertices[v] = toVector(places[v]);
  const std::vector<std::uint32_t> doubles = doublesAmong(places);
  if (doubles.empty())
    return 0;
  const auto ways = waysAlongSurface(mesh, doubles);
  std::set<Place> taken(places.begin(), places.end());
  for (const auto v : doubles) {
    const Place place = freePlace(mesh.vertices[v], ways.at(v), taken);
    taken.insert(place);
    mesh.vertices[v] = toVector(place);
  }
  return doubles.size();
}

} // namespace pcl::sedr
