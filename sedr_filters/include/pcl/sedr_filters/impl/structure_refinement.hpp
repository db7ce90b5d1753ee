// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/impl/refinement.h>
#include <pcl/sedr_filters/impl/structure_fields.hpp>
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
  if (!(maximum_distance_ > 0) || !std::isfinite(maximum_distance_))
    return fail(name, "the maximum distance must be above 0 m, it is " +
                          std::to_string(maximum_distance_));
  const std::string problem =
      sedr::structureProblem(plan_.get(), *input_, *indices_, labels, rooms);
  return problem.empty() || fail(name, problem);
}

template <typename PointT>
void
StructureRefinement<PointT>::applyFilter(PointCloud& output)
{
  this->startRun(output);
  std::vector<std::uint32_t> labels = this->labels_;
  std::vector<std::uint32_t> rooms = this->rooms_;
  if (!validate(labels, rooms)) {
    this->removeAll();
    return;
  }

  sedr::Refinement refinement =
      sedr::refineToPlan(sedr::PointView(*input_), *indices_, labels, rooms, *plan_,
                         maximum_distance_, threads_);
  sources_ = std::move(refinement.sources);
  surface_points_ = std::move(refinement.points);
  output.reserve(sources_.size());
  for (std::size_t k = 0; k < sources_.size(); ++k) {
    PointT p = (*input_)[sources_[k]];
    sedr::setSurfacePoint(surface_points_[k], p);
    output.push_back(p);
  }
  this->removeAllBut(sources_, [](std::size_t) { return true; });
}

} // namespace pcl

#define PCL_INSTANTIATE_StructureRefinement(T)                                         \
  template class PCL_EXPORTS pcl::StructureRefinement<T>;
