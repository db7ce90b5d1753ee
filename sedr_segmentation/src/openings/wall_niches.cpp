// SPDX-License-Identifier: BSD-3-Clause
#include "opening_search.h"

#include "../curves/loop_difference.h"
#include "sedr_filters/src/base/plane_fit.h"
#include "sedr_filters/src/base/quantiles.h"
#include "sedr_filters/src/plan/plan_geometry.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {
namespace {

/** @brief How deep the nearest and the farthest thing in a cell lie behind the face. */
struct CellDepths {
  double nearest;
  double farthest; ///< 0: nothing is behind the face
};

/** @brief Returns the depths in the cells of a rectangle, away from its rim; without
 * those that are hidden. */
std::vector<CellDepths>
depthsIn(const WallMap& map, const WallRectangle& at)
{
  const double cell = map.cell();
  // Cells whose middles lie between two ends, but for one at each.
  const auto between = [&](double low, double high, std::size_t cells) {
    const auto number = [&](double end) {
      return static_cast<std::size_t>(
          std::clamp(std::ceil(end), 0.0, static_cast<double>(cells)));
    };
    return std::pair(number(low / cell + 0.5), number(high / cell - 1.5));
  };
  const double base = map.heightOf(0);
  const auto [c0, c1] = between(at.from, at.to, map.columns());
  const auto [r0, r1] = between(at.bottom - base, at.top - base, map.rows());
  std::vector<CellDepths> depths;
  for (std::size_t c = c0; c < c1; ++c)
    for (std::size_t r = r0; r < r1; ++r)
      if (const WallCell state = map.at(c, r);
          state != WallCell::Beyond && !isHidden(state))
        depths.push_back({-map.offsetAt(c, r), -map.farthestAt(c, r)});
  return depths;
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

OpeningBack
backOf(const WallMap& map, const WallRectangle& at)
{
  const double tolerance = std::max(map.tolerance(), opening_numbers.back_band);
  const std::vector<CellDepths> cells = depthsIn(map, at);
  std::vector<double> depths;
  for (const CellDepths& cell : cells)
    if (cell.farthest > tolerance)
      depths.push_back(cell.farthest);
  OpeningBack back;
  if (depths.empty())
    return back;
  std::sort(depths.begin(), depths.end());
  const auto [first, last] = densestWindow(depths, 2 * tolerance);
  back.depth = depths[(first + last) / 2];
  std::vector<double> middles; // of their noise
  for (const CellDepths& cell : cells) {
    const double off = cell.farthest - back.depth;
    back.beyond += off > 1.5 * tolerance ? 1 : 0;
    back.closed += std::abs(off) <= 1.5 * tolerance ? 1 : 0;
    if (std::abs(off) <= 1.5 * tolerance &&
        cell.farthest - cell.nearest < 3 * tolerance)
      middles.push_back((cell.nearest + cell.farthest) / 2);
  }
  back.beyond /= static_cast<double>(cells.size());
  back.closed /= static_cast<double>(cells.size());
  if (!middles.empty())
    back.depth = middleValue(std::move(middles));
  return back;
}

double
headOfBack(const WallMap& map, const WallRectangle& at, const OpeningSizes& sizes)
{
  const double tolerance = std::max(map.tolerance(), opening_numbers.back_band);
  const double all = backOf(map, at).closed;
  double best = std::max(all, 1 - all) * (at.top - at.bottom);
  double head = at.bottom;
  for (double z = at.bottom + sizes.min_height; z < at.top - sizes.min_height;
       z += map.cell()) {
    const OpeningBack below = backOf(map, {at.from, at.to, at.bottom, z});
    const auto above = depthsIn(map, {at.from, at.to, z, at.top});
    const auto others =
        std::count_if(above.begin(), above.end(), [&](const CellDepths& cell) {
          return std::abs(cell.farthest - below.depth) > 1.5 * tolerance;
        });
    const double open =
        static_cast<double>(others) / std::max(1.0, static_cast<double>(above.size()));
    if (const double right = below.closed * (z - at.bottom) + open * (at.top - z);
        right > best) {
      best = right;
      head = z;
    }
  }
  return head;
}

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
  const auto isBeside = [&, p = sides[1].start](const PlanNiche& other) {
    return niche.bottom.heightAt(p) < other.top.heightAt(p) &&
           other.bottom.heightAt(p) < niche.top.heightAt(p);
  };
  return std::any_of(plan.rooms.begin(), plan.rooms.end(), [&](const PlanRoom& other) {
    return &other != &room && shareHeights(room, other) &&
           (overlap(niche.boundary, other.boundary) ||
            std::any_of(other.niches.begin(), other.niches.end(),
                        [&](const PlanNiche& n) {
                          return isBeside(n) && overlap(niche.boundary, n.boundary);
                        }));
  });
}

PlanNiche
nicheOf(const Floorplan& plan,
        const OpeningSearch& search,
        const FoundOpening& found,
        const OpeningSizes& sizes)
{
  const WallSide& side = search.sides[found.side];
  const PlanRoom& room = plan.rooms[side.room];
  const WallRectangle& at = found.rectangle;
  const PlanElement& wall = side.line;
  const double depth = found.back.depth;
  const Priors priors;
  const Eigen::Vector2d inside =
      wall.pointAt((at.from + at.to) / 2) + opening_numbers.inside * wall.normalAt(0);
  const bool is_on_floor =
      found.opening.bottom - room.floorAt(inside) < priors.wall_band;
  const bool is_at_ceiling = at.top > room.ceilingAt(inside) - priors.wall_band;
  if (!side.isWall() || wall.isArc() || !(depth > 0) || depth > sizes.max_niche ||
      found.back.beyond > priors.share_little / 2 || (is_on_floor && is_at_ceiling))
    return {};
  const Eigen::Vector2d out = -depth * wall.normalAt(0);
  const Eigen::Vector2d left = wall.pointAt(at.from);
  const Eigen::Vector2d right = wall.pointAt(at.to);
  PlanNiche niche;
  niche.boundary.elements = {segment(left, left + out),
                             segment(left + out, right + out),
                             segment(right + out, right), segment(right, left)};
  niche.bottom = is_on_floor ? room.floorSlab(room.floorDetailAt(inside))
                             : horizontalSlab(at.bottom);
  niche.top =
      is_at_ceiling ? room.ceilingSlab(room.detailAt(inside)) : horizontalSlab(at.top);
  return isShared(plan, room, niche) ? PlanNiche() : niche;
}

void
placeNiches(OpeningSearch& search, Floorplan& plan)
{
  std::vector<FoundOpening>& found = search.found;
  const auto niches =
      std::stable_partition(found.begin(), found.end(),
                            [](const FoundOpening& each) { return !each.isNiche(); });
  for (auto each = niches; each != found.end(); ++each) {
    PlanRoom& room = plan.rooms[search.sides[each->side].room];
    const auto isAbove = [&](const PlanNiche& other) {
      return overlap(other.boundary, each->niche.boundary);
    };
    if (!isShared(plan, room, each->niche) &&
        std::none_of(room.niches.begin(), room.niches.end(), isAbove))
      room.niches.push_back(each->niche);
  }
  found.erase(niches, found.end());
}

} // namespace pcl::sedr
