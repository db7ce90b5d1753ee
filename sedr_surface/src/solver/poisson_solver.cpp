// SPDX-License-Identifier: BSD-3-Clause
#include "quiet_output.h"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>
#include <pcl/sedr_surface/poisson_solver.h>
#include <pcl/surface/poisson.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <mutex>

namespace pcl {
namespace sedr {
namespace {

std::mutex solver_mutex; // the octree of pcl::Poisson has a static allocator

pcl::PointCloud<pcl::PointNormal>::Ptr
toCloud(const std::vector<OrientedPoint>& points)
{
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  cloud->reserve(points.size());
  for (const OrientedPoint& p : points) {
    pcl::PointNormal point;
    point.getVector3fMap() = p.position;
    point.getNormalVector3fMap() = p.normal;
    cloud->push_back(point);
  }
  return cloud;
}

void
configure(pcl::Poisson<pcl::PointNormal>& poisson, const PoissonParameters& parameters)
{
  poisson.setDepth(parameters.depth);
  poisson.setMinDepth(std::min(parameters.min_depth, parameters.depth));
  // Below min_depth pcl::Poisson warns and raises them itself.
  poisson.setSolverDivide(std::max(parameters.solver_divide, parameters.min_depth));
  poisson.setIsoDivide(std::max(parameters.iso_divide, parameters.min_depth));
  poisson.setPointWeight(parameters.point_weight);
  poisson.setScale(parameters.scale);
  poisson.setSamplesPerNode(parameters.samples_per_node);
  poisson.setThreads(parameters.threads);
}

std::string
toMesh(const pcl::PointCloud<pcl::PointNormal>& cloud,
       const std::vector<pcl::Vertices>& polygons,
       TriangleMesh& mesh)
{
  mesh.vertices.reserve(cloud.size());
  for (const auto& point : cloud)
    mesh.vertices.push_back(point.getVector3fMap().cast<double>());
  std::vector<std::uint32_t> polygon;
  for (const auto& vertices : polygons) {
    polygon.assign(vertices.vertices.begin(), vertices.vertices.end());
    for (const auto v : polygon)
      if (v >= mesh.vertices.size())
        return "pcl::Poisson gave a polygon with a vertex out of range";
    triangulatePolygon(mesh.vertices, polygon, mesh.triangles);
  }
  if (mesh.empty())
    return "pcl::Poisson gave no triangles";
  return mesh.problem();
}

// The spacing that half of the surface has or exceeds: where points lie twice as dense,
// each stands for a quarter of the area. Stray points would stand for too much of it,
// so that is capped.
double
medianByArea(std::vector<double> spacings)
{
  std::sort(spacings.begin(), spacings.end());
  const double cap = 2 * spacings[spacings.size() / 2];
  const auto area = [cap](double spacing) {
    return std::pow(std::min(spacing, cap), 2);
  };
  double total = 0;
  for (const double spacing : spacings)
    total += area(spacing);
  double passed = 0;
  for (const double spacing : spacings)
    if ((passed += area(spacing)) >= total / 2)
      return spacing;
  return spacings.back();
}

} // namespace

std::string
solvePoisson(const std::vector<OrientedPoint>& points,
             const PoissonParameters& parameters,
             TriangleMesh& mesh,
             std::size_t& complaints)
{
  mesh = TriangleMesh();
  complaints = 0;
  if (points.size() < 3)
    return "pcl::Poisson needs at least 3 points, there are " +
           std::to_string(points.size());
  pcl::PointCloud<pcl::PointNormal> vertices;
  std::vector<pcl::Vertices> polygons;
  std::string reason;
  {
    const std::lock_guard<std::mutex> lock(solver_mutex);
    QuietOutput quiet;
    try {
      pcl::Poisson<pcl::PointNormal> poisson;
      configure(poisson, parameters);
      poisson.setInputCloud(toCloud(points));
      // Not reconstruct(): that would build a search tree which nobody asks.
      poisson.performReconstruction(vertices, polygons);
    }
    catch (const std::exception& problem) {
      reason = std::string("pcl::Poisson failed: ") + problem.what();
    }
    complaints = quiet.finish();
  }
  if (reason.empty())
    reason = toMesh(vertices, polygons, mesh);
  if (!reason.empty())
    mesh = TriangleMesh();
  return reason;
}

double
measureSpacing(const std::vector<OrientedPoint>& points)
{
  constexpr int neighbours = 8;
  if (points.size() < neighbours + 2)
    return 0;
  pcl::KdTreeFLANN<pcl::PointNormal> tree(false);
  const auto cloud = toCloud(points);
  tree.setInputCloud(cloud);
  const std::size_t step = std::max<std::size_t>(1, points.size() / 2000);
  std::vector<double> spacings;
  pcl::Indices indices;
  std::vector<float> squared;
  for (std::size_t i = 0; i < points.size(); i += step) {
    tree.nearestKSearch((*cloud)[i], neighbours + 1, indices, squared);
    // A disc as far as the eighth neighbour holds seven points: the rim counts half.
    spacings.push_back(std::sqrt(M_PI * squared.back() / (neighbours - 1)));
  }
  return medianByArea(spacings);
}

} // namespace sedr
} // namespace pcl
