// SPDX-License-Identifier: BSD-3-Clause
#include "../base/number_text.h"
#include "plan_outlines.h"
#include "room_references.h"

#include <pcl/sedr_filters/plan_editor.h>
#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_filters/priors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pcl::sedr {
namespace {

/** @brief What was set by hand was not measured: it counts as inferred in a plan that
 * tells what was of any of its walls. */
void
setByHand(const Floorplan& plan, PlanElement& wall)
{
  const auto isKnown = [](const PlanElement& e) { return e.evidence.isKnown(); };
  const bool is_measured =
      std::any_of(plan.rooms.begin(), plan.rooms.end(), [&](const PlanRoom& room) {
        const std::vector<PlanElement>& walls = room.boundary.elements;
        return std::any_of(walls.begin(), walls.end(), isKnown);
      });
  wall.inliers = 0;
  wall.residual = 0;
  wall.evidence = {0, is_measured ? 1.0 : 0.0, 0};
}

/** @brief A stretch of a straight wall between two rooms. */
struct SharedWall {
  std::size_t element = 0; ///< of the first room
  std::size_t other = 0;   ///< of the second room
  double from = 0;         ///< along the first, metres
  double to = 0;           ///< along the first, metres
};

/** @brief Returns the longest stretch at which two rooms face each other through a wall
 * as thick as walls may be; of no length if there is none. */
SharedWall
longestWall(const PlanRoom& room, const PlanRoom& other)
{
  const double thickest = Priors().max_wall;
  constexpr double parallel = 0.0872; // sine of 5 degrees
  SharedWall best;
  for (std::size_t a = 0; a < room.boundary.elements.size(); ++a)
    for (std::size_t b = 0; b < other.boundary.elements.size(); ++b) {
      const PlanElement& near = room.boundary.elements[a];
      const PlanElement& far = other.boundary.elements[b];
      if (near.isArc() || far.isArc())
        continue;
      const Eigen::Vector2d way = (near.end - near.start).normalized();
      const Eigen::Vector2d back = (far.end - far.start).normalized();
      const double off = cross(far.pointAt(far.length() / 2) - near.start, way);
      if (way.dot(back) > 0 || std::abs(cross(way, back)) > parallel ||
          off < -touching || off > thickest)
        continue;
      const double from = std::max(0.0, (far.end - near.start).dot(way));
      const double to = std::min(near.length(), (far.start - near.start).dot(way));
      if (to - from > best.to - best.from)
        best = {a, b, from, to};
    }
  return best;
}

/** @brief Appends the elements from place `s` of element `k` around the loop to place
 * `t` of it. */
void
appendAround(const PlanLoop& loop,
             std::size_t k,
             double s,
             double t,
             std::vector<PlanElement>& elements)
{
  const std::vector<PlanElement>& all = loop.elements;
  elements.push_back(all[k].part(s, all[k].length()));
  for (std::size_t i = 1; i < all.size(); ++i)
    elements.push_back(all[(k + i) % all.size()]);
  elements.push_back(all[k].part(0, t));
}

/** @brief Shifts and turns an element. */
void
move(PlanElement& element, const Eigen::Affine2d& to)
{
  for (Eigen::Vector2d* place : {&element.start, &element.end, &element.centre})
    *place = to * *place;
}

/** @brief Returns the wall that a niche is in: the one nearest to its open side. */
std::size_t
wallOf(const PlanRoom& room, const PlanNiche& niche)
{
  const auto middle = [](const PlanElement& e) { return e.pointAt(e.length() / 2); };
  const auto& sides = niche.boundary.elements;
  const auto open = std::min_element(
      sides.begin(), sides.end(), [&](const PlanElement& a, const PlanElement& b) {
        return room.boundary.distance(middle(a)) < room.boundary.distance(middle(b));
      });
  return room.boundary.nearest(middle(*open));
}

} // namespace

