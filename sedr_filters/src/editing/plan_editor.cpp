// SPDX-License-Identifier: BSD-3-Clause
#include "../base/number_text.h"
#include "../plan/missing_things.h"
#include "../plan/plan_check.h"
#include "../walls/plan_walls.h"
#include "plan_edits.h"

#include <pcl/sedr_filters/plan_editor.h>
#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl::sedr {
namespace {

std::string
nameOf(const PlanRoom& room)
{
  return "room " + std::to_string(room.id);
}

std::string
heightText(const PlanRoom& room)
{
  const RoomHeights heights = heightsOf(room);
  const auto text = [](double z) {
    return numberText(std::round(z * 100) / 100 + 0.0);
  };
  return nameOf(room) + " from z " + text(heights.low) + " to " + text(heights.high) +
         " m";
}

double
commonHeight(const PlanRoom& a, const PlanRoom& b)
{
  const RoomHeights of_a = heightsOf(a);
  const RoomHeights of_b = heightsOf(b);
  return std::max(std::min(of_a.high, of_b.high) - std::max(of_a.low, of_b.low), 0.0);
}

/** @brief Returns which two rooms overlap more than the rooms did that they were. */
std::string
overlapProblem(const Floorplan& before, const Floorplan& after)
{
  constexpr double negligible = 1e-3; // square metres
  const auto isGone = [&](const PlanRoom& room) { return !findRoom(after, room.id); };
  for (const PlanRoom& room : after.rooms)
    for (const PlanRoom& other : after.rooms) {
      const PlanRoom* const old = findRoom(before, room.id);
      const PlanRoom* const was = findRoom(before, other.id);
      if (room.id == other.id || !old)
        continue;
      const bool is_same = isSame(old->boundary, room.boundary);
      if (is_same && was && isSame(was->boundary, other.boundary) &&
          commonHeight(room, other) >
              std::max(commonHeight(*old, *was), commonHeight(*old, other)) +
                  touching &&
          commonArea(room, other) > negligible)
        return heightText(room) + " would then meet " + heightText(other);
      if (is_same || !shareHeights(room, other))
        continue;
      const double area = commonArea(room, other);
      double known = 0;
      for (const PlanRoom& r : before.rooms)
        if (r.id == room.id || isGone(r))
          known += commonArea(r, other);
      if (area > known + negligible)
        return nameOf(room) + " would then overlap " + nameOf(other) + " by " +
               formatText("%.2f m2", area);
    }
  return {};
}

/** @brief Tells the rooms whose areas or walls are others. */
std::string
changesOf(const Floorplan& before, const Floorplan& after)
{
  constexpr double told = 0.005; // square metres
  std::string text;
  for (const PlanRoom& room : after.rooms) {
    const PlanRoom* const old = findRoom(before, room.id);
    const std::size_t walls = room.boundary.elements.size();
    const bool is_area = !old || std::abs(room.area() - old->area()) > told;
    if (is_area)
      text += "; " + nameOf(room) + formatText(" has %.2f m2", room.area()) +
              (old ? formatText(" in place of %.2f", old->area()) : "");
    if (old && walls != old->boundary.elements.size())
      text += (is_area ? " and " : "; " + nameOf(room) + " has ") +
              std::to_string(walls) + " walls in place of " +
              std::to_string(old->boundary.elements.size()) + ", numbered anew";
  }
  return text;
}

/** @brief Returns what is between two rooms where they are the two sides of a wall. */
std::vector<PlanLoop>
wallsBetween(const Floorplan& plan,
             const PlanRoom& a,
             const PlanRoom& b,
             double thickest)
{
  WallParameters parameters;
  parameters.max_thickness = thickest;
  parameters.with_touching = true;
  std::vector<PlanLoop> walls;
  for (const PlanWall& wall : pairFaces(plan, parameters).walls) {
    const std::uint32_t one = plan.rooms[wall.face.room].id;
    const std::uint32_t two = plan.rooms[wall.other->room].id;
    if (std::minmax(one, two) != std::minmax(a.id, b.id))
      continue;
    const PlanElement& near = elementOf(plan, wall.face);
    const PlanElement& far = elementOf(plan, *wall.other);
    // What is left of a wall is no shorter than walls are exact.
    const auto endOrPlace = [](const PlanElement& face, double s) {
      constexpr double least = 0.02; // metres
      return s < least ? 0 : s > face.length() - least ? face.length() : s;
    };
    const Stretch& on = wall.stretch;
    const double from = endOrPlace(near, on.from);
    const double to = endOrPlace(near, on.to);
    const double back = endOrPlace(far, far.project(near.pointAt(on.to)));
    const double there = endOrPlace(far, far.project(near.pointAt(on.from)));
    if (!(from < to && back < there))
      continue;
    PlanLoop between = reversed({{near.part(from, to)}});
    const PlanElement back_side = reversed({{far.part(back, there)}}).elements[0];
    between.elements.push_back(segment(between.elements[0].end, back_side.start));
    between.elements.push_back(back_side);
    between.elements.push_back(segment(back_side.end, between.elements[0].start));
    for (PlanElement& side : between.elements)
      setByHand(plan, side);
    simplify(between);
    walls.push_back(between.area() < 0 ? reversed(between) : between);
  }
  return walls;
}

/** @brief Appends the part of a floor or ceiling that is elsewhere than the room's, and
 * the details of another room. */
void
addDetails(const PlanSlab& slab,
           const PlanRoom& of,
           const PlanSlab& added_slab,
           const std::vector<PlanDetail>& added,
           std::vector<PlanDetail>& details)
{
  constexpr double level = 0.005; // metres
  const bool is_other = std::any_of(
      of.boundary.elements.begin(), of.boundary.elements.end(),
      [&](const PlanElement& e) {
        return std::abs(slab.heightAt(e.start) - added_slab.heightAt(e.start)) > level;
      });
  if (is_other)
    details.push_back({of.boundary, {}, added_slab, true});
  details.insert(details.end(), added.begin(), added.end());
}

} // namespace

