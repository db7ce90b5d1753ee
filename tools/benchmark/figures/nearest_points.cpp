// SPDX-License-Identifier: BSD-3-Clause
#include "nearest_points.h"

#include "sedr_filters/src/base/parallel.h"
#include <pcl/search/kdtree.h>

namespace pcl::sedr::benchmark {

std::vector<pcl::index_t>
nearestWithin(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud,
              const pcl::PointCloud<pcl::PointXYZ>& queries,
              double radius,
              unsigned threads)
{
  std::vector<pcl::index_t> nearest(queries.size(), -1);
  if (cloud->empty())
    return nearest;
  pcl::search::KdTree<pcl::PointXYZ> tree;
  tree.setInputCloud(cloud);
  const auto limit = static_cast<float>(radius * radius);
  parallelBlocks(queries.size(), 4096, threads,
                 [&](std::size_t begin, std::size_t end) {
                   pcl::Indices index(1);
                   std::vector<float> squared(1);
                   for (std::size_t i = begin; i < end; ++i)
                     if (tree.nearestKSearch(queries[i], 1, index, squared) == 1 &&
                         squared[0] <= limit)
                       nearest[i] = index[0];
                 });
  return nearest;
}

} // namespace pcl::sedr::benchmark
