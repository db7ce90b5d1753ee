// SPDX-License-Identifier: BSD-3-Clause
#include "rooms_above.h"

#include "../curves/loop_difference.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace pcl::sedr {

namespace {

/** @brief A floor, or a part of one, in its region in plan. */
struct Floor {
  PlanSlab slab;
  PlanLoop region; ///< with its holes
  Eigen::AlignedBox2d box = boundsOf(region);
};

PlanLoop
joined(const std::vector<PlanLoop>& loops, PlanLoop region = {})
{
  for (const PlanLoop& loop : loops)
    region.elements.insert(region.elements.end(), loop.elements.begin(),
                           loop.elements.end());
  return region;
}

/** @brief Appends the floors of a room, lower and wider by a gap, its shafts left out.
 */
void
appendFloors(const PlanRoom& room, double gap, std::vector<Floor>& floors)
{
  PlanLoop plan = widened(room.boundary, gap);
  for (const PlanLoop& column : room.columns)
    plan = joined(difference(plan, widened(reversed(column), -gap)));
  const auto lowered = [&](const PlanSlab& slab) {
    return PlanSlab{slab.plane + gap * Eigen::Vector4d(0, 0, 0, slab.plane[2])};
  };
  floors.push_back({lowered(room.floor), plan});
  for (const PlanDetail& part : room.floor_details)
    floors.push_back({lowered(part.slab),
                      joined(intersection(joined(part.holes, part.boundary), plan))});
}

/** @brief Lowers the heights of a relief over and beside floors below these. In the
 * region of the ceiling, they count as not seen. */
void
lowerRelief(const std::vector<Floor>& floors, const PlanLoop& region, PlanSlab& ceiling)
{
  if (floors.empty() || !isRelief(ceiling))
    return;
  SlabCurve relief = *ceiling.curve;
  const double reach = M_SQRT2 * relief.spacing; // to the corners of a cell
  double within = 0;
  double lowered = 0;
  for (std::size_t k = 0; k < relief.heights.size(); ++k) {
    const Eigen::Vector2d place =
        relief.centre +
        relief.spacing * (static_cast<double>(k % relief.columns) * relief.axis +
                          static_cast<double>(k / relief.columns) *
                              Eigen::Vector2d(-relief.axis.y(), relief.axis.x()));
    double height = relief.heights[k];
    for (const Floor& floor : floors)
      if (floor.box.exteriorDistance(place) < reach &&
          (floor.region.contains(place) || floor.region.distance(place) < reach))
        height = std::min(height, floor.slab.heightAt(place));
    if (region.contains(place)) {
      ++within;
      lowered += height < relief.heights[k] ? 1 : 0;
    }
    relief.heights[k] = height;
  }
  ceiling.inferred += (1 - ceiling.inferred) * lowered / std::max(1.0, within);
  ceiling.curve = std::make_shared<const SlabCurve>(std::move(relief));
}

/** @brief Returns a square on the side of a line where one plane is above another one,
 * around a box that the line crosses. */
PlanLoop
sideAbove(const PlanSlab& high, const PlanSlab& low, const Eigen::AlignedBox2d& box)
{
  const Eigen::Vector2d rise =
      low.plane.head<2>() / low.plane[2] - high.plane.head<2>() / high.plane[2];
  const Eigen::Vector2d up = 2 * box.diagonal().norm() * rise.normalized();
  const Eigen::Vector2d left(-up.y(), up.x());
  const double above = high.heightAt(box.center()) - low.heightAt(box.center());
  const Eigen::Vector2d level = box.center() - above / rise.squaredNorm() * rise;
  return {{segment(level - left, level - left + up),
           segment(level - left + up, level + left + up),
           segment(level + left + up, level + left),
           segment(level + left, level - left)}};
}

/** @brief Returns the loops of the region where a ceiling is above a floor; of a curved
 * ceiling, all of what they have in common or nothing. */
std::vector<PlanLoop>
regionAbove(const PlanSlab& ceiling,
            const PlanLoop& region,
            const Floor& floor,
            const Priors& priors)
{
  if (!boundsOf(region).intersects(floor.box))
    return {};
  const std::vector<PlanLoop> loops = intersection(region, floor.region);
  const PlanLoop common = joined(loops);
  const std::vector<Eigen::Vector2d> corners = common.polygon(priors.unevenness);
  const auto above =
      std::count_if(corners.begin(), corners.end(), [&](const Eigen::Vector2d& p) {
        return ceiling.heightAt(p) > floor.slab.heightAt(p);
      });
  if (above == static_cast<std::ptrdiff_t>(corners.size()))
    return loops;
  if (above == 0 || ceiling.curve)
    return {};
  return intersection(common, sideAbove(ceiling, floor.slab, boundsOf(common)));
}

/** @brief Returns a part for each outer one of loops, with the holes in it, but for
 * strips. */
std::vector<PlanDetail>
partsOf(const std::vector<PlanLoop>& loops, const Priors& priors)
{
  std::vector<PlanDetail> parts;
  for (const PlanLoop& loop : loops) {
    if (loop.area() <= 0)
      continue;
    PlanDetail part;
    part.boundary = loop;
    for (const PlanLoop& hole : loops)
      if (hole.area() < 0 && loop.contains(hole.elements.front().pointAt(
                                 hole.elements.front().length() / 2)))
        part.holes.push_back(hole);
    const PlanLoop edges = joined(part.holes, loop);
    if (2 * edges.area() > priors.min_wall * edges.length())
      parts.push_back(std::move(part));
  }
  return parts;
}

/** @brief Tells whether anything but strips of a detail is outside parts that follow
 * it. */
bool
staysBeside(const PlanDetail& detail,
            const std::vector<PlanDetail>& parts,
            const Priors& priors)
{
  std::vector<PlanDetail> rest{detail};
  for (const PlanDetail& part : parts) {
    std::vector<PlanDetail> beside;
    const auto keep = [&](const std::vector<PlanLoop>& loops) {
      for (PlanDetail& kept : partsOf(loops, priors))
        beside.push_back(std::move(kept));
    };
    for (const PlanDetail& piece : rest) {
      const PlanLoop region = joined(piece.holes, piece.boundary);
      keep(difference(region, part.boundary));
      for (const PlanLoop& hole : part.holes)
        keep(intersection(region, reversed(hole)));
    }
    rest = std::move(beside);
  }
  return !rest.empty();
}

/** @brief Appends the parts of a ceiling that end below floors, the lowest floor last.
 */
void
appendParts(const PlanSlab& ceiling,
            const PlanLoop& region,
            bool is_facet,
            const std::vector<Floor>& floors,
            const Priors& priors,
            std::vector<PlanDetail>& parts)
{
  for (const Floor& floor : floors)
    for (PlanDetail& part :
         partsOf(regionAbove(ceiling, region, floor, priors), priors)) {
      part.slab.plane = floor.slab.plane;
      part.slab.inferred = 1;
      part.is_facet = is_facet;
      parts.push_back(std::move(part));
    }
}

} // namespace

