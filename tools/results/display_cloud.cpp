// SPDX-License-Identifier: BSD-3-Clause
#include "display_cloud.h"

#include "tool_error.h"

#include <pcl/sedr_filters/parallel_voxel_grid.h>
#include <pcl/sedr_filters/point_view.h>

#include <Eigen/Geometry>

#include <algorithm>

namespace pcl {
namespace sedr {
namespace tools {

namespace {

/** @brief Where points are shown: around all but the outermost hundredth at each end.
 * What is seen through windows is in it. A stray point is not: camera and depth would
 * be for it alone, and all else a dot. */
Eigen::AlignedBox3d
shownBox(const std::vector<Eigen::Vector3f>& points)
{
  constexpr double extents = 10;
  constexpr double around = 100; // metres
  constexpr std::size_t sample_size = 10000;
  Eigen::AlignedBox3d most;
  if (points.empty())
    return most;
  const std::size_t n = std::min(points.size(), sample_size);
  const std::size_t cut = std::min((n + 99) / 100, (n - 1) / 2);
  std::vector<float> values(n);
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t k = 0; k < n; ++k)
      values[k] = points[k * points.size() / n][axis];
    std::sort(values.begin(), values.end());
    most.min()[axis] = values[cut];
    most.max()[axis] = values[n - 1 - cut];
  }
  const double margin = around + extents * most.sizes().maxCoeff();
  return {most.min().array() - margin, most.max().array() + margin};
}

template <typename ValueT>
void
keep(const std::vector<bool>& is_kept, std::vector<ValueT>& values)
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (is_kept[i])
      values[kept++] = values[i];
  values.resize(kept);
}

void
dropStrays(DisplayCloud& cloud)
{
  const Eigen::AlignedBox3d box = shownBox(cloud.points);
  std::vector<bool> is_kept;
  is_kept.reserve(cloud.size());
  for (const auto& p : cloud.points)
    is_kept.push_back(box.contains(p.cast<double>()));
  keep(is_kept, cloud.points);
  keep(is_kept, cloud.labels);
  keep(is_kept, cloud.rooms);
  keep(is_kept, cloud.normals);
}

} // namespace

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
  dropStrays(shown);
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
  dropStrays(shown);
  return shown;
}

} // namespace tools
} // namespace sedr
} // namespace pcl
