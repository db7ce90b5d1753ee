// SPDX-License-Identifier: BSD-3-Clause
#include "opening_search.h"

#include "../curves/loop_difference.h"
#include "sedr_filters/src/base/plane_fit.h"
#include "sedr_filters/src/base/quantiles.h"
#include "sedr_filters/src/plan/plan_geometry.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>

namespace pcl::sedr {
namespace {

/** @brief Returns how deep the back of a candidate lies behind its wall, metres; 0 if
 * it has none. */
double
depthOfBack(const WallMap& map, const WallRectangle& at, const Priors& priors)
{
  const double cell = map.cell();
  const double tolerance = std::max(map.tolerance(), 0.6 * priors.wall_band);
  std::vector<std::pair<double, double>> offsets; // of the nearest and farthest thing
  std::vector<double> depths;
  for (std::size_t c = 0; c < map.columns(); ++c)
    for (std::size_t r = 0; r < map.rows(); ++r) {
      const double s = cell * (static_cast<double>(c) + 0.5);
      const double z = map.heightOf(r) + cell / 2;
      if (s < at.from + cell || s > at.to - cell || z < at.bottom + cell ||
          z > at.top - cell || map.at(c, r) == WallCell::Beyond)
        continue;
      offsets.emplace_back(map.offsetAt(c, r), map.farthestAt(c, r));
      if (const double depth = -map.offsetAt(c, r);
          depth > tolerance && depth <= priors.max_niche_depth + tolerance)
        depths.push_back(depth);
    }
  if (depths.empty())
    return 0;
  std::sort(depths.begin(), depths.end());
  const auto [first, last] = densestWindow(depths, 2 * tolerance);
  const double depth = depths[(first + last) / 2];
  std::vector<double> backs; // in the middle of their noise
  double closed = 0;
  double beyond = 0;
  for (const auto& [nearest, farthest] : offsets) {
    const bool is_closed = std::abs(nearest + depth) <= 1.5 * tolerance;
    const bool goes_on = farthest < -depth - 1.5 * tolerance;
    closed += is_closed ? 1 : 0;
    beyond += goes_on ? 1 : 0;
    if (is_closed && !goes_on)
      backs.push_back(-(nearest + farthest) / 2);
  }
  const auto all = static_cast<double>(offsets.size());
  return !backs.empty() && closed >= priors.share_closed * all &&
                 beyond <= priors.share_little / 2 * all &&
                 depth >= priors.min_niche_depth && depth <= priors.max_niche_depth
             ? middleValue(std::move(backs))
             : 0;
}

/** @brief Returns a candidate as a niche of its room, without one if it is none. */
PlanNiche
nicheOf(const PlanRoom& room,
        const WallSide& side,
        const WallMap& map,
        const FoundOpening& found,
        const Priors& priors)
{
  PlanNiche niche;
  const WallRectangle& at = found.rectangle;
  const PlanElement& wall = side.line;
  if (!side.isWall() || wall.isArc() || at.to - at.from < priors.min_recess ||
      at.top - at.bottom < priors.min_recess)
    return niche;
  const Eigen::Vector2d inside =
      wall.pointAt((at.from + at.to) / 2) + opening_numbers.inside * wall.normalAt(0);
  const bool is_on_floor =
      found.opening.bottom - room.floorAt(inside) < priors.wall_band;
  const bool is_at_ceiling = at.top > room.ceilingAt(inside) - priors.wall_band;
  const double depth = is_on_floor && is_at_ceiling ? 0 : depthOfBack(map, at, priors);
  if (!(depth > 0))
    return niche;
  const Eigen::Vector2d out = -depth * wall.normalAt(0);
  const Eigen::Vector2d left = wall.pointAt(at.from);
  const Eigen::Vector2d right = wall.pointAt(at.to);
  niche.boundary.elements = {segment(left, left + out),
                             segment(left + out, right + out),
                             segment(right + out, right), segment(right, left)};
  niche.bottom = is_on_floor ? room.floorSlab(room.floorDetailAt(inside))
                             : horizontalSlab(at.bottom);
  niche.top =
      is_at_ceiling ? room.ceilingSlab(room.detailAt(inside)) : horizontalSlab(at.top);
  return niche;
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

bool
isShared(const Floorplan& plan, const PlanRoom& room, const PlanNiche& niche)
{
  // Of its own room: beyond the noise of its mouth.
  const auto& sides = niche.boundary.elements;
  const Eigen::Vector2d out = sides[0].end - sides[0].start;
  for (double s = 0; s <= 1; s += 0.125)
    if (const Eigen::Vector2d back = sides[1].pointAt(s * sides[1].length());
        room.boundary.contains(back) || room.boundary.contains(back - out / 2))
      return true;
  return std::any_of(plan.rooms.begin(), plan.rooms.end(), [&](const PlanRoom& other) {
    return &other != &room && shareHeights(room, other) &&
           (overlap(niche.boundary, other.boundary) ||
            std::any_of(other.niches.begin(), other.niches.end(),
                        [&](const PlanNiche& n) {
                          return overlap(niche.boundary, n.boundary);
                        }));
  });
}

void
findNiches(const Priors& priors, const OpeningSearch& search, Floorplan& plan)
{
  for (PlanRoom& room : plan.rooms)
    room.niches.clear();
  using Candidate = std::pair<const FoundOpening*, PlanNiche>;
  std::vector<Candidate> candidates;
  for (const FoundOpening& found : search.found) {
    const WallSide& side = search.sides[found.side];
    PlanNiche niche =
        nicheOf(plan.rooms[side.room], side, search.maps[found.side], found, priors);
    if (!niche.boundary.elements.empty())
      candidates.emplace_back(&found, std::move(niche));
  }
  const auto areaOf = [](const Candidate& candidate) {
    const WallRectangle& at = candidate.first->rectangle;
    return (at.to - at.from) * (at.top - at.bottom);
  };
  std::stable_sort(
      candidates.begin(), candidates.end(),
      [&](const Candidate& a, const Candidate& b) { return areaOf(a) > areaOf(b); });
  for (Candidate& candidate : candidates) {
    PlanRoom& room = plan.rooms[search.sides[candidate.first->side].room];
    const auto isAbove = [&](const PlanNiche& other) {
      return overlap(other.boundary, candidate.second.boundary);
    };
    if (!isShared(plan, room, candidate.second) &&
        std::none_of(room.niches.begin(), room.niches.end(), isAbove))
      room.niches.push_back(std::move(candidate.second));
  }
}

} // namespace pcl::sedr
