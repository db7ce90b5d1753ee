// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/impl/refinement.h>
#include <pcl/sedr_filters/impl/structure_fields.hpp>
#include <pcl/sedr_filters/structure_refinement.h>

#include <string>

namespace pcl {

template <typename PointT>
void
StructureRefinement<PointT>::applyFilter(PointCloud& output)
{
  this->startRun(output);
  std::vector<std::uint32_t> labels = this->labels_;
  std::vector<std::uint32_t> rooms = this->rooms_;
  std::string problem =
      sedr::positiveProblem({{"the maximum distance", maximum_distance_}});
  if (problem.empty())
    problem = sedr::structureProblem(plan_.get(), *input_, *indices_, labels, rooms);
  if (!problem.empty()) {
    this->failRun(problem);
    return;
  }

  sedr::Refinement refinement =
      sedr::refineToPlan(sedr::PointView(*input_), *indices_, labels, rooms, *plan_,
                         maximum_distance_, this->threads_);
  if (refinement.sources.empty()) {
    this->failRun(sedr::nonePlaced(*indices_, labels, maximum_distance_));
    return;
  }
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
