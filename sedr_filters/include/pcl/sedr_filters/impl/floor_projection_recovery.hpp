// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/common/io.h>
#include <pcl/sedr_filters/floor_projection_recovery.h>
#include <pcl/sedr_filters/impl/pcl_bases.hpp>
#include <pcl/sedr_filters/impl/refinement.h>
#include <pcl/sedr_filters/point_types.h>

#include <cmath>
#include <string>

namespace pcl {
namespace sedr {

/** @brief Moves a point vertically onto `plane`; sets floor normal and label. */
template <typename PointT>
void
projectOntoFloor(const Eigen::Vector4d& plane, PointT& p)
{
  p.z = static_cast<float>(-(plane[0] * p.x + plane[1] * p.y + plane[3]) / plane[2]);
  if constexpr (pcl::traits::has_normal<PointT>::value) {
    p.normal_x = static_cast<float>(plane[0]);
    p.normal_y = static_cast<float>(plane[1]);
    p.normal_z = static_cast<float>(plane[2]);
  }
  if constexpr (pcl::traits::has_label<PointT>::value)
    p.label = static_cast<std::uint32_t>(StructureLabel::Floor);
}

} // namespace sedr

template <typename PointT>
void
FloorProjectionRecovery<PointT>::clearResults()
{
  sedr::StageFilter<PointT>::clearResults();
  source_indices_.clear();
  number_of_projected_ = 0;
}

template <typename PointT>
std::string
FloorProjectionRecovery<PointT>::problem() const
{
  std::string problem = sedr::positiveProblem({{"the grid size", grid_size_}});
  if (problem.empty())
    problem = sedr::indicesProblem("floor", indices_, input_->size());
  if (problem.empty() && (!ceiling_ || ceiling_->empty()))
    problem = "the ceiling has 0 points, there is nothing to complete the " +
              std::to_string(indices_->size()) + " points of the floor from";
  if (problem.empty())
    problem = sedr::indicesProblem("ceiling", ceiling_, input_->size());
  if (problem.empty())
    problem = sedr::indicesProblem("detail", detail_, input_->size());
  return problem;
}

template <typename PointT>
std::string
FloorProjectionRecovery<PointT>::findPlane(const Indices& floor_in_scope,
                                           Eigen::Vector4d& plane) const
{
  if (!plane_) {
    const double height = sedr::meanHeight(sedr::PointView(*input_), floor_in_scope);
    plane = {0, 0, 1, -height};
    return !floor_in_scope.empty() ? std::string()
                                   : "none of the " + std::to_string(indices_->size()) +
                                         " floor points lies under the " +
                                         std::to_string(ceiling_->size()) +
                                         " ceiling points, and no floor plane was set";
  }
  if (plane_->values.size() != 4)
    return "a floor plane has 4 coefficients, " +
           std::to_string(plane_->values.size()) + " were set";
  for (int k = 0; k < 4; ++k)
    plane[k] = plane_->values[static_cast<std::size_t>(k)];
  const double length = plane.head<3>().norm();
  constexpr double steepest = 0.1; // cosine of the tilt, about 84 degrees
  if (!plane.allFinite() || !(length > 0) || std::abs(plane[2]) < steepest * length)
    return "the floor plane must not stand vertical, its normal is (" +
           std::to_string(plane[0]) + ", " + std::to_string(plane[1]) + ", " +
           std::to_string(plane[2]) + ")";
  plane /= plane[2] < 0 ? -length : length;
  return {};
}

template <typename PointT>
void
FloorProjectionRecovery<PointT>::applyFilter(PointCloud& output)
{
  this->startRun(output);
  sedr::FloorRecovery recovery;
  Eigen::Vector4d plane;
  std::string reason = problem();
  if (reason.empty()) {
    recovery = sedr::recoverFloor(grid_size_, sedr::PointView(*input_), *indices_,
                                  *ceiling_, detail_ ? *detail_ : Indices());
    reason = findPlane(recovery.kept, plane);
  }
  if (!reason.empty()) {
    this->failRun(reason);
    return;
  }
  source_indices_ = recovery.kept;
  source_indices_.insert(source_indices_.end(), recovery.sources.begin(),
                         recovery.sources.end());
  number_of_projected_ = recovery.sources.size();
  output.reserve(source_indices_.size());
  for (const auto i : source_indices_)
    output.push_back((*input_)[i]);
  for (std::size_t i = recovery.kept.size(); i < output.size(); ++i)
    sedr::projectOntoFloor(plane, output[i]);
  if (this->extract_removed_indices_)
    *removed_indices_ = recovery.removed;
}

} // namespace pcl

#define PCL_INSTANTIATE_FloorProjectionRecovery(T)                                     \
  template class PCL_EXPORTS pcl::FloorProjectionRecovery<T>;
