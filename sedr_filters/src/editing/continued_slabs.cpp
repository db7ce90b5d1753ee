// SPDX-License-Identifier: BSD-3-Clause
#include "plan_outlines.h"
#include "room_references.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace pcl::sedr {
namespace {

constexpr double least = 1e-3; // area of a part, square metres

std::vector<PlanLoop>
difference(std::vector<PlanLoop> areas, const std::vector<PlanLoop>& without)
{
  for (const PlanLoop& loop : without)
    areas.push_back(reversed(loop));
  return unionOf(areas);
}

/** @brief A stretch of the border of an added area along one part of a ceiling or
 * floor.
 */
struct Border {
  PlanElement piece;
  int part = -1;
  std::vector<Eigen::Vector2d> places;
};

std::vector<Border>
bordersOf(const PlanLoop& added,
          const std::vector<PlanLoop>& before,
          const std::function<int(const Eigen::Vector2d&)>& partAt)
{
  constexpr double step = 0.01; // metres
  std::vector<Border> borders;
  for (const PlanElement& side : added.elements) {
    double from = 0;
    double to = 0;
    for (double s = 0; s < side.length(); s = to) {
      to = std::min(s + step, side.length());
      const double middle = (s + to) / 2;
      const Eigen::Vector2d place = side.pointAt(middle) - step * side.normalAt(middle);
      if (std::none_of(before.begin(), before.end(),
                       [&](const PlanLoop& loop) { return loop.contains(place); })) {
        from = to;
        continue;
      }
      if (from == s || borders.back().part != partAt(place)) {
        borders.push_back({{}, partAt(place), {side.pointAt(s)}});
        from = s;
      }
      borders.back().piece = side.part(from, to);
      borders.back().places.push_back(side.pointAt(to));
    }
  }
  return borders;
}

/** @brief Returns what is nearer to a border than to those of other parts. */
PlanLoop
besideBorder(const Border& border, const std::vector<Border>& borders, double farthest)
{
  PlanLoop area{{border.piece}};
  for (auto from = border.places.rbegin(); from != border.places.rend(); ++from) {
    const Eigen::Vector2d inwards = border.piece.normalAt(border.piece.project(*from));
    double radius = farthest; // of a circle that touches the border there
    for (const Border& other : borders)
      for (const Eigen::Vector2d& at : other.places) {
        const double across = (at - *from).dot(inwards);
        if (other.part != border.part && across > 0)
          radius = std::min(radius, (at - *from).squaredNorm() / 2 / across);
      }
    area.elements.push_back(
        segment(area.elements.back().end, *from + radius * inwards));
  }
  area.elements.push_back(segment(area.elements.back().end, border.piece.start));
  simplify(area);
  return area;
}

} // namespace

void
cover(const PlanLoop& added,
      const std::vector<PlanLoop>& before,
      PlanRoom& room,
      bool is_floor)
{
  std::vector<PlanDetail>& details = is_floor ? room.floor_details : room.details;
  const std::vector<Border> borders =
      bordersOf(added, before, [&](const Eigen::Vector2d& at) {
        return is_floor ? room.floorDetailAt(at) : room.detailAt(at);
      });
  const auto isFacet = [&](int part) {
    return part < 0 || details[static_cast<std::size_t>(part)].is_facet;
  };
  const auto longest = std::max_element(
      borders.begin(), borders.end(), [&](const Border& a, const Border& b) {
        return std::make_pair(isFacet(a.part), a.places.size()) <
               std::make_pair(isFacet(b.part), b.places.size());
      });
  const auto add = [&](const PlanLoop& area, int part) {
    PlanSlab slab = is_floor ? room.floorSlab(part) : room.ceilingSlab(part);
    setByHand(slab);
    details.push_back({area, {}, slab, isFacet(part)});
  };
  if (longest != borders.end() && longest->part >= 0)
    add(added, longest->part);
  for (const Border& border : borders)
    if (border.part != longest->part)
      for (const PlanLoop& area : difference(
               {added},
               difference({added}, {besideBorder(border, borders, added.length())})))
        if (area.area() > least)
          add(area, border.part);
  std::stable_partition(details.begin(), details.end(),
                        [](const PlanDetail& d) { return d.is_facet; });
}

void
continueSlabs(const Floorplan& before, Floorplan& plan)
{
  for (PlanRoom& room : plan.rooms) {
    const PlanRoom* const old = findRoom(before, room.id);
    if (!old || isSame(old->boundary, room.boundary))
      continue;
    std::vector<PlanLoop> olds;
    for (const PlanRoom& r : before.rooms)
      if (r.id == room.id || !findRoom(plan, r.id))
        olds.push_back(r.boundary);
    for (const PlanLoop& added : difference({room.boundary}, olds))
      if (added.area() > least)
        for (const bool is_floor : {false, true})
          cover(added, olds, room, is_floor);
  }
}

} // namespace pcl::sedr
