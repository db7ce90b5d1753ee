// SPDX-License-Identifier: BSD-3-Clause
#include "../mesh/mesh_repair.h"
#include "../solver/surface_samples.h"
#include "screened_poisson.h"
#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/plan/plan_check.h"

#include <pcl/impl/instantiate.hpp>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_surface/impl/structural_poisson.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace pcl::sedr {
namespace {

// Minimum share of area far from all points at which a surface is rejected, and at
// which a warning is given.
constexpr double max_unsupported = 0.5;
constexpr double much_unsupported = 0.05;

// Minimum share of triangles on other surfaces that causes a warning.
constexpr double max_left_out = 1. / 3;

// Finest cell / spacing of the points: smaller cells hold more triangles, no more
// detail.
constexpr double cell_ratio = 0.8;

// With fewer points there is no room.
constexpr std::size_t min_points = 100;

// Surface farther from all points is inferred, metres; at least four spacings.
constexpr double support_distance = 0.3;

Eigen::Vector3d
centroidOf(const std::vector<OrientedPoint>& points)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const OrientedPoint& p : points)
    sum += p.position.cast<double>();
  return sum / static_cast<double>(points.size());
}

// Moves a mesh and rounds it to floats, so that what is checked is what is written.
void
move(TriangleMesh& mesh, const Eigen::Vector3d& by)
{
  for (Eigen::Vector3d& v : mesh.vertices)
    for (int k = 0; k < 3; ++k) {
      volatile float rounded =
          static_cast<float>(v[k] + by[k]); // volatile, or g++ 12 omits the rounding
      v[k] = static_cast<double>(rounded);
    }
}

// Reports why the mesh is not one closed surface.
void
checkRoom(const TriangleMesh& mesh, RoomPoissonReport& report)
{
  report.topology = checkTopology(mesh);
  report.problem = report.topology.problem();
  TriangleMesh copy = mesh;
  if (report.topology.components.size() > 1)
    report.problem += (report.problem.empty() ? "" : ", ") +
                      std::to_string(report.topology.components.size()) + " components";
  else if (report.problem.empty() && weldVertices(copy) > 0)
    report.problem = "vertices at equal positions";
  report.closed = report.problem.empty();
}

// Solves for the surface of points near the origin.
bool
solve(const std::vector<OrientedPoint>& local,
      const Eigen::Vector3d& centre,
      const RoomPoissonParameters& parameters,
      TriangleMesh& mesh,
      RoomPoissonReport& report)
{
  constexpr double margin = 1.1; // of the octree's cube, to which the depth refers
  constexpr int max_depth = 14;  // as problemOf() allows
  constexpr double coarse = 8;   // times the cells that the points deserve
  Eigen::AlignedBox3f box;
  for (const OrientedPoint& p : local)
    box.extend(p.position);
  const double extent = box.sizes().cast<double>().maxCoeff();
  if (!(extent <= max_coordinate)) {
    report.problem = "its points extend over more than " +
                     shortDecimalText(max_coordinate, 0) +
                     " m: remove those that are far from the others";
    return false;
  }
  report.spacing = measureSpacing(local);
  if (!(report.spacing > 0) || !(extent > 4 * report.spacing)) {
    report.problem = "the " + std::to_string(local.size()) + " points extend over " +
                     shortDecimalText(extent, 3) + " m only";
    return false;
  }
  const double wanted = report.spacing * cell_ratio;
  const auto depth =
      static_cast<int>(std::ceil(std::log2(margin * extent / wanted) - 1e-9));
  if (depth > max_depth) {
    report.problem = "its points are " + shortDecimalText(report.spacing, 3) +
                     " m apart, but extend over " + shortDecimalText(extent, 3) +
                     " m: remove those that are far from the others "
                     "(pcl_grid_region_outlier_removal)";
    return false;
  }
  report.depth = std::clamp(depth, 3, parameters.depth);
  ScreenedPoissonParameters solver;
  const double coarsest =
      std::max(wanted, margin * extent / std::ldexp(1., report.depth));
  solver.cell = coarsest;
  solver.spacing = report.spacing;
  solver.threads = parameters.threads;
  report.problem = screenedPoisson(local, solver, mesh);
  report.cell = solver.cell;
  if (!report.problem.empty())
    return false;
  if (report.cell > 1.001 * coarsest || report.cell > coarse * wanted)
    report.warning = "its cells are " + shortDecimalText(report.cell, 3) +
                     " m instead of " + shortDecimalText(wanted, 3) +
                     " m, for it extends over " + shortDecimalText(extent, 3) + " m";
  move(mesh, centre);
  const RemovedComponents removed = keepLargestComponent(mesh);
  report.removed_components = removed.components;
  report.removed_triangles = removed.triangles;
  mesh.removeUnusedVertices();
  checkRoom(mesh, report);
  if (!report.closed) { // far from the origin, floats may coincide
    report.parted_vertices = partEqualPositions(mesh);
    checkRoom(mesh, report);
  }
  return !mesh.empty();
}

