// SPDX-License-Identifier: BSD-3-Clause
#include "triangle_tree.h"

#include "sedr_filters/src/base/parallel_for.h"
#include <pcl/sedr_surface/mesh_distance.h>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

MeshDistance::MeshDistance(const TriangleMesh& mesh, unsigned threads)
    : tree_(std::make_unique<TriangleTree>(mesh, threads))
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

} // namespace pcl::sedr
