// SPDX-License-Identifier: BSD-3-Clause
#include "boundary_points.h"
#include "wall_growing.h"

#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_segmentation/impl/ceiling_boundary_wall_growing.hpp>

namespace pcl::sedr {

namespace {

std::string
problemOf(const WallInput& input)
{
  const std::size_t size = input.points.size();
  std::string problem = indicesProblem(input.candidates, size);
  for (const auto& indices : {input.ceiling, input.floor, input.details})
    if (problem.empty() && indices)
      problem = indicesProblem(*indices, size);
  return problem;
}

/** @brief Finds the boundaries and takes their points as seeds. */
WallSeeds
findSeeds(const WallInput& input,
          const WallParts& parts,
          const BoundaryOptions& options,
          bool has_slice,
          GrownWalls& result)
{
  const auto boundaryOf = [&](const pcl::Indices& slab, Nearness nearness) {
    return boundaryPoints(input.points, slab, nearness, options);
  };
  result.ceiling_boundary = boundaryOf(parts.ceiling, Nearness::Space);
  if (!has_slice)
    return {result.ceiling_boundary, {}};
  result.floor_boundary = boundaryOf(parts.floor, Nearness::Space);
  result.scope_boundary =
      boundaryOf(unite(parts.ceiling, parts.details), Nearness::Plan);
  return {unite(result.ceiling_boundary, result.scope_boundary), result.floor_boundary};
}

} // namespace

std::string
growWalls(const WallInput& input,
          const BoundaryOptions& boundary,
          const WallGrowingOptions& growing,
          GrownWalls& result)
{
  std::string problem = problemOf(input);
  if (problem.empty())
    problem = problemOf(boundary);
  if (problem.empty())
    problem = problemOf(growing);
  if (!problem.empty())
    return problem;
  const WallParts parts = wallParts(input.points, input.candidates, input.ceiling.get(),
                                    input.floor.get(), input.details.get(), growing);
  problem = problemOf(parts, growing);
  if (!problem.empty())
    return problem;
  const WallSeeds seeds = findSeeds(input, parts, boundary, growing.hasSlice(), result);
  result.walls = growWalls(input.points, parts, seeds, growing);
  result.with_details = unite(result.walls, parts.details);
  return {};
}

} // namespace pcl::sedr

PCL_INSTANTIATE(CeilingBoundaryWallGrowing, SEDR_POINT_TYPES)
