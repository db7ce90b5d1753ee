// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_outlines.h"

#include "mesh_repair.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include "sedr_segmentation/src/curves/contour.h"

#include <algorithm>
#include <array>
#include <map>

namespace pcl::sedr {
namespace {

/** @brief Joins directed edges, each of which begins where one ends, to loops.
 * @param next the end of each edge, by its start */
template <typename Key>
std::vector<PlanLoop>
loopsOf(std::multimap<Key, Key> next, const std::map<Key, Eigen::Vector2d>& places)
{
  std::vector<PlanLoop> loops;
  while (!next.empty()) {
    std::vector<Eigen::Vector2d> corners;
    for (auto edge = next.begin(); edge != next.end();) {
      corners.push_back(places.at(edge->first));
      const Key end = edge->second;
      next.erase(edge);
      edge = next.find(end);
    }
    constexpr double on_line = 1e-6; // metres; such corners are those of triangles only
    const std::vector<Eigen::Vector2d> kept = simplified(corners, on_line);
    if (kept.size() > 2)
      loops.push_back(loopOf(kept));
  }
  return loops;
}

} // namespace

std::vector<PlanLoop>
cutOf(const TriangleMesh& mesh, const SectionLine& line)
{
  using Edge = std::pair<std::uint32_t, std::uint32_t>; // of the mesh
  const Eigen::Vector2d way = (line.to - line.from).normalized();
  const Eigen::Vector2d across = leftOf(way);
  std::vector<double> side;
  for (const Eigen::Vector3d& p : mesh.vertices)
    side.push_back(across.dot(p.head<2>() - line.from));
  std::multimap<Edge, Edge> next;
  std::map<Edge, Eigen::Vector2d> places;
  for (const Triangle& triangle : mesh.triangles) {
    std::array<Edge, 2> cut; // where the triangle is entered and left
    int cuts = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangle[k];
      const std::uint32_t b = triangle[(k + 1) % 3];
      if ((side[a] >= 0) == (side[b] >= 0))
        continue;
      const Edge edge = std::minmax(a, b);
      const Eigen::Vector3d& p = mesh.vertices[edge.first];
      const Eigen::Vector3d& q = mesh.vertices[edge.second];
      const double share = side[edge.first] / (side[edge.first] - side[edge.second]);
      const Eigen::Vector3d at = p + share * (q - p);
      places[edge] = {way.dot(at.head<2>() - line.from), at.z()};
      cut[side[a] >= 0 ? 1 : 0] = edge;
      ++cuts;
    }
    if (cuts == 2)
      next.insert({cut[0], cut[1]});
  }
  return loopsOf(std::move(next), places);
}

std::vector<PlanLoop>
outlinesOf(const TriangleMesh& mesh,
           const std::vector<std::size_t>& triangles,
           const std::function<Eigen::Vector2d(const Eigen::Vector3d&)>& place)
{
  std::vector<Triangle> faces;
  for (const std::size_t t : triangles)
    faces.push_back(mesh.triangles[t]);
  std::multimap<std::uint32_t, std::uint32_t> next;
  std::map<std::uint32_t, Eigen::Vector2d> places;
  for (const MeshEdge& edge : rimOf(faces)) {
    next.insert(edge);
    places[edge.first] = place(mesh.vertices[edge.first]);
  }
  return loopsOf(std::move(next), places);
}

std::vector<std::pair<double, double>>
rangesIn(const PlanLoop& loop, const SectionLine& line)
{
  constexpr double chord = 0.001; // metres
  const Eigen::Vector2d way = (line.to - line.from).normalized();
  const Eigen::Vector2d across = leftOf(way);
  const std::vector<Eigen::Vector2d> corners = loop.polygon(chord);
  std::vector<double> crossings;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Eigen::Vector2d a = corners[k] - line.from;
    const Eigen::Vector2d b = corners[(k + 1) % corners.size()] - line.from;
    const double from = across.dot(a);
    const double to = across.dot(b);
    if ((from >= 0) != (to >= 0))
      crossings.push_back(way.dot(a + from / (from - to) * (b - a)));
  }
  std::sort(crossings.begin(), crossings.end());
  std::vector<std::pair<double, double>> ranges;
  for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
    ranges.emplace_back(crossings[k], crossings[k + 1]);
  return ranges;
}

} // namespace pcl::sedr
