// SPDX-License-Identifier: BSD-3-Clause
#include "plan_samples.h"
#include <pcl/sedr_surface/mesh_distance.h>
#include <pcl/sedr_surface/room_solid.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr double sharp = 0.94;       ///< cosine of 20 degrees, between two faces
constexpr double zone = 2;           ///< in spacings, around an edge
constexpr double edge_spacing = 0.4; ///< relative to the spacing
constexpr std::uint64_t sample_seed = 1;

struct Edge {
  Eigen::Vector3d from;
  Eigen::Vector3d to;
};

/** @brief Returns the edges at which a solid's surface bends. */
std::vector<Edge>
sharpEdgesOf(const TriangleMesh& solid)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> triangles;
  for (std::size_t t = 0; t < solid.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      triangles[std::minmax(solid.triangles[t][k], solid.triangles[t][(k + 1) % 3])]
          .push_back(t);
  std::vector<Edge> edges;
  for (const auto& [ends, sides] : triangles)
    if (sides.size() != 2 || solid.scaledNormal(sides[0]).normalized().dot(
                                 solid.scaledNormal(sides[1]).normalized()) < sharp)
      edges.push_back({solid.vertices[ends.first], solid.vertices[ends.second]});
  return edges;
}

/** @brief Tests whether a place lies within `reach` of an edge. */
class EdgeZone {
public:
  EdgeZone(std::vector<Edge> edges, double reach)
      : edges_(std::move(edges))
      , reach_(reach)
  {}

  bool holds(const Eigen::Vector3d& p) const
  {
    return std::any_of(edges_.begin(), edges_.end(), [&](const Edge& edge) {
      const Eigen::Vector3d way = edge.to - edge.from;
      const double square = way.squaredNorm();
      const double share = square > 0 ? (p - edge.from).dot(way) / square : 0;
      return (edge.from + std::clamp(share, 0.0, 1.0) * way - p).squaredNorm() <=
             reach_ * reach_;
    });
  }

private:
  std::vector<Edge> edges_;
  double reach_;
};

} // namespace

PlanSamples
samplePlan(const PlanRoom& room, double spacing)
{
  PlanSamples samples;
  TriangleMesh solid;
  std::vector<SolidElement> elements;
  samples.problem = extrudeRoom(room, {}, solid, elements).problem;
  if (solid.empty())
    return samples;
  const EdgeZone edges(sharpEdgesOf(solid), zone * spacing);
  for (const bool at_edges : {false, true}) {
    const MeshSamples spread =
        sampleMesh(solid, at_edges ? edge_spacing * spacing : spacing, sample_seed);
    for (std::size_t i = 0; i < spread.points.size(); ++i) {
      if (edges.holds(spread.points[i]) != at_edges)
        continue;
      const std::size_t t = spread.triangles[i];
      samples.points.push_back({spread.points[i].cast<float>(),
                                -solid.scaledNormal(t).normalized().cast<float>()});
      samples.labels.push_back(solid.labels[t]);
    }
  }
  return samples;
}

} // namespace pcl::sedr
