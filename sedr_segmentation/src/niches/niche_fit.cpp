// SPDX-License-Identifier: BSD-3-Clause
#include "wall_recess.h"

#include "niche_fit.h"

#include "../curves/loop_difference.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/plane_fit.h"
#include "sedr_filters/src/grids/cell_count.h"
#include "sedr_filters/src/grids/cell_mask.h"
#include "sedr_filters/src/grids/place_table.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Returns whether a wall may have niches. */
bool
mayHaveNiches(const PlanElement& wall, const NicheParameters& parameters)
{
  return !wall.isArc() && wall.length() >= parameters.priors.min_recess;
}

/** @brief Returns for each wall of a room the points on it or within `reach` behind it,
 * and some others nearby. */
std::vector<std::vector<int>>
pointsByWall(const PointView& points,
             const std::vector<int>& indices,
             const std::vector<PlanElement>& walls,
             double reach,
             const NicheParameters& parameters)
{
  PlaceTable walls_near(parameters.priors.patch);
  for (std::size_t k = 0; k < walls.size(); ++k)
    if (mayHaveNiches(walls[k], parameters))
      walls_near.addAlong(walls[k], reach, static_cast<std::uint32_t>(k));
  walls_near.finish();
  std::vector<std::vector<int>> near(walls.size());
  for (const int i : indices)
    for (const std::uint32_t k :
         walls_near.at(points[static_cast<std::size_t>(i)].head<2>().cast<double>()))
      near[k].push_back(i);
  return near;
}

/** @brief Returns a wall with the points on it and behind it. */
UnrolledWall
unroll(const PointView& points,
       const std::vector<int>& around,
       const PlanRoom& room,
       const PlanElement& element,
       double farthest,
       const Priors& priors)
{
  UnrolledWall wall{element,
                    0,
                    std::clamp(2.5 * element.residual, 0.6 * priors.wall_band,
                               1.2 * priors.wall_band),
                    {}};
  const Eigen::Vector2d inside =
      element.pointAt(element.length() / 2) + 0.01 * element.normalAt(0);
  const double floor = room.floorAt(inside);
  wall.height = room.ceilingAt(inside) - floor;
  const PlanSlab base = horizontalSlab(floor);
  const double length = element.length();
  for (const int i : around) {
    const WallPoint seen = seenFrom(element, base, points[static_cast<std::size_t>(i)]);
    if (seen.behind >= -wall.tolerance && seen.behind <= farthest && seen.along >= 0 &&
        seen.along <= length && seen.up >= -priors.surface_band &&
        seen.up <= wall.height)
      wall.points.push_back(seen);
  }
  return wall;
}

PlanNiche
nicheOf(const PlanRoom& room, const UnrolledWall& wall, const Recess& recess)
{
  const Eigen::Vector2d out = -recess.depth * wall.element.normalAt(0);
  const Eigen::Vector2d left = wall.element.pointAt(recess.left);
  const Eigen::Vector2d right = wall.element.pointAt(recess.right);
  PlanNiche niche;
  niche.boundary.elements = {segment(left, left + out),
                             segment(left + out, right + out),
                             segment(right + out, right), segment(right, left)};
  const Eigen::Vector2d inside = (left + right) / 2 + 0.01 * wall.element.normalAt(0);
  const double floor = room.floorAt(inside);
  niche.bottom = recess.low > 0.02 ? horizontalSlab(floor + recess.low)
                                   : room.floorSlab(room.floorDetailAt(inside));
  niche.top = recess.high < wall.height ? horizontalSlab(floor + recess.high)
                                        : room.ceilingSlab(room.detailAt(inside));
  return niche;
}

/** @brief Returns whether a niche reaches into another wing of its own room. */
bool
reachesInto(const PlanRoom& room, const PlanNiche& niche, double step)
{
  const auto& sides = niche.boundary.elements;
  const Eigen::Vector2d back = sides[1].end - sides[1].start;
  const Eigen::Vector2d out = sides[0].end - sides[0].start;
  for (double s = step; s < back.norm(); s += step)
    for (double d = step; d < out.norm() + step; d += step)
      if (room.boundary.contains(sides[0].start + s * back.normalized() +
                                 d * out.normalized()))
        return true;
  return false;
}

