// SPDX-License-Identifier: BSD-3-Clause
#include "../curves/plan_points.h"
#include "boundary_points.h"

#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/base/parallel.h"
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>
#include <pcl/sedr_segmentation/impl/ceiling_boundary_wall_growing.hpp>

#include <pcl/impl/instantiate.hpp>
#include <pcl/types.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>

namespace pcl::sedr {

namespace {

/** @brief The parts of a room: finite points, ascending, each in one part only. */
struct WallParts {
  pcl::Indices ceiling;
  pcl::Indices floor;
  pcl::Indices details;    ///< none without a slice
  pcl::Indices candidates; ///< for walls: what no other part holds
};

/** @brief Seeds of walls: indices of finite points, increasing. */
struct WallSeeds {
  pcl::Indices above; ///< all seeds if there is no slice height
  pcl::Indices below;
};

Eigen::Vector3d
at(const PointView& points, pcl::index_t index)
{
  return points[static_cast<std::size_t>(index)].cast<double>();
}

pcl::Indices
without(const pcl::Indices& a, const pcl::Indices& b)
{
  pcl::Indices rest;
  rest.reserve(a.size());
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(rest));
  return rest;
}

/** @brief The elements of two ascending lists, each once. */
pcl::Indices
unite(const pcl::Indices& a, const pcl::Indices& b)
{
  pcl::Indices all;
  all.reserve(a.size() + b.size());
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
  return all;
}

std::vector<Eigen::Vector2d>
plan(const PointView& points, const pcl::Indices& indices)
{
  std::vector<Eigen::Vector2d> places;
  places.reserve(indices.size());
  for (const auto i : indices)
    places.emplace_back(at(points, i).head<2>());
  return places;
}

/** @brief What is wrong with the options, a sentence; empty if nothing is. */
std::string
problemOf(const WallGrowingOptions& options)
{
  const std::string problem =
      positiveProblem({{"the distance threshold", options.distance}});
  if (problem.empty() && std::isinf(options.slice_height))
    return "the slice height must be finite, it is " +
           std::to_string(options.slice_height);
  return problem;
}

/** @brief Sorts the indices a user gave into parts. Null pointers stand for no points.
 */
WallParts
wallParts(const PointView& points,
          const pcl::Indices& candidates,
          const pcl::Indices* ceiling,
          const pcl::Indices* floor,
          const pcl::Indices* details,
          const WallGrowingOptions& options)
{
  const auto finite = [&](const pcl::Indices* indices) {
    return indices ? finiteIndices(points, *indices) : pcl::Indices();
  };
  WallParts parts;
  parts.ceiling = finite(ceiling);
  parts.floor = without(finite(floor), parts.ceiling);
  const pcl::Indices slabs = unite(parts.ceiling, parts.floor);
  if (options.hasSlice())
    parts.details = without(finite(details), slabs);
  parts.candidates = without(finite(&candidates), unite(slabs, parts.details));
  return parts;
}

/** @brief What a run with these options misses among the parts, a sentence; empty if
 * nothing. */
std::string
problemOf(const WallParts& parts, const WallGrowingOptions& options)
{
  if (parts.ceiling.size() < 3)
    return "at least 3 finite ceiling points are needed, there are " +
           std::to_string(parts.ceiling.size());
  if (options.hasSlice() && parts.floor.empty())
    return "below the slice at " + numberText(options.slice_height) +
           " m the boundary of the floor seeds the walls, but no floor points were set";
  return {};
}

/** @brief The candidates that are near a seed in plan. O((n + s) log s) for n
 * candidates and s seeds. */
pcl::Indices
growWalls(const PointView& points,
          const WallParts& parts,
          const WallSeeds& seeds,
          const WallGrowingOptions& options)
{
  const PlanPoints above(plan(points, seeds.above), options.distance);
  const PlanPoints below(plan(points, seeds.below), options.distance);

  const pcl::Indices& candidates = parts.candidates;
  std::vector<std::uint8_t> is_wall(candidates.size());
  const auto growBlock = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3d p = at(points, candidates[i]);
      const bool is_below = options.hasSlice() && p.z() < options.slice_height;
      (is_below ? below : above)
          .forEachWithin(p.head<2>(), options.distance,
                         [&](const Eigen::Vector2d&) { is_wall[i] = 1; });
    }
  };
  parallelBlocks(candidates.size(), 4096, options.threads, growBlock);

  pcl::Indices walls;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (is_wall[i])
      walls.push_back(candidates[i]);
  return walls;
}

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
