// SPDX-License-Identifier: BSD-3-Clause
#include "slice_detail.h"

#include "sedr_filters/src/base/plane_fit.h"
#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_segmentation/impl/grid_slice_detail.hpp>

#include <cmath>

namespace pcl::sedr {

namespace {

std::string
problemOf(const SliceParameters& parameters)
{
  const auto bad = [](const char* what, double value) {
    return std::string(what) + ", it is " + std::to_string(value);
  };
  const auto isPositive = [](double value) {
    return value > 0 && std::isfinite(value);
  };
  if (!isPositive(parameters.cell_size))
    return bad("the grid size must be above 0 m", parameters.cell_size);
  if (!isPositive(parameters.tolerance))
    return bad("the distance threshold must be above 0 m", parameters.tolerance);
  if (!isPositive(parameters.slice_thickness))
    return bad("the slice thickness must be above 0 m", parameters.slice_thickness);
  if (parameters.trials < 1 || parameters.trials > 3)
    return bad("the number of trials must be from 1 to 3", parameters.trials);
  if (!(parameters.minimum_island_area >= 0))
    return bad("the minimum island area must be at least 0 square metres",
               parameters.minimum_island_area);
  return problemOf(parameters.priors);
}

std::string
problemOf(const SliceInput& input)
{
  const std::size_t size = input.points.size();
  std::string problem = indicesProblem(input.indices, size);
  if (!problem.empty())
    return problem;
  if (!input.ceiling || input.ceiling->empty())
    return "no ceiling points were set";
  problem = indicesProblem("ceiling", input.ceiling, size);
  if (!problem.empty() || std::isfinite(input.floor_height))
    return problem;
  if (!input.floor || input.floor->empty())
    return "neither floor points nor a floor height were set";
  return indicesProblem("floor", input.floor, size);
}

pcl::Indices
finiteOf(const PointView& points, const pcl::Indices& indices)
{
  pcl::Indices kept;
  for (const auto i : indices)
    if (points.isFinite(static_cast<std::size_t>(i)))
      kept.push_back(i);
  return kept;
}

} // namespace

std::string
analyseSlices(const SliceInput& input,
              const SliceParameters& parameters,
              SliceDetails& details)
{
  std::string problem = problemOf(parameters);
  if (problem.empty())
    problem = problemOf(input);
  if (!problem.empty())
    return problem;
  const bool has_height = std::isfinite(input.floor_height);
  const pcl::Indices ceiling = finiteOf(input.points, *input.ceiling);
  const pcl::Indices floor =
      has_height ? pcl::Indices() : finiteOf(input.points, *input.floor);
  if (ceiling.empty() || (floor.empty() && !has_height))
    return "of " + std::to_string(input.ceiling->size()) + " ceiling points " +
           std::to_string(ceiling.size()) + " are finite, of the floor's " +
           std::to_string(floor.size());
  const double maximum_tilt = radians(parameters.priors.max_slab_tilt);
  const PlanSlab slab =
      findSlab(positionsOf(input.points, ceiling), parameters.tolerance, maximum_tilt,
               input.seed, parameters.threads);
  double floor_height = input.floor_height;
  if (!has_height) {
    double sum = 0;
    for (const auto i : floor)
      sum += input.points[static_cast<std::size_t>(i)].z();
    floor_height = sum / static_cast<double>(floor.size());
  }
  details = findSliceDetails(input.points, input.indices, ceiling, slab, floor_height,
                             parameters, problem);
  return problem;
}

} // namespace pcl::sedr

PCL_INSTANTIATE(GridSliceDetail, SEDR_POINT_TYPES)
