// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/parallel.h>
#include <pcl/sedr_surface/mesh_distance.h>

#include <vtkCellArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace sedr {

struct MeshDistance::Locator {
  vtkNew<vtkPolyData> surface;
  vtkNew<vtkStaticCellLocator> locator;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
};

MeshDistance::MeshDistance(const TriangleMesh& mesh)
    : locator_(std::make_unique<Locator>())
{
  // Near the origin, so that the locator's tolerances mean what they should.
  locator_->origin = mesh.bounds().center();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    const Eigen::Vector3d p = vertex - locator_->origin;
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkCellArray> lines;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& triangle = mesh.triangles[t];
    const vtkIdType ids[4] = {triangle[0], triangle[1], triangle[2], triangle[0]};
    // VTK finds no nearest point on a triangle without area; its sides are all there is
    // of it.
    if (mesh.scaledNormal(t).norm() > 0)
      triangles->InsertNextCell(3, ids);
    else
      for (int i = 0; i < 3; ++i)
        lines->InsertNextCell(2, ids + i);
  }
  locator_->surface->SetPoints(points);
  locator_->surface->SetPolys(triangles);
  locator_->surface->SetLines(lines);
  locator_->locator->SetDataSet(locator_->surface);
  locator_->locator->BuildLocator();
}

MeshDistance::~MeshDistance() = default;

std::vector<double>
MeshDistance::distances(const std::vector<Eigen::Vector3d>& points,
                        unsigned threads) const
{
  std::vector<double> result(points.size());
  parallelBlocks(points.size(), 4096, threads, [&](std::size_t begin, std::size_t end) {
    vtkNew<vtkGenericCell> cell;
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3d p = points[i] - locator_->origin;
      double nearest[3];
      vtkIdType id = -1;
      int part = 0;
      double squared = 0;
      locator_->locator->FindClosestPoint(p.data(), nearest, cell, id, part, squared);
      result[i] = (p - Eigen::Map<const Eigen::Vector3d>(nearest)).norm();
    }
  });
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

} // namespace sedr
} // namespace pcl
