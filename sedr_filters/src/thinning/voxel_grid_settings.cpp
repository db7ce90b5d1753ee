// SPDX-License-Identifier: BSD-3-Clause
#include "../base/field_access.h"
#include "../voxels/voxel_sums.h"

#include <pcl/console/print.h>
#include <pcl/sedr_filters/impl/thinned_voxels.h>
#include <pcl/sedr_filters/voxel_grid_settings.h>

#include <algorithm>
#include <sstream>
#include <tuple>

namespace pcl::sedr {

namespace {

constexpr std::int64_t int_max = std::numeric_limits<int>::max();
constexpr std::int64_t layout_limit = std::int64_t{1} << 27;

/** @brief Compares voxels by z, then y, then x. */
bool
precedes(const Eigen::Vector3i& a, const Eigen::Vector3i& b)
{
  return std::make_tuple(a.z(), a.y(), a.x()) < std::make_tuple(b.z(), b.y(), b.x());
}

} // namespace

Eigen::Vector3i
VoxelGridSettings::getNrDivisions() const
{
  Eigen::Vector3i divisions;
  for (int axis = 0; axis < 3; ++axis)
    divisions[axis] = static_cast<int>(
        std::min(int_max, std::int64_t{max_box_[axis]} - min_box_[axis] + 1));
  return divisions;
}

Eigen::Vector3i
VoxelGridSettings::getDivisionMultiplier() const
{
  const Eigen::Vector3i divisions = getNrDivisions();
  const std::int64_t slice = std::int64_t{divisions.x()} * divisions.y();
  return {1, divisions.x(), static_cast<int>(std::min(int_max, slice))};
}

Eigen::Vector3i
VoxelGridSettings::getGridCoordinates(float x, float y, float z) const
{
  const std::array<float, 3> point{x, y, z};
  return voxelAt(VoxelFrame(inverseLeaf()).codes(point.data()));
}

int
VoxelGridSettings::getCentroidIndexAt(const Eigen::Vector3i& ijk) const
{
  const auto it = std::lower_bound(layout_.begin(), layout_.end(), ijk, precedes);
  return it != layout_.end() && *it == ijk ? static_cast<int>(it - layout_.begin())
                                           : -1;
}

std::vector<int>
VoxelGridSettings::getLeafLayout() const
{
  if (layout_.empty())
    return {};
  const Eigen::Vector3i divisions = getNrDivisions();
  const std::int64_t slice = std::int64_t{divisions.x()} * divisions.y();
  if (slice > layout_limit || slice * divisions.z() > layout_limit) {
    PCL_ERROR("[pcl::ParallelVoxelGrid] the leaf layout would hold %d x %d x %d "
              "entries, more "
              "than 2^27: use getCentroidIndexAt\n",
              divisions.x(), divisions.y(), divisions.z());
    return {};
  }
  std::vector<int> dense(static_cast<std::size_t>(slice * divisions.z()), -1);
  for (std::size_t i = 0; i < layout_.size(); ++i) {
    const Eigen::Vector3i from_min = layout_[i] - min_box_;
    dense[static_cast<std::size_t>(from_min.x() + from_min.y() * divisions.x() +
                                   from_min.z() * slice)] = static_cast<int>(i);
  }
  return dense;
}

std::string
VoxelGridSettings::parameterProblem() const
{
  if ((leaf_size_.array() > 0).all() && leaf_size_.allFinite() &&
      inverseLeaf().allFinite())
    return {};
  std::ostringstream problem;
  problem << "the leaf must be above 0 m along x, y and z, it is " << leaf_size_.x()
          << " x " << leaf_size_.y() << " x " << leaf_size_.z() << " m";
  return problem.str();
}

bool
VoxelGridSettings::passesLimits(const std::uint8_t* where, std::uint8_t datatype) const
{
  return passesLimits(readField(where, datatype));
}

void
VoxelGridSettings::clearLayout()
{
  min_box_.setZero();
  max_box_.setZero();
  stray_limit_ = 0;
  layout_.clear();
}

std::size_t
VoxelGridSettings::finish(VoxelSums& sums)
{
  clearLayout();
  if (removes_strays_)
    stray_limit_ = sums.census().minPoints();
  const std::size_t size =
      sums.arrange(std::max(min_points_per_voxel_, stray_limit_), threads_);
  if (size == 0 && sums.size() == 0)
    return 0;
  min_box_ = voxelAt(sums.box().low);
  max_box_ = voxelAt(sums.box().high);
  if (save_leaf_layout_) {
    layout_.resize(size);
    sums.forEach([&](const VoxelSum& voxel,
                     std::size_t place) { layout_[place] = voxelAt(voxel.code); },
                 threads_);
  }
  return size;
}

ThinnedVoxels
VoxelGridSettings::thin(const PointView& points, const pcl::Indices* indices)
{
  auto sums = std::make_unique<VoxelSums>(inverseLeaf());
  if (indices)
    sums->add(points, *indices, threads_);
  else
    sums->add(points, threads_);
  const std::size_t size = finish(*sums);
  return {std::move(sums), size, threads_};
}

ThinnedVoxels
VoxelGridSettings::thin(const RowSource& source)
{
  auto sums = std::make_unique<VoxelSums>(inverseLeaf());
  addRows(source, nullptr, *sums);
  const std::size_t size = finish(*sums);
  return {std::move(sums), size, threads_};
}

} // namespace pcl::sedr
