// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/impl/refinement.h>
#include <pcl/sedr_filters/impl/structure_fields.hpp>
#include <pcl/sedr_filters/vertical_hole_repair.h>

#include <string>

namespace pcl {

template <typename PointT>
void
VerticalHoleRepair<PointT>::clearResults()
{
  sedr::PlanFilter<PointT>::clearResults();
  repaired_.clear();
}

template <typename PointT>
void
VerticalHoleRepair<PointT>::applyFilter(PointCloud& output)
{
  this->startRun(output);
  std::vector<std::uint32_t> labels = this->labels_;
  std::vector<std::uint32_t> rooms = this->rooms_;
  std::string problem = sedr::positiveProblem({{"the grid size", grid_size_}});
  if (problem.empty())
    problem = sedr::structureProblem(plan_.get(), *input_, *indices_, labels, rooms);
  if (problem.empty())
    problem = sedr::surfaceCellsProblem(*plan_, grid_size_);
  if (!problem.empty()) {
    this->failRun(problem);
    return;
  }

  // Refined points already lie on the plan: this step finds their surface and normal.
  constexpr double on_surface = 0.01;
  const sedr::Refinement refined =
      sedr::refineToPlan(sedr::PointView(*input_), *indices_, labels, rooms, *plan_,
                         on_surface, this->threads_);
  if (refined.sources.empty()) {
    this->failRun(sedr::nonePlaced(*indices_, labels, on_surface) +
                  ": refine the structure first");
    return;
  }
  const sedr::OpeningSpaces openings(*plan_);
  std::vector<bool> is_used(refined.sources.size(), false);
  for (const auto& repaired : sedr::repairHoles(refined.points, *plan_, grid_size_)) {
    const bool is_new = repaired.source < 0;
    if (is_new && keep_openings_ && openings.contains(repaired.point.position))
      continue;
    PointT p{};
    if (is_new)
      repaired_.push_back(static_cast<index_t>(output.size()));
    else {
      is_used[static_cast<std::size_t>(repaired.source)] = true;
      p = (*input_)[refined.sources[static_cast<std::size_t>(repaired.source)]];
    }
    sedr::setSurfacePoint(repaired.point, p);
    sources_.push_back(
        is_new ? -1 : refined.sources[static_cast<std::size_t>(repaired.source)]);
    surface_points_.push_back(repaired.point);
    output.push_back(p);
  }
  this->removeAllBut(refined.sources, [&](std::size_t k) { return is_used[k]; });
}

} // namespace pcl

#define PCL_INSTANTIATE_VerticalHoleRepair(T)                                          \
  template class PCL_EXPORTS pcl::VerticalHoleRepair<T>;