/** @brief Returns the recesses with the largest mouths among those above each other, as
 * a plan has one floor and one ceiling per position. */
std::vector<Recess>
largestOf(std::vector<Recess> recesses)
{
  std::stable_sort(
      recesses.begin(), recesses.end(),
      [](const Recess& a, const Recess& b) { return a.mouth() > b.mouth(); });
  std::vector<Recess> kept;
  for (const Recess& recess : recesses)
    if (std::none_of(kept.begin(), kept.end(), [&](const Recess& k) {
          return k.left < recess.right && recess.left < k.right;
        }))
      kept.push_back(recess);
  std::sort(kept.begin(), kept.end(),
            [](const Recess& a, const Recess& b) { return a.left < b.left; });
  return kept;
}

/** @brief Finds the niches of a straight wall. */
std::vector<PlanNiche>
nichesIn(const UnrolledWall& wall,
         const PlanRoom& room,
         const NicheParameters& parameters)
{
  const CellGrid grid(parameters.cell_size);
  const Priors& priors = parameters.priors;
  const auto least = static_cast<std::size_t>(cellsFor(priors.min_recess, grid.size()) *
                                              cellsFor(priors.min_recess, grid.size()));
  const CellMask open = openCells(wall, grid);
  const MaskRegions regions = labelRegions(open, false);
  std::vector<Recess> recesses;
  for (std::size_t r = 0; r < regions.sizes.size(); ++r) {
    if (regions.sizes[r] < least)
      continue;
    Recess recess;
    if (!findRecess(wall, regionMask(open, regions, static_cast<std::int32_t>(r)), grid,
                    parameters, recess))
      continue;
    const bool is_at_floor = recess.low < priors.run_gap && !recess.has_bottom;
    if (is_at_floor && recess.high == wall.height) // a part of the room
      continue;
    if (is_at_floor)
      recess.low = 0;
    recesses.push_back(recess);
  }
  std::vector<PlanNiche> niches;
  for (const Recess& recess : largestOf(std::move(recesses))) {
    PlanNiche niche = nicheOf(room, wall, recess);
    if (!reachesInto(room, niche, parameters.cell_size))
      niches.push_back(std::move(niche));
  }
  return niches;
}

/** @brief Returns whether two regions in plan overlap. */
bool
overlap(const PlanLoop& a, const PlanLoop& b)
{
  if (!boundsOf(a).intersects(boundsOf(b)))
    return false;
  const auto [of_a, of_b] = partsInside(a, b);
  return !of_a.empty() || !of_b.empty();
}

} // namespace

std::vector<PlanNiche>
fitNiches(const PointView& points,
          const std::vector<int>& around,
          const PlanRoom& room,
          const NicheParameters& parameters)
{
  const std::vector<PlanElement>& walls = room.boundary.elements;
  const double reach =
      parameters.priors.max_niche_depth + viewBehind(parameters.priors);
  const std::vector<std::vector<int>> near =
      pointsByWall(points, around, walls, reach, parameters);
  std::vector<std::vector<PlanNiche>> niches_of(walls.size());
  parallelBlocks(walls.size(), 1, parameters.threads, [&](std::size_t k, std::size_t) {
    const PlanElement& element = walls[k];
    if (mayHaveNiches(element, parameters))
      niches_of[k] =
          nichesIn(unroll(points, near[k], room, element, reach, parameters.priors),
                   room, parameters);
  });
  std::vector<PlanNiche> niches;
  for (auto& own : niches_of)
    niches.insert(niches.end(), own.begin(), own.end());
  return niches;
}

void
dropSharedNiches(Floorplan& plan)
{
  for (PlanRoom& room : plan.rooms) {
    const auto isShared = [&](const PlanNiche& niche) {
      return std::any_of(
          plan.rooms.begin(), plan.rooms.end(), [&](const PlanRoom& other) {
            return &other != &room && shareHeights(room, other) &&
                   (overlap(niche.boundary, other.boundary) ||
                    std::any_of(other.niches.begin(), other.niches.end(),
                                [&](const PlanNiche& n) {
                                  return overlap(niche.boundary, n.boundary);
                                }));
          });
    };
    room.niches.erase(std::remove_if(room.niches.begin(), room.niches.end(), isShared),
                      room.niches.end());
  }
}

} // namespace pcl::sedr
