// SPDX-License-Identifier: BSD-3-Clause
#include "display_cloud.h"
#include "sedr_filters/src/base/field_access.h"
#include "sedr_filters/src/plan/missing_things.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include "tool_error.h"

#include <Eigen/Geometry>
#include <pcl/sedr_filters/parallel_voxel_grid.h>

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

constexpr double thickness = 0.15; // of scanned floors and ceilings, metres

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

PlanRules::PlanRules(const Floorplan& plan)
    : storeys_(storeysOf(plan))
    , ceilings_(storeys_.size())
    , storey_of_(storeyOfRooms(plan))
{
  for (std::size_t k = 0; k < storeys_.size(); ++k)
    for (const PlanRoom& room : partOf(plan, storeys_[k]).rooms)
      addRoom(room, ceilings_[k]);
}

void
PlanRules::addRoom(const PlanRoom& room, Ceilings& ceilings)
{
  const Eigen::AlignedBox2d box = boundsOf(room.boundary);
  if (box.isEmpty())
    return;
  const RoomHeights heights = heightsOf(room);
  box_of_[room.id] = {Eigen::Vector3d(box.min().x(), box.min().y(), heights.low),
                      Eigen::Vector3d(box.max().x(), box.max().y(), heights.high)};
  const Cell low = grid_.at(box.min().x(), box.min().y());
  const Cell high = grid_.at(box.max().x(), box.max().y());
  for (std::int32_t y = low.y; y <= high.y; ++y)
    for (std::int32_t x = low.x; x <= high.x; ++x) {
      const Eigen::Vector2d place = grid_.centre({x, y});
      if (!room.contains(place))
        continue;
      const double height =
          std::min(room.ceilingAt(place), room.ceiling.heightAt(place));
      // Also for the cells beside it, as risers and tops of walls lie on their borders.
      for (std::int32_t dy = -1; dy <= 1; ++dy)
        for (std::int32_t dx = -1; dx <= 1; ++dx) {
          const auto [at, is_new] = ceilings.emplace(keyOf({x + dx, y + dy}), height);
          at->second = is_new ? height : std::min(at->second, height);
        }
    }
}

bool
PlanRules::isCeiling(StructureLabel label,
                     std::uint32_t room,
                     const Eigen::Vector3d& place) const
{
  if (label == StructureLabel::Detail) {
    const auto box = box_of_.find(room);
    return box == box_of_.end() || place.z() > box->second.center().z();
  }
  if (label != StructureLabel::Other || storeys_.empty())
    return label == StructureLabel::Ceiling;
  std::size_t k = storeys_.size() - 1; // the highest storey whose floors are below it
  while (k > 0 && place.z() < storeys_[k].floor - thickness)
    --k;
  double ceiling = storeys_[k].ceiling;
  if (grid_.holds(place.x(), place.y())) {
    const auto found = ceilings_[k].find(keyOf(grid_.at(place.x(), place.y())));
    if (found != ceilings_[k].end())
      ceiling = found->second;
  }
  return place.z() > ceiling - thickness;
}

bool
PlanRules::isInStorey(std::uint32_t storey, std::uint32_t room, double z) const
{
  const PlanStorey* const wanted = findStorey(storeys_, storey);
  if (!wanted)
    return true;
  const auto known = storey_of_.find(room);
  if (known != storey_of_.end())
    return known->second == storey;
  return z >= wanted->floor - thickness && z <= wanted->ceiling + thickness;
}

bool
PlanRules::isInRoom(std::uint32_t wanted,
                    std::uint32_t room,
                    const Eigen::Vector3d& place) const
{
  const auto box = box_of_.find(wanted);
  return wanted == 0 || wanted == room ||
         (room == 0 && box != box_of_.end() &&
          box->second.exteriorDistance(place) <= thickness);
}

Eigen::AlignedBox3d
PlanRules::boxOf(std::uint32_t room) const
{
  const auto box = box_of_.find(room);
  return box == box_of_.end() ? Eigen::AlignedBox3d() : box->second;
}

} // namespace pcl::sedr::tools
