// SPDX-License-Identifier: BSD-3-Clause
#include "solid_figures.h"

#include "sedr_surface/src/mesh/mesh_intersection.h"
#include "largest_error.h"
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_surface/mesh_distance.h>
#include <pcl/sedr_surface/mesh_topology.h>

#include <algorithm>
#include <cmath>

namespace pcl::sedr::benchmark {

namespace {

struct MeanAndMax {
  double mean = not_known;
  double max = not_known;
};

/** @brief Returns the distances from samples of one mesh to the other. Vertices only
 * count for the maximum, since fine facets have more of them. */
MeanAndMax
distancesFrom(const TriangleMesh& from, const TriangleMesh& to, unsigned threads)
{
  const MeshDistance distance(to);
  const auto samples =
      distance.distances(sampleMesh(from, sample_spacing, sample_seed).points, threads);
  const auto vertices = distance.distances(from.vertices, threads);
  const DistanceStatistics statistics = summarizeDistances(samples, 0);
  return {statistics.mean, std::max(statistics.max, *std::max_element(vertices.begin(),
                                                                      vertices.end()))};
}

TriangleMesh
partOf(const TriangleMesh& mesh, std::uint32_t room)
{
  TriangleMesh part = mesh;
  std::vector<bool> keep;
  for (const std::uint32_t r : mesh.rooms)
    keep.push_back(r == room);
  part.keepTriangles(keep);
  return part;
}

/** @brief Returns the square metres of walls and columns. */
double
wallAreaOf(const TriangleMesh& mesh)
{
  double area = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (mesh.labels[t] == static_cast<std::uint32_t>(StructureLabel::Wall) ||
        mesh.labels[t] == static_cast<std::uint32_t>(StructureLabel::Column))
      area += mesh.scaledNormal(t).norm() / 2;
  return area;
}

} // namespace

SolidFigures
measureSolid(const TriangleMesh& solid,
             const TriangleMesh& truth,
             const Floorplan& plan,
             const std::vector<sim::RoomTruth>& rooms,
             unsigned threads)
{
  SolidFigures figures;
  if (solid.empty())
    return figures;
  const MeshTopology topology = checkTopology(solid);
  figures.components = topology.components.size();
  figures.closed_manifold = topology.isClosedManifold();
  figures.self_intersections = findSelfIntersections(solid).size();
  figures.triangles = solid.triangles.size();

  const MeanAndMax of_truth = distancesFrom(truth, solid, threads);
  figures.truth_to_solid_mean = of_truth.mean;
  figures.truth_to_solid_max = of_truth.max;
  const MeanAndMax of_solid = distancesFrom(solid, truth, threads);
  figures.solid_to_truth_mean = of_solid.mean;
  figures.solid_to_truth_max = of_solid.max;

  for (const RoomPair& pair : matchRooms(plan, rooms)) {
    const TriangleMesh found = partOf(solid, plan.rooms[pair.found].id);
    const TriangleMesh real = partOf(truth, rooms[pair.truth].id);
    keepLargerError(figures.volume_error, found.signedVolume(), real.signedVolume());
    keepLargerError(figures.wall_area_error, wallAreaOf(found), wallAreaOf(real));
  }
  return figures;
}

} // namespace pcl::sedr::benchmark
