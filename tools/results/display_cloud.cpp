// SPDX-License-Identifier: BSD-3-Clause
#include "display_cloud.h"

#include "tool_error.h"

#include <pcl/sedr_filters/parallel_voxel_grid.h>
#include <pcl/sedr_filters/point_view.h>

namespace pcl {
namespace sedr {
namespace tools {

DisplayCloud
displayCloudOf(const ToolCloud& cloud, std::size_t most)
{
  const PointView points(*cloud.points);
  pcl::Indices finite;
  finite.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points.isFinite(i))
      finite.push_back(static_cast<pcl::index_t>(i));
  const auto x = floatField(cloud.blob, "normal_x");
  const auto y = floatField(cloud.blob, "normal_y");
  const auto z = floatField(cloud.blob, "normal_z");
  const bool has_normals = !x.empty() && !y.empty() && !z.empty();
  DisplayCloud shown;
  shown.whole_size = finite.size();
  const std::size_t count = most == 0 ? finite.size() : std::min(most, finite.size());
  for (std::size_t k = 0; k < count; ++k) {
    const auto i = static_cast<std::size_t>(finite[k * finite.size() / count]);
    shown.points.push_back(points[i]);
    if (cloud.has_label)
      shown.labels.push_back(cloud.label[i]);
    if (cloud.has_room)
      shown.rooms.push_back(cloud.room[i]);
    if (has_normals)
      shown.normals.emplace_back(x[i], y[i], z[i]);
  }
  return shown;
}

DisplayCloud
thinnedCloudOf(const ToolCloud& cloud, double voxel_size)
{
  const auto leaf = static_cast<float>(voxel_size);
  pcl::ParallelVoxelGrid<pcl::PointXYZ> grid;
  grid.setInputCloud(cloud.points);
  grid.setLeafSize(leaf, leaf, leaf);
  pcl::PointCloud<pcl::PointXYZ> thinned;
  grid.filter(thinned);
  if (!grid.getErrorMessage().empty())
    throw ToolError(grid.getErrorMessage());
  DisplayCloud shown;
  shown.whole_size = thinned.size();
  for (const auto& p : thinned)
    shown.points.emplace_back(p.x, p.y, p.z);
  return shown;
}

} // namespace tools
} // namespace sedr
} // namespace pcl
