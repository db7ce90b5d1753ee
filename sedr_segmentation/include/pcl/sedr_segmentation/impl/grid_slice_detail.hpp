// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/plane_fit.h>
#include <pcl/sedr_segmentation/grid_slice_detail.h>

#include <cmath>
#include <string>

namespace pcl {

template <typename PointT>
bool
GridSliceDetail<PointT>::validate()
{
  constexpr const char* name = "GridSliceDetail";
  const auto bad = [&](const std::string& what, double value) {
    return fail(name, what + ", it is " + std::to_string(value));
  };
  const auto isPositive = [](double value) {
    return value > 0 && std::isfinite(value);
  };
  if (!isPositive(parameters_.cell_size))
    return bad("the grid size must be above 0 m", parameters_.cell_size);
  if (!isPositive(parameters_.tolerance))
    return bad("the distance threshold must be above 0 m", parameters_.tolerance);
  if (!isPositive(parameters_.slice_thickness))
    return bad("the slice thickness must be above 0 m", parameters_.slice_thickness);
  if (parameters_.trials < 1 || parameters_.trials > 3)
    return bad("the number of trials must be from 1 to 3", parameters_.trials);
  if (!(parameters_.minimum_island_area >= 0))
    return bad("the minimum island area must be at least 0 square metres",
               parameters_.minimum_island_area);
  std::string problem = sedr::indicesProblem(*indices_, input_->size());
  if (!problem.empty())
    return fail(name, problem);
  if (!ceiling_ || ceiling_->empty())
    return fail(name, "no ceiling points were set");
  problem = sedr::indicesProblem(*ceiling_, input_->size());
  if (!problem.empty())
    return fail(name, "ceiling " + problem);
  if (std::isfinite(floor_height_))
    return true;
  if (!floor_ || floor_->empty())
    return fail(name, "neither floor points nor a floor height were set");
  problem = sedr::indicesProblem(*floor_, input_->size());
  return problem.empty() || fail(name, "floor " + problem);
}

template <typename PointT>
bool
GridSliceDetail<PointT>::run()
{
  if (!validate())
    return false;
  const sedr::PointView points(*input_);
  const auto finite = [&](const Indices& indices) {
    Indices kept;
    for (const auto i : indices)
      if (points.isFinite(static_cast<std::size_t>(i)))
        kept.push_back(i);
    return kept;
  };
  const Indices ceiling = finite(*ceiling_);
  const Indices floor = std::isfinite(floor_height_) ? Indices() : finite(*floor_);
  if (ceiling.empty() || (floor.empty() && !std::isfinite(floor_height_)))
    return fail("GridSliceDetail",
                "of " + std::to_string(ceiling_->size()) + " ceiling points " +
                    std::to_string(ceiling.size()) + " are finite, of the floor's " +
                    std::to_string(floor.size()));
  constexpr double maximum_tilt = 3.0 * M_PI / 180.0;
  const sedr::PlanSlab slab =
      sedr::findSlab(points, ceiling, parameters_.tolerance, maximum_tilt, seed_,
                     parameters_.threads);
  double floor_height = floor_height_;
  if (!std::isfinite(floor_height)) {
    double sum = 0;
    for (const auto i : floor)
      sum += (*input_)[i].z;
    floor_height = sum / static_cast<double>(floor.size());
  }
  std::string problem;
  result_ = sedr::findSliceDetails(points, *indices_, ceiling, slab, floor_height,
                                   parameters_, problem);
  return problem.empty() || fail("GridSliceDetail", problem);
}

template <typename PointT>
bool
GridSliceDetail<PointT>::segment(PointIndices& details)
{
  details.indices.clear();
  result_ = sedr::SliceDetails();
  this->clearError();
  if (!this->initCompute())
    return fail("GridSliceDetail", "no input cloud was set");
  details.header = input_->header;
  const bool is_done = run();
  details.indices = result_.indices;
  this->deinitCompute();
  return is_done;
}

} // namespace pcl

#define PCL_INSTANTIATE_GridSliceDetail(T)                                             \
  template class PCL_EXPORTS pcl::GridSliceDetail<T>;
