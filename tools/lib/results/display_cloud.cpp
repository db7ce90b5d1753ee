// SPDX-License-Identifier: BSD-3-Clause
#include "display_cloud.h"

#include "tool_error.h"

#include "sedr_filters/src/base/field_access.h"
#include <pcl/sedr_filters/parallel_voxel_grid.h>

#include <Eigen/Geometry>

#include <algorithm>

namespace pcl::sedr::tools {

namespace {

/** @brief Returns the box of points to show, without outliers. It surrounds all but the
 * outermost hundredth at each end, including what is seen through windows. An outlier
 * would determine camera and depth and reduce everything else to a dot. */
Eigen::AlignedBox3d
shownBox(const std::vector<Eigen::Vector3f>& points)
{
  constexpr double extents = 10;
  constexpr double around = 100; // metres
  constexpr std::size_t sample_size = 10000;
  Eigen::AlignedBox3d most;
  const std::size_t n = std::min(points.size(), sample_size);
  const std::size_t cut = n / 100;
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
  constexpr std::size_t few = 100; // points; smaller clouds have no outliers
  if (cloud.size() < few)
    return;
  const Eigen::AlignedBox3d box = shownBox(cloud.points);
  std::vector<bool> is_kept;
  is_kept.reserve(cloud.size());
  for (const auto& p : cloud.points)
    is_kept.push_back(box.contains(p.cast<double>()));
  keep(is_kept, cloud.points);
  keep(is_kept, cloud.labels);
  keep(is_kept, cloud.rooms);
}

/** @brief Calls `see(row, place)` for every finite point. */
template <typename See>
void
forEachFinite(const RowSource& scan, See see)
{
  RowCoordinates coordinates(scan.fields(), scan.rowSize());
  scan.forEachPiece([&](const RowSource::Piece& piece) {
    const PointView points = coordinates.of(piece.rows, piece.size);
    for (std::size_t i = 0; i < piece.size; ++i)
      if (points.isFinite(i))
        see(piece.rows + i * scan.rowSize(), points[i]);
    return true;
  });
}

} // namespace

DisplayCloud
displayCloudOf(const RowSource& scan, std::size_t most)
{
  DisplayCloud shown;
  const std::size_t step =
      most == 0 ? 1 : std::max<std::size_t>(1, (scan.size() + most - 1) / most);
  const auto* label = findField(scan.fields(), "label");
  const auto* room = findField(scan.fields(), "room");
  const auto add = [](const std::uint8_t* row, const pcl::PCLPointField* field,
                      std::vector<std::uint32_t>& values) {
    if (field)
      values.push_back(static_cast<std::uint32_t>(
          std::max(0.0, readField(row + field->offset, field->datatype))));
  };
  forEachFinite(scan, [&](const std::uint8_t* row, const Eigen::Vector3f& place) {
    if (shown.whole_size++ % step != 0)
      return;
    shown.points.push_back(place);
    add(row, label, shown.labels);
    add(row, room, shown.rooms);
  });
  dropStrays(shown);
  return shown;
}

DisplayCloud
thinnedCloudOf(const RowSource& scan, double voxel_size, std::size_t most)
{
  constexpr double growth = 1.3;
  pcl::ParallelVoxelGrid<pcl::PointXYZ> grid;
  const auto setLeaf = [&](double size) {
    const auto leaf = static_cast<float>(size);
    grid.setLeafSize(leaf, leaf, leaf);
  };
  pcl::PointCloud<pcl::PointXYZ>::Ptr thinned(new pcl::PointCloud<pcl::PointXYZ>);
  setLeaf(voxel_size);
  grid.filter(scan, *thinned);
  if (!grid.getErrorMessage().empty())
    throw ToolError(grid.getErrorMessage());
  while (thinned->size() > most) {
    setLeaf(voxel_size *= growth);
    grid.setInputCloud(thinned);
    pcl::PointCloud<pcl::PointXYZ>::Ptr coarser(new pcl::PointCloud<pcl::PointXYZ>);
    grid.filter(*coarser);
    thinned = coarser;
  }
  DisplayCloud shown;
  shown.whole_size = scan.size();
  shown.spacing = voxel_size;
  for (const auto& p : *thinned)
    shown.points.emplace_back(p.x, p.y, p.z);
  dropStrays(shown);
  return shown;
}

} // namespace pcl::sedr::tools
