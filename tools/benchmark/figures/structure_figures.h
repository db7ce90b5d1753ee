// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model_figures.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <cmath>

namespace pcl::sedr::benchmark {

/** @brief Maximum distance in metres at which a point of the structure covers a point
 * of the truth. The structure has a point per voxel of 5 cm. */
constexpr double point_reach = 0.08;

/** @brief Quality figures of a structure's points, before meshing. Metres and shares
 * from 0 to 1; NaN where not measured. */
struct StructureFigures {
  double points_to_truth_mean = not_known;
  double points_to_truth_max = not_known;
  double points_beyond_5cm = not_known; ///< share of the points
  double truth_covered = not_known;     ///< share of the true area within point_reach

  bool isMeasured() const { return !std::isnan(points_to_truth_mean); }
};

/** @brief Measures points, all finite, against the truth; without points, all is NaN.
 */
StructureFigures
measureStructure(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& structure,
                 const TriangleMesh& truth,
                 unsigned threads = 0);

} // namespace pcl::sedr::benchmark
