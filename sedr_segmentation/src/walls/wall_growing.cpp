// SPDX-License-Identifier: BSD-3-Clause
#include "wall_growing.h"

#include "../curves/plan_points.h"
#include "boundary_points.h"
#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace pcl::sedr {

namespace {

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

std::vector<Eigen::Vector2d>
plan(const PointView& points, const pcl::Indices& indices)
{
  std::vector<Eigen::Vector2d> places;
  places.reserve(indices.size());
  for (const auto i : indices)
    places.emplace_back(at(points, i).head<2>());
  return places;
}

} // namespace

std::string
problemOf(const WallGrowingOptions& options)
{
  const auto mustBe = [](const char* what, const char* range, double value) {
    return std::string(what) + " must be " + range + ", it is " + numberText(value);
  };
  if (!(options.distance > 0) || !std::isfinite(options.distance))
    return mustBe("the distance threshold", "above 0 m", options.distance);
  if (std::isinf(options.slice_height))
    return mustBe("the slice height", "finite", options.slice_height);
  return {};
}

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

pcl::Indices
unite(const pcl::Indices& a, const pcl::Indices& b)
{
  pcl::Indices all;
  all.reserve(a.size() + b.size());
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
  return all;
}

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

} // namespace pcl::sedr
