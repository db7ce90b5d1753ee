// SPDX-License-Identifier: BSD-3-Clause
#include "opening_search.h"

#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_filters/point_types.h>
#include <pcl/sedr_segmentation/impl/opening_detection.hpp>

#include <algorithm>

namespace pcl::sedr {

std::string
findOpenings(const PointView& points,
             const IndicesConstPtr& indices,
             const SightLines* sight,
             const Priors& priors,
             unsigned threads,
             Floorplan& plan,
             std::shared_ptr<const OpeningSearch>& search)
{
  std::string problem = problemOf(priors);
  if (problem.empty())
    problem = indicesProblem("the", indices, points.size());
  if (problem.empty() && (indices ? indices->empty() : points.size() == 0))
    problem = "there are no points";
  if (problem.empty() && plan.rooms.empty())
    problem = "the floor plan has no rooms";
  for (const PlanRoom& room : plan.rooms)
    if (const RoomHeights z = heightsOf(room); problem.empty() && !(z.high > z.low))
      problem =
          "the floor of room " + std::to_string(room.id) + " lies above its ceiling";
  if (!problem.empty())
    return problem;
  OpeningParameters parameters;
  parameters.sizes.max_depth = priors.max_wall;
  parameters.sizes.max_niche = priors.max_niche_depth;
  parameters.threads = threads;
  auto found =
      std::make_shared<OpeningSearch>(plan, points, indices.get(), sight, parameters);
  if (std::all_of(found->maps.begin(), found->maps.end(),
                  [](const WallMap& map) { return map.points().empty(); }))
    return "none of the " + std::to_string(indices ? indices->size() : points.size()) +
           " points lies at a wall of the floor plan";
  plan.openings.clear();
  for (PlanRoom& room : plan.rooms)
    room.niches.clear();
  findLeaves(plan, points, indices.get(), parameters.sizes, threads, found->found);
  nameOpenings(plan, *found, parameters.sizes);
  placeNiches(*found, plan);
  for (const FoundOpening& opening : found->found)
    plan.openings.push_back(opening.opening);
  measureEvidence(*found, threads, plan);
  search = std::move(found);
  return {};
}

} // namespace pcl::sedr

PCL_INSTANTIATE(OpeningDetection, SEDR_POINT_TYPES)
