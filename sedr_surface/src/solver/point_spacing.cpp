// SPDX-License-Identifier: BSD-3-Clause
#include "point_spacing.h"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace pcl::sedr {
namespace {

// Returns the median spacing by area. Points twice as dense stand for a quarter of the
// area each. The weight of isolated points is limited.
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

double
measureSpacing(const std::vector<OrientedPoint>& points)
{
  constexpr int neighbours = 8;
  if (points.size() < neighbours + 2)
    return 0;
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  cloud->reserve(points.size());
  for (const OrientedPoint& p : points)
    cloud->emplace_back(p.position.x(), p.position.y(), p.position.z());
  pcl::KdTreeFLANN<pcl::PointXYZ> tree(false);
  tree.setInputCloud(cloud);
  const std::size_t step = std::max<std::size_t>(1, points.size() / 2000);
  std::vector<double> spacings;
  pcl::Indices indices;
  std::vector<float> squared;
  for (std::size_t i = 0; i < points.size(); i += step) {
    tree.nearestKSearch((*cloud)[i], neighbours + 1, indices, squared);
    // The disc to the eighth neighbour counts as seven points: its rim counts half.
    spacings.push_back(std::sqrt(M_PI * squared.back() / (neighbours - 1)));
  }
  return medianByArea(spacings);
}

} // namespace pcl::sedr
