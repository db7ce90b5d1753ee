// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/types.h>

#include <vector>

namespace pcl::sedr::benchmark {

/** @brief Returns the point of `cloud` nearest to each query, or -1 if none is within
 * `radius` metres. The queries must be finite. O((n + q) log n); the result does not
 * depend on the number of threads. */
std::vector<pcl::index_t>
nearestWithin(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud,
              const pcl::PointCloud<pcl::PointXYZ>& queries,
              double radius,
              unsigned threads = 0);

} // namespace pcl::sedr::benchmark
