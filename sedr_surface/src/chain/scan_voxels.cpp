// SPDX-License-Identifier: BSD-3-Clause
#include "scan_voxels.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

ScanVoxels::ScanVoxels(const StructureModel& model, double leaf)
    : model_(model)
    , to_building_(model.levelFrame().to(model.frame))
    , leaf_(leaf)
{
  const StructureModel::Cloud& cloud = *model.cloud;
  points_.reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    points_.emplace_back(
        voxelOf(to_building_.toBuilding(cloud[i].getVector3fMap().cast<double>())),
        static_cast<std::uint32_t>(i));
  std::sort(points_.begin(), points_.end());
}

ScanVoxels::Voxel
ScanVoxels::voxelOf(const Eigen::Vector3d& p) const
{
  Voxel voxel{};
  for (int axis = 0; axis < 3; ++axis)
    voxel[static_cast<std::size_t>(axis)] =
        static_cast<std::int32_t>(std::floor(p[axis] / leaf_));
  return voxel;
}

std::size_t
ScanVoxels::of(const Eigen::Vector3f& p) const
{
  const std::size_t none = points_.size();
  constexpr float far = 1e7F; // metres, beyond voxels
  if (!(p.cwiseAbs().maxCoeff() < far))
    return none;
  const Voxel voxel = voxelOf(model_.frame.toBuilding(p.cast<double>()));
  const auto at = [&](const Voxel& v) {
    const auto found = std::lower_bound(points_.begin(), points_.end(),
                                        std::make_pair(v, std::uint32_t{0}));
    return found != points_.end() && found->first == v ? found->second : none;
  };
  if (const std::size_t own = at(voxel); own != none)
    return own;
  // The mean of a voxel may have been rounded beyond its border.
  constexpr double rounding = 1e-4; // metres
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int step : {-1, 1}) {
      Voxel beside = voxel;
      beside[axis] += step;
      const std::size_t near = at(beside);
      if (near == none)
        continue;
      const Eigen::Vector3d mean = to_building_.toBuilding(
          (*model_.cloud)[near].getVector3fMap().cast<double>());
      const double border = leaf_ * (voxel[axis] + (step < 0 ? 0 : 1));
      if (std::abs(mean[static_cast<Eigen::Index>(axis)] - border) < rounding)
        return near;
    }
  return none;
}

} // namespace pcl::sedr