PlanEditor::PlanEditor(Floorplan plan, double max_wall)
    : plan_(std::move(plan))
    , max_wall_(max_wall)
{
  numberOpenings(plan_);
}

bool
PlanEditor::apply(const std::function<std::string(Floorplan&)>& change)
{
  Floorplan changed = plan_;
  warnings_.clear();
  sentence_.clear();
  problem_ = change(changed);
  for (const PlanRoom& r : changed.rooms)
    if (const PlanRoom* const before = findRoom(plan_, r.id); problem_.empty())
      if (const std::string wrong = outlineProblem(r.boundary);
          !wrong.empty() && (!before || outlineProblem(before->boundary).empty()))
        problem_ = "the outline of " + nameOf(r) + " then " + wrong;
  if (problem_.empty())
    problem_ = overlapProblem(plan_, changed);
  std::vector<std::string> warnings;
  if (problem_.empty()) {
    continueSlabs(plan_, changed);
    warnings = attachOpenings(plan_, changed, max_wall_);
    problem_ = planProblem(changed);
  }
  if (!problem_.empty()) {
    sentence_.clear();
    return false;
  }
  warnings_ = std::move(warnings);
  for (std::string& flight : flightsThroughWalls(plan_, changed))
    warnings_.push_back(std::move(flight));
  sentence_ += changesOf(plan_, changed);
  plan_ = std::move(changed);
  return true;
}

bool
PlanEditor::apply(std::uint32_t room,
                  const std::function<std::string(Floorplan&, PlanRoom&)>& change)
{
  return apply([&](Floorplan& plan) {
    PlanRoom* const found = findRoom(plan, room);
    return found ? change(plan, *found) : lacksRoom(plan, room);
  });
}

bool
PlanEditor::apply(
    std::uint32_t room,
    std::size_t wall,
    const std::function<std::string(Floorplan&, PlanRoom&, std::size_t)>& change)
{
  return apply(room, [&](Floorplan& plan, PlanRoom& of) -> std::string {
    const std::size_t walls = of.boundary.elements.size();
    if (wall < 1 || wall > walls)
      return "there is no wall " + std::to_string(room) + "." + std::to_string(wall) +
             ": " + nameOf(of) + " has " + std::to_string(walls);
    return change(plan, of, wall - 1);
  });
}

bool
PlanEditor::name(std::uint32_t room, const std::string& text)
{
  return apply(room, [&](Floorplan&, PlanRoom& named) {
    named.name = text;
    sentence_ = nameOf(named) + (text.empty() ? " has no name" : " is called " + text);
    return std::string();
  });
}

bool
PlanEditor::merge(std::uint32_t room, std::uint32_t other)
{
  return apply(room, [&](Floorplan& plan, PlanRoom& first) -> std::string {
    PlanRoom* const second = findRoom(plan, other);
    if (!second)
      return lacksRoom(plan, other);
    if (room == other)
      return nameOf(*second) + " cannot be merged with itself";
    if (!shareHeights(first, *second))
      return "they lie at different heights: " + heightText(first) + ", " +
             heightText(*second);
    std::vector<PlanLoop> areas = wallsBetween(plan, first, *second, max_wall_);
    const std::size_t walls = areas.size();
    std::vector<Eigen::Vector2d> ends; // of the walls
    for (const PlanLoop& wall : areas)
      for (const PlanElement& side : wall.elements)
        ends.push_back(side.start);
    for (const PlanRoom* part : {&first, &*second}) {
      areas.push_back(part->boundary);
      areas.insert(areas.end(), part->columns.begin(), part->columns.end());
    }
    const std::vector<PlanLoop> loops = unionOf(areas);
    if (walls == 0 || std::count_if(loops.begin(), loops.end(), [](const PlanLoop& l) {
                        return l.area() > 0;
                      }) != 1)
      return "rooms " + std::to_string(room) + " and " + std::to_string(other) +
             " do not touch, and no wall of at most " + numberText(max_wall_) +
             " m is all that parts them";
    const auto isColumn = [&](const PlanLoop& hole) {
      const double least = max_wall_ * max_wall_; // where walls meet
      return -hole.area() > least ||
             std::any_of(areas.begin(), areas.end(), [&](const PlanLoop& area) {
               return std::abs(area.area() - hole.area()) < touching &&
                      area.distance(hole.elements[0].start) < touching;
             });
    };
    sentence_ = nameOf(*second) + " is joined to " + nameOf(first) + ", " +
                std::to_string(walls) + (walls == 1 ? " wall" : " walls") +
                " between them taken out";
    addDetails(first.ceiling, *second, second->ceiling, second->details, first.details);
    addDetails(first.floor, *second, second->floor, second->floor_details,
               first.floor_details);
    first.niches.insert(first.niches.end(), second->niches.begin(),
                        second->niches.end());
    first.columns.clear();
    for (const PlanLoop& loop : loops)
      if (loop.area() > 0) {
        first.boundary = loop;
        simplify(first.boundary, ends);
      }
      else if (isColumn(loop))
        first.columns.push_back(loop);
    renumber(plan, other, room);
    plan.rooms.erase(plan.rooms.begin() + (second - plan.rooms.data()));
    return {};
  });
}