void
endBelowRoomsAbove(Floorplan& plan, const Priors& priors)
{
  const std::vector<RoomHeights> heights = heightsOf(plan);
  for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
    PlanRoom& room = plan.rooms[r];
    const Eigen::AlignedBox2d box = boundsOf(room.boundary);
    std::vector<Floor> floors;
    for (std::size_t o = 0; o < plan.rooms.size(); ++o)
      if (heights[o].low > heights[r].low && !shareHeights(heights[o], heights[r]) &&
          boundsOf(plan.rooms[o].boundary).intersects(box))
        appendFloors(plan.rooms[o], priors.assumed_partition, floors);
    std::stable_sort(floors.begin(), floors.end(), [&](const Floor& a, const Floor& b) {
      return a.slab.heightAt(box.center()) > b.slab.heightAt(box.center());
    });
    lowerRelief(floors, room.boundary, room.ceiling);
    for (PlanDetail& detail : room.details)
      lowerRelief(floors, joined(detail.holes, detail.boundary), detail.slab);
    std::vector<PlanDetail> details;
    appendParts(room.ceiling, room.boundary, room.hasFacets(), floors, priors, details);
    for (const PlanDetail& detail : room.details) {
      std::vector<PlanDetail> parts;
      appendParts(detail.slab, joined(detail.holes, detail.boundary), detail.is_facet,
                  floors, priors, parts);
      if (parts.empty() || staysBeside(detail, parts, priors))
        details.push_back(detail);
      details.insert(details.end(), parts.begin(), parts.end());
    }
    room.details = std::move(details);
  }
}

} // namespace pcl::sedr
