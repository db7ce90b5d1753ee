// SPDX-License-Identifier: BSD-3-Clause
#include "structure_figures.h"

#include "solid_figures.h"

#include "nearest_points.h"

#include <pcl/sedr_surface/mesh_distance.h>

#include <algorithm>
#include <vector>

namespace pcl::sedr::benchmark {

namespace {

double
coveredShare(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& structure,
             const TriangleMesh& truth,
             unsigned threads)
{
  pcl::PointCloud<pcl::PointXYZ> samples;
  for (const Eigen::Vector3d& p :
       sampleMesh(truth, sample_spacing, sample_seed).points) {
    const Eigen::Vector3f q = p.cast<float>();
    samples.emplace_back(q.x(), q.y(), q.z());
  }
  const auto nearest = nearestWithin(structure, samples, point_reach, threads);
  const auto bare = std::count(nearest.begin(), nearest.end(), -1);
  return 1 - static_cast<double>(bare) / static_cast<double>(nearest.size());
}

} // namespace

StructureFigures
measureStructure(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& structure,
                 const TriangleMesh& truth,
                 unsigned threads)
{
  StructureFigures figures;
  if (structure->empty())
    return figures;
  std::vector<Eigen::Vector3d> points;
  points.reserve(structure->size());
  for (const auto& p : *structure)
    points.push_back(p.getVector3fMap().cast<double>());
  const auto distances =
      summarizeDistances(MeshDistance(truth).distances(points, threads));
  figures.points_to_truth_mean = distances.mean;
  figures.points_to_truth_max = distances.max;
  figures.points_beyond_5cm = 1 - distances.within_5cm;
  figures.truth_covered = coveredShare(structure, truth, threads);
  return figures;
}

} // namespace pcl::sedr::benchmark