// Finds points near triangles.
class NearestPoints {
public:
  explicit NearestPoints(const std::vector<OrientedPoint>& points)
      : points_(points)
      , origin_(centroidOf(points))
      , tree_(true)
  {
    auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
    for (const OrientedPoint& p : points)
      cloud->push_back(near(p.position.cast<double>()));
    tree_.setInputCloud(cloud);
  }

  // Returns the point nearest to the centre of a triangle that lies on its face, in
  // either orientation: near an edge there are points of two faces. The nearest one if
  // none of the candidates does.
  std::uint32_t find(const TriangleMesh& mesh,
                     std::size_t t,
                     const Eigen::Vector3d& normal,
                     float& distance) const
  {
    constexpr int candidates = 6;
    constexpr double same = 0.7; // cosine of 45 degrees
    const pcl::PointXYZ middle =
        near((mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3);
    const auto isOnFace = [&](pcl::index_t i) {
      return std::abs(points_[static_cast<std::size_t>(i)].normal.cast<double>().dot(
                 normal)) > same * normal.norm();
    };
    pcl::Indices indices(1);
    std::vector<float> squared(1);
    tree_.nearestKSearch(middle, 1, indices, squared);
    distance = std::sqrt(squared[0]);
    if (!isOnFace(indices[0]))
      tree_.nearestKSearch(middle, candidates, indices, squared);
    const auto found = std::find_if(indices.begin(), indices.end(), isOnFace);
    return static_cast<std::uint32_t>(found == indices.end() ? indices[0] : *found);
  }

private:
  pcl::PointXYZ near(const Eigen::Vector3d& place) const
  {
    const Eigen::Vector3f p = (place - origin_).cast<float>();
    return {p.x(), p.y(), p.z()};
  }

  const std::vector<OrientedPoint>& points_;
  Eigen::Vector3d origin_;
  pcl::KdTreeFLANN<pcl::PointXYZ> tree_;
};

// Reports what of the surface is far from all points, and what was removed.
void
judge(double far_area, double support, RoomPoissonReport& report)
{
  report.unsupported_share = report.area > 0 ? far_area / report.area : 0;
  if (report.unsupported_share > max_unsupported) {
    report.closed = false;
    report.problem =
        "the points enclose nothing: " + percentText(report.unsupported_share) +
        " of its surface lies further than " + shortDecimalText(support, 3) +
        " m from all of them";
  }
  else if (report.unsupported_share > much_unsupported)
    report.warning = percentText(report.unsupported_share) +
                     " of its surface is a guess, further than " +
                     shortDecimalText(support, 3) + " m from all points";
  const auto left_out = static_cast<double>(report.removed_triangles);
  const double share =
      left_out /
      std::max(1., left_out + static_cast<double>(report.topology.triangles));
  if (share >= max_left_out)
    report.warning +=
        (report.warning.empty() ? "its points have " : "; its points have ") +
        std::to_string(report.removed_components + 1) +
        " surfaces, of which only the largest is kept: " + percentText(share) +
        " of the triangles are left out";
}

// Orients the surface like the points' normals and measures its area, volume and
// unsupported share. Returns for each triangle the point nearest to its centre.
std::vector<std::uint32_t>
compareWithPoints(const std::vector<OrientedPoint>& points,
                  const RoomPoissonParameters& parameters,
                  TriangleMesh& mesh,
                  RoomPoissonReport& report)
{
  const NearestPoints tree(points);
  std::vector<std::uint32_t> nearest(mesh.triangles.size());
  std::vector<float> distance(mesh.triangles.size());
  parallelFor(nearest.size(), 4096, parameters.threads, [&](std::size_t t) {
    nearest[t] = tree.find(mesh, t, mesh.scaledNormal(t), distance[t]);
  });
  const double support = std::max(support_distance, 4 * report.spacing);
  double agreement = 0;
  double far_area = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Eigen::Vector3d normal = mesh.scaledNormal(t);
    agreement += normal.dot(points[nearest[t]].normal.cast<double>());
    if (distance[t] > support)
      far_area += normal.norm() / 2;
  }
  if (agreement < 0)
    mesh.flip();
  report.area = mesh.area();
  report.volume = std::abs(mesh.signedVolume());
  judge(far_area, support, report);
  return nearest;
}

/** @brief Makes the surface of a room by screened Poisson: solved near the origin,
 * reduced to its largest component, with the label of the nearest point.
 * @param samples finite, with unit normals, on whose side those of the mesh are
 * @param parameters in range
 * @return an empty mesh if there is no surface; it is closed if the report says so */
