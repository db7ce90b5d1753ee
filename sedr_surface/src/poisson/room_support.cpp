// SPDX-License-Identifier: BSD-3-Clause
#include "room_support.h"

#include "sedr_filters/src/base/parallel.h"
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace pcl::sedr {
namespace {

using Tree = pcl::KdTreeFLANN<pcl::PointXYZ>;

void
buildTree(const std::vector<OrientedPoint>& points,
          const Eigen::Vector3d& origin,
          Tree& tree)
{
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const OrientedPoint& p : points) {
    const Eigen::Vector3f q = (p.position.cast<double>() - origin).cast<float>();
    cloud->push_back({q.x(), q.y(), q.z()});
  }
  tree.setInputCloud(cloud);
}

// Returns whether a triangle may lie on the face of a point, in either orientation.
bool
sameFace(const OrientedPoint& point, const Eigen::Vector3d& normal)
{
  constexpr double same = 0.7; // cosine of 45 degrees
  return std::abs(point.normal.cast<double>().dot(normal)) > same * normal.norm();
}

// Returns which of the points, nearest first, lies on the face of a triangle with this
// normal; near an edge there are points of two faces. The first if none does.
std::size_t
onSameFace(const std::vector<OrientedPoint>& points,
           const pcl::Indices& indices,
           const Eigen::Vector3d& normal)
{
  for (std::size_t i = 0; i < indices.size(); ++i)
    if (sameFace(points[static_cast<std::size_t>(indices[i])], normal))
      return i;
  return 0;
}

// Finds the point nearest to the centre of each triangle, and its distance.
void
findNearest(const std::vector<OrientedPoint>& points,
            const TriangleMesh& mesh,
            unsigned threads,
            std::vector<std::uint32_t>& nearest,
            std::vector<float>& distance)
{
  constexpr int around = 6; // candidates, one of which lies on the right face
  const Eigen::Vector3d origin = centroidOf(points);
  Tree tree(true);
  buildTree(points, origin, tree);
  nearest.resize(mesh.triangles.size());
  distance.resize(mesh.triangles.size());
  parallelBlocks(
      mesh.triangles.size(), 4096, threads, [&](std::size_t begin, std::size_t end) {
        pcl::Indices indices(1);
        std::vector<float> squared(1);
        for (std::size_t t = begin; t < end; ++t) {
          const Eigen::Vector3d middle =
              (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3 - origin;
          const Eigen::Vector3f q = middle.cast<float>();
          const pcl::PointXYZ place(q.x(), q.y(), q.z());
          const Eigen::Vector3d normal = mesh.scaledNormal(t);
          tree.nearestKSearch(place, 1, indices, squared);
          distance[t] = std::sqrt(squared[0]);
          const auto first = static_cast<std::size_t>(indices[0]);
          if (!sameFace(points[first], normal))
            tree.nearestKSearch(place, around, indices, squared);
          nearest[t] =
              static_cast<std::uint32_t>(indices[onSameFace(points, indices, normal)]);
        }
      });
}

// Minimum share of area far from all points at which a surface is rejected.
constexpr double max_unsupported = 0.5;

// Minimum share of triangles on other surfaces that causes a warning.
constexpr double max_left_out = 1. / 3;

// Returns a warning about surfaces left out beside the largest, or empty.
std::string
leftOutBeside(const TriangleMesh& largest, const RoomPoissonReport& report)
{
  const auto left_out = static_cast<double>(report.removed_triangles);
  const double share =
      left_out / std::max(1., left_out + static_cast<double>(largest.triangles.size()));
  if (share < max_left_out)
    return {};
  return "its points have " + std::to_string(report.removed_components + 1) +
         " surfaces, of which only the largest is kept: " +
         std::to_string(std::lround(100 * share)) + " % of the triangles are left out";
}

double
supportDistance(const RoomPoissonParameters& parameters,
                const RoomPoissonReport& report)
{
  return std::max(parameters.support_distance, 4 * report.spacing);
}

} // namespace

std::string
shortNumber(double value)
{
  std::ostringstream text;
  text << std::setprecision(3) << value;
  return text.str();
}

Eigen::Vector3d
centroidOf(const std::vector<OrientedPoint>& points)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const OrientedPoint& p : points)
    sum += p.position.cast<double>();
  return sum / static_cast<double>(points.size());
}

void
compareWithPoints(const std::vector<OrientedPoint>& points,
                  const RoomPoissonParameters& parameters,
                  TriangleMesh& mesh,
                  std::vector<std::uint32_t>& nearest,
                  RoomPoissonReport& report)
{
  std::vector<float> distance;
  findNearest(points, mesh, parameters.threads, nearest, distance);
  double agreement = 0;
  double far_area = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Eigen::Vector3d normal = mesh.scaledNormal(t);
    agreement += normal.dot(points[nearest[t]].normal.cast<double>());
    if (distance[t] > supportDistance(parameters, report))
      far_area += normal.norm() / 2;
  }
  if (agreement < 0)
    mesh.flip();
  report.area = mesh.area();
  report.volume = std::abs(mesh.signedVolume());
  report.unsupported_share = report.area > 0 ? far_area / report.area : 0;
  if (report.unsupported_share > max_unsupported) {
    report.closed = false;
    report.problem = "the points enclose nothing: " +
                     std::to_string(std::lround(100 * report.unsupported_share)) +
                     " % of its surface lies further than " +
                     shortNumber(supportDistance(parameters, report)) +
                     " m from all of them";
  }
  else if (report.unsupported_share > 0.05)
    report.warning = std::to_string(std::lround(100 * report.unsupported_share)) +
                     " % of its surface is a guess, further than " +
                     shortNumber(supportDistance(parameters, report)) +
                     " m from all points";
  const std::string left_out = leftOutBeside(mesh, report);
  if (!left_out.empty())
    report.warning += (report.warning.empty() ? "" : "; ") + left_out;
}

} // namespace pcl::sedr