bool
PlanEditor::split(std::uint32_t room,
                  const Eigen::Vector2d& from,
                  const Eigen::Vector2d& to)
{
  return apply(room, [&](Floorplan& plan, PlanRoom& first) -> std::string {
    const PlanElement line = segment(from, to);
    // Where the line crosses the outline: element, distance along it.
    std::vector<std::pair<std::size_t, double>> cuts;
    for (std::size_t e = 0; e < first.boundary.elements.size(); ++e) {
      const PlanElement& wall = first.boundary.elements[e];
      if (!wall.isArc())
        if (const auto at = crossing(line, wall))
          cuts.emplace_back(e, wall.project(*at));
    }
    if (cuts.size() != 2)
      return "the line crosses " + std::to_string(cuts.size()) +
             " straight walls of room " + std::to_string(room) +
             ", it must cross two: begin and end it outside";
    std::array<PlanLoop, 2> loops;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto [e, s] = cuts[k];
      const auto [last, t] = cuts[1 - k];
      const auto& all = first.boundary.elements;
      auto& part = loops[k].elements;
      part.push_back(all[e].part(s, all[e].length()));
      for (std::size_t i = (e + 1) % all.size(); i != last; i = (i + 1) % all.size())
        part.push_back(all[i]);
      part.push_back(all[last].part(0, t));
      part.push_back(segment(part.back().end, part.front().start));
      setByHand(plan, part.back());
    }
    const bool is_first_left = cross(to - from, loops[0].elements[0].end - from) > 0;
    PlanRoom second = first;
    second.name.clear();
    first.boundary = loops[is_first_left ? 0 : 1];
    second.boundary = loops[is_first_left ? 1 : 0];
    for (const PlanRoom& other : plan.rooms)
      second.id = std::max(second.id, other.id + 1);
    sentence_ = "room " + std::to_string(room) + " is parted: room " +
                std::to_string(second.id) + " is to the right of the line";
    for (PlanRoom* part : {&first, &second}) {
      simplify(part->boundary);
      const auto isElsewhere = [part](const PlanLoop& loop) {
        return std::none_of(loop.elements.begin(), loop.elements.end(),
                            [part](const PlanElement& e) {
                              return part->boundary.distance(e.start) < touching ||
                                     part->boundary.contains(e.start);
                            });
      };
      const auto keepOwn = [&](auto& list) {
        list.erase(std::remove_if(
                       list.begin(), list.end(),
                       [&](const auto& thing) { return isElsewhere(thing.boundary); }),
                   list.end());
      };
      part->columns.erase(
          std::remove_if(part->columns.begin(), part->columns.end(), isElsewhere),
          part->columns.end());
      keepOwn(part->niches);
    }
    const auto isSecond = [&](const Eigen::Vector2d& place) {
      if (first.contains(place) != second.contains(place))
        return second.contains(place);
      return second.boundary.distance(place) < first.boundary.distance(place);
    };
    const std::uint32_t id = second.id;
    forEachReference(plan, [&](std::uint32_t& of, const Eigen::Vector2d& place) {
      of = of == room && isSecond(place) ? id : of;
    });
    for (PlanStorey& storey : plan.storeys)
      if (std::count(storey.rooms.begin(), storey.rooms.end(), room) > 0)
        storey.rooms.push_back(id); // the largest number yet
    plan.rooms.push_back(std::move(second));
    return {};
  });
}

bool
PlanEditor::drop(std::uint32_t room)
{
  return apply(room, [&](Floorplan& plan, PlanRoom& gone) {
    sentence_ = nameOf(gone) + formatText(" of %.2f m2 is removed", gone.area());
    plan.rooms.erase(plan.rooms.begin() + (&gone - plan.rooms.data()));
    renumber(plan, room, 0);
    return std::string();
  });
}

} // namespace pcl::sedr