RoomSurface
surfaceOf(const RoomSamples& samples, const RoomPoissonParameters& parameters)
{
  RoomSurface surface;
  TriangleMesh& mesh = surface.mesh;
  RoomPoissonReport& report = surface.report;
  const std::vector<OrientedPoint>& points = samples.points;
  report.room = samples.room;
  report.points = points.size();
  report.skipped_points = samples.skipped;
  report.scaled_normals = samples.scaled;
  if (points.size() < min_points) {
    report.problem = std::to_string(min_points) +
                     " points with normals are needed, there are " +
                     std::to_string(points.size());
    return surface;
  }
  // Solved near the origin, where floats have precision to spare.
  const Eigen::Vector3d centre = centroidOf(points);
  std::vector<OrientedPoint> local = points;
  for (OrientedPoint& p : local)
    p.position = (p.position.cast<double>() - centre).cast<float>();
  if (!solve(local, centre, parameters, mesh, report))
    return surface;
  const auto nearest = compareWithPoints(points, parameters, mesh, report);
  mesh.rooms.assign(mesh.triangles.size(), samples.room);
  if (!samples.labels.empty())
    for (const auto i : nearest)
      mesh.labels.push_back(samples.labels[i]);
  return surface;
}

/** @brief Calls `work(i, threads)` for each room. Threads that share one room wait for
 * each other at every step, so every thread has a room of its own; only rooms that
 * exceed one thread's share of the work come first, on all threads. */
void
forEachRoom(const std::vector<std::size_t>& sizes,
            unsigned threads,
            const std::function<void(std::size_t, unsigned)>& work)
{
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  std::size_t left = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
  std::size_t next = 0;
  for (; next < order.size() && sizes[order[next]] * threads > left; ++next) {
    work(order[next], threads);
    left -= sizes[order[next]];
  }
  parallelBlocks(order.size() - next, 1, threads,
                 [&](std::size_t k, std::size_t) { work(order[next + k], 1); });
}

} // namespace

std::string
problemOf(const RoomPoissonParameters& parameters)
{
  return parameters.depth >= 3 && parameters.depth <= 14
             ? ""
             : "the depth must lie from 3 to 14, it is " +
                   std::to_string(parameters.depth);
}

void
makeSurfaces(std::map<std::uint32_t, RoomSamples>& rooms,
             const RoomPoissonParameters& parameters,
             const RoomSharing& sharing,
             TriangleMesh& mesh,
             std::vector<RoomPoissonReport>& reports)
{
  std::vector<RoomSamples*> all;
  std::vector<std::size_t> mine;
  std::vector<std::size_t> sizes;
  for (auto& [number, room] : rooms) {
    if (!sharing.is_mine || sharing.is_mine(all.size())) {
      mine.push_back(all.size());
      sizes.push_back(room.points.size());
    }
    all.push_back(&room);
  }
  std::vector<RoomSurface> surfaces(all.size());
  forEachRoom(
      sizes, resolveThreads(parameters.threads), [&](std::size_t k, unsigned threads) {
        const RoomSamples room = std::move(*all[mine[k]]); // freed with the call
        surfaces[mine[k]] = surfaceOf(room, {parameters.depth, threads});
      });
  if (sharing.complete)
    sharing.complete(surfaces);
  for (RoomSurface& surface : surfaces) {
    mesh.append(surface.mesh);
    reports.push_back(std::move(surface.report));
    surface = {}; // frees it
  }
}

std::string
summaryOf(const std::vector<RoomPoissonReport>& reports)
{
  std::string sentences;
  const auto add = [&](const std::string& sentence) {
    sentences += (sentences.empty() ? "" : "; ") + sentence;
  };
  for (const RoomPoissonReport& report : reports) {
    const std::size_t all = report.points + report.skipped_points;
    if (report.skipped_points > 0)
      PCL_WARN("[pcl::StructuralPoisson] room %u: %zu of %zu points are not finite or "
               "have no normal\n",
               report.room, report.skipped_points, all);
    if (report.scaled_normals > 0)
      PCL_WARN("[pcl::StructuralPoisson] room %u: %zu of %zu normals were not of unit "
               "length\n",
               report.room, report.scaled_normals, all);
    const std::string room = "room " + std::to_string(report.room);
    if (!report.problem.empty())
      add(room +
          (report.topology.triangles > 0 ? " is not closed: " : " has no surface: ") +
          report.problem);
    if (!report.warning.empty())
      add(room + ": " + report.warning);
  }
  return sentences;
}

} // namespace pcl::sedr

PCL_INSTANTIATE(StructuralPoisson, SEDR_POINT_TYPES)
