// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/base/parallel.h"
#include <pcl/sedr_surface/mesh_evaluation.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <unsupported/Eigen/BVH>

namespace pcl::sedr {

namespace {

/** @brief Returns the squared distance of the origin from a segment. */
double
squaredToSegment(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const Eigen::Vector3d way = b - a;
  const double length = way.squaredNorm();
  const double t = length > 0 ? std::clamp(-a.dot(way) / length, 0.0, 1.0) : 0.0;
  return (a + t * way).squaredNorm();
}

/** @brief Likewise from a triangle, which may be degenerate. */
double
squaredToTriangle(const Eigen::Vector3d& a,
                  const Eigen::Vector3d& b,
                  const Eigen::Vector3d& c)
{
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const double length = normal.squaredNorm();
  if (length > 0 && normal.dot(a.cross(b)) >= 0 && normal.dot(b.cross(c)) >= 0 &&
      normal.dot(c.cross(a)) >= 0) {
    const double height = normal.dot(a);
    return height * height / length;
  }
  return std::min(
      {squaredToSegment(a, b), squaredToSegment(b, c), squaredToSegment(c, a)});
}

} // namespace

/** @brief A tree of boxes over the triangles of a mesh. */
class TriangleTree {
public:
  explicit TriangleTree(const TriangleMesh& mesh)
      : mesh_(mesh)
  {
    std::vector<std::uint32_t> triangles(mesh.triangles.size());
    std::iota(triangles.begin(), triangles.end(), 0);
    std::vector<Eigen::AlignedBox3d> boxes(triangles.size());
    for (std::size_t t = 0; t < boxes.size(); ++t)
      for (int c = 0; c < 3; ++c)
        boxes[t].extend(mesh.corner(t, c));
    tree_.init(triangles.begin(), triangles.end(), boxes.begin(), boxes.end());
  }

  double distance(const Eigen::Vector3d& point) const
  {
    const Nearest nearest{mesh_, point};
    return std::sqrt(Eigen::BVMinimize(tree_, nearest));
  }

private:
  /** @brief What Eigen::BVMinimize() minimises: squared distances from a point. */
  struct Nearest {
    using Scalar = double;
    const TriangleMesh& mesh;
    const Eigen::Vector3d& point;

    double minimumOnVolume(const Eigen::AlignedBox3d& box) const
    {
      return box.squaredExteriorDistance(point);
    }
    double minimumOnObject(std::uint32_t t) const
    {
      return squaredToTriangle(mesh.corner(t, 0) - point, mesh.corner(t, 1) - point,
                               mesh.corner(t, 2) - point);
    }
  };

  using Tree = Eigen::KdBVH<double, 3, std::uint32_t>;

  const TriangleMesh& mesh_;
  Tree tree_;
};

MeshDistance::MeshDistance(const TriangleMesh& mesh)
    : tree_(std::make_unique<TriangleTree>(mesh))
{}

MeshDistance::~MeshDistance() = default;

std::vector<double>
MeshDistance::distances(const std::vector<Eigen::Vector3d>& points,
                        unsigned threads) const
{
  std::vector<double> result(points.size());
  parallelFor(points.size(), 4096, threads,
              [&](std::size_t i) { result[i] = tree_->distance(points[i]); });
  return result;
}

DistanceStatistics
summarizeDistances(std::vector<double> distances, std::size_t bins, double range)
{
  DistanceStatistics statistics;
  statistics.count = distances.size();
  statistics.histogram_range = range;
  statistics.histogram.assign(bins, 0);
  if (distances.empty())
    return statistics;
  std::sort(distances.begin(), distances.end());
  const auto n = static_cast<double>(distances.size());
  double sum = 0;
  double squares = 0;
  for (const double d : distances) {
    sum += d;
    squares += d * d;
    const double bin = std::floor(d / range * static_cast<double>(bins));
    if (bin < static_cast<double>(bins))
      ++statistics.histogram[static_cast<std::size_t>(bin)];
    else
      ++statistics.beyond_histogram;
  }
  const auto quantile = [&](double share) {
    const auto rank = static_cast<std::size_t>(std::ceil(share * n));
    return distances[std::max<std::size_t>(rank, 1) - 1];
  };
  const auto shareWithin = [&](double limit) {
    const auto end = std::upper_bound(distances.begin(), distances.end(), limit);
    return static_cast<double>(end - distances.begin()) / n;
  };
  statistics.mean = sum / n;
  statistics.rms = std::sqrt(squares / n);
  statistics.median = quantile(0.5);
  statistics.p95 = quantile(0.95);
  statistics.p99 = quantile(0.99);
  statistics.max = distances.back();
  statistics.within_1cm = shareWithin(0.01);
  statistics.within_5cm = shareWithin(0.05);
  return statistics;
}

namespace {

// The splitmix64 generator: a well-mixed number for every count.
std::uint64_t
mix(std::uint64_t x)
{
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

// Maps to [0, 1).
double
unit(std::uint64_t x)
{
  return static_cast<double>(mix(x) >> 11) * 0x1p-53;
}

double
fraction(double x)
{
  return x - std::floor(x);
}

// Returns the j-th point of a low-discrepancy sequence in the triangle (Roberts' R2,
// folded), which starts at a position chosen by the seed.
Eigen::Vector3d
pointInTriangle(const TriangleMesh& mesh,
                std::size_t t,
                std::uint64_t j,
                std::uint64_t seed)
{
  const std::uint64_t key = mix(seed ^ mix(t));
  const auto step = static_cast<double>(j);
  double u = fraction(unit(key) + 0.7548776662466927 * step);
  double v = fraction(unit(key + 1) + 0.5698402909980532 * step);
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  const Eigen::Vector3d& a = mesh.corner(t, 0);
  return a + u * (mesh.corner(t, 1) - a) + v * (mesh.corner(t, 2) - a);
}

} // namespace

MeshSamples
sampleMesh(const TriangleMesh& mesh,
           double spacing,
           std::uint64_t seed,
           std::size_t max_samples)
{
  MeshSamples samples;
  std::vector<double> summed_area;
  summed_area.reserve(mesh.triangles.size());
  double area = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    summed_area.push_back(area += mesh.scaledNormal(t).norm() / 2);
  if (area <= 0)
    return samples;
  // Slightly less, so that rounding does not add a sample.
  const double wanted = std::ceil(area / (spacing * spacing) * (1 - 1e-12));
  const std::size_t count = wanted < static_cast<double>(max_samples)
                                ? static_cast<std::size_t>(wanted)
                                : max_samples;
  samples.spacing = std::sqrt(area / static_cast<double>(count));
  samples.points.reserve(count);
  samples.triangles.reserve(count);
  std::size_t t = 0;
  std::uint64_t in_triangle = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = area * (static_cast<double>(i) + unit(mix(seed) + i)) /
                      static_cast<double>(count);
    for (; t + 1 < summed_area.size() && summed_area[t] <= at; ++t)
      in_triangle = 0;
    samples.points.push_back(pointInTriangle(mesh, t, in_triangle++, seed));
    samples.triangles.push_back(static_cast<std::uint32_t>(t));
  }
  return samples;
}

} // namespace pcl::sedr
