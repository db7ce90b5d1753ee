// SPDX-License-Identifier: BSD-3-Clause
#include "plan_outlines.h"
#include "room_references.h"

#include <algorithm>
#include <cstddef>
#include <functional>
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

/** @brief A stretch of the border between a room as it was and what is added to it. */
struct Border {
  PlanElement piece;
  int part = -1; ///< of the floor or ceiling that ends there
  std::vector<Eigen::Vector2d> places;
};

constexpr double step = 0.01; // between places on a border, metres

/** @brief Returns how the border of an area that a room got consists of stretches along
 * parts of its ceiling or floor. */
std::vector<Border>
bordersOf(const PlanLoop& added,
          const std::vector<PlanLoop>& before,
          const std::function<int(const Eigen::Vector2d&)>& partAt)
{
  std::vector<Border> borders;
  for (const PlanElement& side : added.elements) {
    double from = 0;
    bool goes_on = false;
    for (double s = 0; s < side.length(); s += step) {
      const double to = std::min(s + step, side.length());
      const Eigen::Vector2d place =
          side.pointAt((s + to) / 2) - step * side.normalAt((s + to) / 2);
      const bool is_border =
          std::any_of(before.begin(), before.end(),
                      [&](const PlanLoop& loop) { return loop.contains(place); });
      const int part = is_border ? partAt(place) : -1;
      goes_on = is_border && goes_on && borders.back().part == part;
      from = goes_on ? from : s;
      if (is_border && !goes_on)
        borders.push_back({{}, part, {side.pointAt(s)}});
      if (is_border) {
        borders.back().piece = side.part(from, to);
        borders.back().places.push_back(side.pointAt(to));
      }
      goes_on = is_border;
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
  const auto longest = std::max_element(borders.begin(), borders.end(),
                                        [](const Border& a, const Border& b) {
                                          return a.places.size() < b.places.size();
                                        });
  if (longest == borders.end())
    return;
  const auto slabOf = [&](const Border& border) {
    PlanSlab slab =
        is_floor ? room.floorSlab(border.part) : room.ceilingSlab(border.part);
    setByHand(slab);
    return slab;
  };
  const auto isFacet = [&](const Border& border) {
    return border.part < 0 || details[static_cast<std::size_t>(border.part)].is_facet;
  };
  const bool is_one =
      std::all_of(borders.begin(), borders.end(),
                  [&](const Border& border) { return border.part == longest->part; });
  PlanDetail all{added, {}, slabOf(*longest), isFacet(*longest)};
  if (!is_one) { // corners that are beside none are level
    const double z = all.slab.heightAt(longest->places[longest->places.size() / 2]);
    all.slab = {Eigen::Vector4d(0, 0, 1, -z), 0, 0, 1};
  }
  if (!is_one || longest->part >= 0)
    details.push_back(all);
  for (const Border& border : borders)
    if (!is_one)
      for (const PlanLoop& area : difference(
               {added},
               difference({added}, {besideBorder(border, borders, added.length())})))
        if (area.area() > least)
          details.push_back({area, {}, slabOf(border), isFacet(border)});
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
    std::vector<PlanLoop> loops{room.boundary};
    for (const PlanRoom& r : before.rooms)
      if (r.id == room.id || !findRoom(plan, r.id))
        loops.push_back(r.boundary);
    std::vector<Eigen::Vector2d> ends;
    for (const PlanLoop& loop : loops)
      for (const PlanElement& e : loop.elements)
        ends.push_back(e.start);
    for (PlanLoop& loop : loops)
      loop = cutAt(loop, ends);
    const std::vector<PlanLoop> olds(loops.begin() + 1, loops.end());
    for (const PlanLoop& added : difference({loops[0]}, olds))
      if (added.area() > least)
        for (const bool is_floor : {false, true})
          if (!(is_floor ? room.floor_details : room.details).empty())
            cover(added, olds, room, is_floor);
  }
}

} // namespace pcl::sedr