bool
PlanEditor::apply(std::uint32_t room,
                  const std::function<std::string(Floorplan&, PlanRoom&)>& change)
{
  Floorplan changed = plan_;
  warnings_.clear();
  PlanRoom* const found = findRoom(changed, room);
  problem_ =
      found ? change(changed, *found) : "the plan has no room " + std::to_string(room);
  for (const PlanRoom& r : changed.rooms)
    if (const PlanRoom* const before = findRoom(plan_, r.id); problem_.empty())
      if (const std::string wrong = outlineProblem(r.boundary);
          !wrong.empty() && (!before || outlineProblem(before->boundary).empty()))
        problem_ = "the outline of room " + std::to_string(r.id) + " then " + wrong;
  if (!problem_.empty())
    return false;
  warnings_ = attachOpenings(plan_, changed);
  for (std::string& flight : flightsThroughWalls(plan_, changed))
    warnings_.push_back(std::move(flight));
  plan_ = std::move(changed);
  return true;
}

bool
PlanEditor::name(std::uint32_t room, const std::string& text)
{
  return apply(room, [&](Floorplan&, PlanRoom& named) {
    named.name = text;
    return std::string();
  });
}

bool
PlanEditor::merge(std::uint32_t room, std::uint32_t other)
{
  return apply(room, [&](Floorplan& plan, PlanRoom& first) -> std::string {
    PlanRoom* const second = findRoom(plan, other);
    if (!second || room == other)
      return "the plan has no other room " + std::to_string(other);
    if (!shareHeights(first, *second)) {
      const auto range = [](const PlanRoom& r) {
        const RoomHeights heights = heightsOf(r);
        return "room " + std::to_string(r.id) + " from z " +
               numberText(std::round(heights.low * 100) / 100) + " to " +
               numberText(std::round(heights.high * 100) / 100) + " m";
      };
      return "they lie at different heights: " + range(first) + ", " + range(*second);
    }
    const SharedWall shared = longestWall(first, *second);
    if (!(shared.to > shared.from))
      return "rooms " + std::to_string(room) + " and " + std::to_string(other) +
             " have no straight wall between them";
    const PlanElement& near = first.boundary.elements[shared.element];
    const PlanElement& far = second->boundary.elements[shared.other];
    // What is left of a wall is no shorter than walls are exact.
    const auto endOrPlace = [](const PlanElement& wall, double s) {
      constexpr double least = 0.02; // metres
      return s < least ? 0 : s > wall.length() - least ? wall.length() : s;
    };
    const double back = endOrPlace(far, far.project(near.pointAt(shared.to)));
    const double there = endOrPlace(far, far.project(near.pointAt(shared.from)));
    const double from = endOrPlace(near, shared.from);
    const double to = endOrPlace(near, shared.to);
    // Around the first room, through the wall, around the second one, and back.
    std::vector<PlanElement> loop;
    appendAround(first.boundary, shared.element, to, from, loop);
    loop.push_back(segment(near.pointAt(from), far.pointAt(there)));
    setByHand(plan, loop.back());
    appendAround(second->boundary, shared.other, there, back, loop);
    loop.push_back(segment(far.pointAt(back), near.pointAt(to)));
    setByHand(plan, loop.back());
    first.boundary.elements = std::move(loop);
    simplify(first.boundary);
    const auto append = [](auto& to, const auto& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    append(first.columns, second->columns);
    append(first.details, second->details);
    append(first.floor_details, second->floor_details);
    append(first.niches, second->niches);
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
    plan.rooms.erase(plan.rooms.begin() + (&gone - plan.rooms.data()));
    renumber(plan, room, 0);
    return std::string();
  });
}

bool
PlanEditor::square(std::uint32_t room)
{
  return apply(room, [&](Floorplan& plan, PlanRoom& changed) -> std::string {
    constexpr double most = 10 * M_PI / 180;
    std::vector<PlanElement> lines = changed.boundary.elements;
    const auto longest = std::max_element(
        lines.begin(), lines.end(), [](const PlanElement& a, const PlanElement& b) {
          return (a.isArc() ? 0 : a.length()) < (b.isArc() ? 0 : b.length());
        });
    if (longest->isArc())
      return "room " + std::to_string(room) + " has no straight wall";
    const auto angleOf = [](const PlanElement& e) {
      return std::atan2(e.end.y() - e.start.y(), e.end.x() - e.start.x());
    };
    const double axis = angleOf(*longest);
    std::vector<std::size_t> walls; // that the niches are in
    for (const PlanNiche& niche : changed.niches)
      walls.push_back(wallOf(changed, niche));
    for (std::size_t w = 0; w < lines.size(); ++w) {
      PlanElement& line = lines[w];
      const double off = std::remainder(angleOf(line) - axis, M_PI / 2);
      if (line.isArc() || std::abs(off) > most)
        continue;
      if (std::abs(off) * line.length() / 2 > std::max(touching, line.residual))
        setByHand(plan, line);
      const Eigen::Vector2d middle = (line.start + line.end) / 2;
      const auto turnBy = [&](double angle) {
        return Eigen::Affine2d(Eigen::Translation2d(middle) *
                               Eigen::Rotation2Dd(angle) *
                               Eigen::Translation2d(-middle));
      };
      const Eigen::Affine2d turn = turnBy(-off);
      move(line, turn);
      for (std::size_t n = 0; n < walls.size(); ++n)
        for (PlanElement& side : changed.niches[n].boundary.elements)
          if (walls[n] == w)
            move(side, turn);
      for (PlanOpening& opening : plan.openings)
        for (const OpeningWall& in : opening.walls)
          if (in.room == room && in.element == w) {
            const bool has_other = opening.walls.size() > 1; // it stays
            const Eigen::Affine2d turned = has_other ? turnBy(-off / 2) : turn;
            opening.start = turned * opening.start;
            opening.end = turned * opening.end;
          }
    }
    const PlanLoop before = changed.boundary;
    const std::string problem = meetAgain(lines, changed.boundary);
    return problem.empty() ? overlapProblem(plan, before, changed) : problem;
  });
}

bool
PlanEditor::moveWall(std::uint32_t room, std::size_t wall, double distance)
{
  return apply(room, [&](Floorplan& plan, PlanRoom& changed) -> std::string {
    std::vector<PlanElement> lines = changed.boundary.elements;
    const std::string name = std::to_string(room) + "." + std::to_string(wall);
    if (wall < 1 || wall > lines.size())
      return "there is no wall " + name + ": room " + std::to_string(room) + " has " +
             std::to_string(lines.size());
    PlanElement& line = lines[wall - 1];
    if (!std::isfinite(distance))
      return "wall " + name + " cannot be moved by " + numberText(distance) + " m";
    if (line.isArc())
      return "wall " + name + " is an arc, only straight walls can be moved";
    const Eigen::Vector2d off = -distance * line.normalAt(0);
    const Eigen::Affine2d away(Eigen::Translation2d{off});
    move(line, away);
    setByHand(plan, line);
    for (PlanOpening& opening : plan.openings)
      for (const OpeningWall& in : opening.walls)
        if (in.room == room && in.element + 1 == wall) {
          const bool has_other = opening.walls.size() > 1; // it stays
          opening.start += has_other ? off / 2 : off;
          opening.end += has_other ? off / 2 : off;
          opening.depth = std::max(opening.depth - (has_other ? distance : 0), 0.0);
        }
    for (PlanNiche& niche : changed.niches)
      if (wallOf(changed, niche) + 1 == wall)
        for (PlanElement& side : niche.boundary.elements)
          move(side, away);
    const PlanLoop before = changed.boundary;
    const std::string problem = meetAgain(lines, changed.boundary);
    return problem.empty() ? overlapProblem(plan, before, changed) : problem;
  });
}

} // namespace pcl::sedr
