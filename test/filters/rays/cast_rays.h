// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/rays/mirrored_points.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/sedr_filters/parallel_voxel_grid.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace sedr_test {

using Box = Eigen::AlignedBox3d;
using Eigen::Vector3d;
using Eigen::Vector3f;
using pcl::sedr::findMirroredPoints;
using pcl::sedr::MirroredPoints;
using pcl::sedr::PointView;
using pcl::sedr::ScanPositions;

/** Returns the distances at which a ray enters and leaves a box; the first is larger if
 * it misses the box. */
inline std::pair<double, double>
crossingsOf(const Box& box, const Vector3d& from, const Vector3d& direction)
{
  double low = 0;
  double high = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (box.min()[axis] - from[axis]) / direction[axis];
    const double b = (box.max()[axis] - from[axis]) / direction[axis];
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  }
  return {low, high};
}

/** Two rooms side by side, with a pane of 3.4 x 2 m in the wall of 20 cm between them,
 * and what rays in all directions see of them from some positions. */
class GlazedRooms {
public:
  double returned = 0.05; ///< share of the rays at the pane; 1: a wall
  double mirrored = 0;    ///< share of them that see an image of their room behind it
  bool has_second = true; ///< else what goes through the pane is lost

  explicit GlazedRooms(bool is_furnished)
  {
    if (is_furnished)
      boxes_ = {{Vector3d(1.5, 3.5, 0), Vector3d(2.2, 4, 1.9)},
                {Vector3d(3.7, 0.4, 0), Vector3d(4.2, 1.2, 2.1)},
                {Vector3d(0, 2, 0), Vector3d(0.5, 3, 2.2)},
                {Vector3d(8.9, 3, 0), Vector3d(9.6, 4.4, 1.6)},
                {Vector3d(10.2, 0.3, 0), Vector3d(11, 1.5, 2.2)}};
  }

  void scanFrom(const Vector3d& place, int rays)
  {
    positions.push_back({rows.size(), place.cast<float>()});
    for (int i = 0; i < rays; ++i) {
      const double up = 2 * uniform_(random_) - 1;
      const double around = 2 * M_PI * uniform_(random_);
      const double level = std::sqrt(1 - up * up);
      see(place, {level * std::cos(around), level * std::sin(around), up});
    }
  }

  /** @param voxel edge of those that are thinned to one point; 0: all points */
  MirroredPoints found(const ScanPositions& from, float voxel = 0) const
  {
    const PointView all(rows.data(), sizeof(Vector3f), rows.size());
    if (voxel == 0)
      return findMirroredPoints(all, all, 1, from, 2);
    const auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
    for (const Vector3f& p : rows)
      cloud->emplace_back(p.x(), p.y(), p.z());
    pcl::PointCloud<pcl::PointXYZ> thinned;
    pcl::ParallelVoxelGrid<pcl::PointXYZ> grid;
    grid.setInputCloud(cloud);
    grid.setLeafSize(voxel, voxel, voxel);
    grid.filter(thinned);
    return findMirroredPoints(PointView(thinned), all, 1, from, 2);
  }

  MirroredPoints found() const { return found(positions); }

  std::vector<Vector3f> rows;
  std::vector<bool> is_image; ///< per row
  ScanPositions positions;

private:
  Vector3d hitFrom(const Vector3d& from, const Vector3d& direction) const
  {
    double range =
        crossingsOf(rooms_[from.x() < middle ? 0 : 1], from, direction).second;
    for (const Box& box : boxes_)
      if (const auto [enters, leaves] = crossingsOf(box, from, direction);
          enters < leaves)
        range = std::min(range, enters);
    return from + range * direction;
  }

  void see(const Vector3d& from, const Vector3d& direction)
  {
    const Vector3d hit = hitFrom(from, direction);
    const double fate = uniform_(random_);
    const bool is_pane = std::abs(hit.x() - middle) < 0.11 && hit.y() > 0.8 &&
                         hit.y() < 4.2 && hit.z() > 0.4 && hit.z() < 2.4;
    if (!is_pane || fate < returned)
      return add(hit, false);
    if (fate < returned + mirrored) {
      const Vector3d turned(-direction.x(), direction.y(), direction.z());
      Vector3d image = hitFrom(hit - 1e-6 * direction, turned);
      image.x() = 2 * hit.x() - image.x();
      return add(image, true);
    }
    if (has_second)
      add(hitFrom(hit + 0.2001 / std::abs(direction.x()) * direction, direction),
          false);
  }

  void add(const Vector3d& p, bool is_image_of_another)
  {
    rows.push_back(p.cast<float>());
    is_image.push_back(is_image_of_another);
  }

  static constexpr double middle = 6.1;
  const Box rooms_[2] = {{Vector3d(0, 0, 0), Vector3d(6, 5, 2.6)},
                         {Vector3d(6.2, -2, 0), Vector3d(14, 5, 3.1)}};
  std::vector<Box> boxes_;
  std::mt19937 random_{1};
  std::uniform_real_distribution<double> uniform_{0, 1};
};

} // namespace sedr_test
