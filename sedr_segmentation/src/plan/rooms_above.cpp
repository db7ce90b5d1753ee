// SPDX-License-Identifier: BSD-3-Clause
#include "rooms_above.h"

#include "../curves/loop_difference.h"
#include "sedr_filters/src/plan/plan_bounds.h"
#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace pcl::sedr {

namespace {

/** @brief Returns whether a ceiling is above another one anywhere in a loop. */
bool
isHigher(const PlanSlab& ceiling,
         const PlanSlab& other,
         const PlanLoop& loop,
         const Priors& priors)
{
  const auto isHigherAt = [&](const Eigen::Vector2d& p) {
    return ceiling.heightAt(p) > other.heightAt(p);
  };
  const std::vector<Eigen::Vector2d> corners = loop.polygon(priors.min_ceiling_step);
  if (std::any_of(corners.begin(), corners.end(), isHigherAt))
    return true;
  const Eigen::AlignedBox2d box = boundsOf(loop);
  Eigen::Vector2d p = box.min();
  for (; ceiling.curve && p.y() < box.max().y(); p.y() += priors.patch)
    for (p.x() = box.min().x(); p.x() < box.max().x(); p.x() += priors.patch)
      if (loop.contains(p) && isHigherAt(p))
        return true;
  return false;
}

/** @brief Appends the parts of a ceiling, within a loop, that a room's floor is below.
 */
void
appendParts(const PlanSlab& ceiling,
            const PlanLoop& loop,
            const PlanRoom& above,
            bool is_facet,
            const Priors& priors,
            std::vector<PlanDetail>& parts)
{
  const double gap = priors.assumed_partition;
  PlanDetail part;
  part.slab.plane = above.floor.plane;
  part.slab.plane[3] += gap * part.slab.plane[2];
  part.slab.inferred = 1;
  part.is_facet = is_facet;
  for (PlanLoop& common : intersection(loop, widened(above.boundary, gap))) {
    if (common.area() < priors.small_area ||
        !isHigher(ceiling, part.slab, common, priors))
      continue;
    part.holes.clear();
    for (const PlanLoop& hole : above.columns)
      if (common.contains(hole.elements.front().start))
        part.holes.push_back(reversed(widened(reversed(hole), -gap)));
    part.boundary = std::move(common);
    parts.push_back(part);
  }
}

} // namespace

void
endBelowRoomsAbove(Floorplan& plan, const Priors& priors)
{
  const std::vector<RoomHeights> heights = heightsOf(plan);
  for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
    PlanRoom& room = plan.rooms[r];
    const bool has_facets =
        std::any_of(room.details.begin(), room.details.end(),
                    [](const PlanDetail& detail) { return detail.is_facet; });
    std::vector<const PlanRoom*> above;
    for (std::size_t o = 0; o < plan.rooms.size(); ++o)
      if (heights[o].low > heights[r].low && !shareHeights(heights[o], heights[r]))
        above.push_back(&plan.rooms[o]);
    std::vector<PlanDetail> details;
    const auto appendAbove = [&](const PlanSlab& ceiling, const PlanLoop& loop) {
      for (const PlanRoom* other : above)
        appendParts(ceiling, loop, *other, has_facets, priors, details);
    };
    appendAbove(room.ceiling, room.boundary);
    for (const PlanDetail& detail : room.details) {
      details.push_back(detail);
      appendAbove(detail.slab, detail.boundary);
    }
    room.details = std::move(details);
  }
}

} // namespace pcl::sedr
