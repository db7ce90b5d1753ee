// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/refinement.h>
#include <pcl/sedr_filters/structure_fields.h>
#include <pcl/sedr_filters/structure_refinement.h>

#include <cmath>
#include <string>

namespace pcl {

template <typename PointT>
bool
StructureRefinement<PointT>::validate(std::vector<std::uint32_t>& labels,
                                      std::vector<std::uint32_t>& rooms)
{
  constexpr const char* name = "StructureRefinement";
  if (!plan_ || plan_->rooms.empty())
    return fail(name, "no floor plan with rooms was set");
  if (!(maximum_distance_ > 0) || !std::isfinite(maximum_distance_))
    return fail(name,
                "the maximum distance must be above 0 m, it is " +
                    std::to_string(maximum_distance_));
  const std::string problem = sedr::indicesProblem(*indices_, input_->size());
  if (!problem.empty())
    return fail(name, problem);
  labels = labels_.empty() ? sedr::labelsOf(*input_) : labels_;
  rooms = rooms_.empty() ? sedr::roomsOf(*input_) : rooms_;
  if (labels.size() != input_->size() || rooms.size() != input_->size())
    return fail(name,
                "the cloud has " + std::to_string(input_->size()) + " points, but " +
                    std::to_string(labels.size()) + " labels and " +
                    std::to_string(rooms.size()) + " rooms are known");
  return true;
}

template <typename PointT>
void
StructureRefinement<PointT>::applyFilter(PointCloud& output)
{
  this->clearError();
  removed_indices_->clear();
  sources_.clear();
  surface_points_.clear();
  output.clear();
  output.height = 1;
  output.is_dense = true;
  std::vector<std::uint32_t> labels;
  std::vector<std::uint32_t> rooms;
  if (!validate(labels, rooms))
    return;

  sedr::Refinement refinement = sedr::refineToPlan(sedr::PointView(*input_),
                                                   *indices_,
                                                   labels,
                                                   rooms,
                                                   *plan_,
                                                   maximum_distance_,
                                                   threads_);
  sources_ = std::move(refinement.sources);
  surface_points_ = std::move(refinement.points);
  output.reserve(sources_.size());
  for (std::size_t k = 0; k < sources_.size(); ++k) {
    PointT p = (*input_)[sources_[k]];
    sedr::setSurfacePoint(surface_points_[k], p);
    output.push_back(p);
  }
  if (!extract_removed_indices_)
    return;
  std::size_t next = 0;
  for (const auto i : *indices_) {
    if (next < sources_.size() && sources_[next] == i)
      ++next;
    else
      removed_indices_->push_back(i);
  }
}

} // namespace pcl

#define PCL_INSTANTIATE_StructureRefinement(T)                                           \
  template class PCL_EXPORTS pcl::StructureRefinement<T>;
