// SPDX-License-Identifier: BSD-3-Clause
#include "../base/number_text.h"
#include "../plan/missing_things.h"
#include "../plan/plan_geometry.h"
#include "../walls/plan_walls.h"

#include <pcl/sedr_filters/plan_editor.h>
#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace pcl::sedr {
namespace {

constexpr double exact = 0.01; // metres; openings may reach that far beyond a wall

std::string
sentenceOf(const Floorplan& plan, const PlanOpening& opening)
{
  const std::string leaf = leafOf(opening);
  return std::string(nameOf(opening.kind)) +
         formatText(" of %.3f x %.3f m, %.3f m above the floor", opening.width(),
                    opening.height(), sillOf(plan, opening)) +
         (leaf.empty()
              ? ""
              : ", hinge " + leaf + " into room " + std::to_string(opening.swing));
}

/** @brief Why an opening does not fit its walls in length and in height, and which
 * other one it overlaps; empty texts where nothing is wrong. */
using Misfits = std::array<std::string, 3>;

Misfits
misfitsOf(const Floorplan& plan, const PlanOpening& opening)
{
  Misfits found;
  for (const OpeningWall& in : opening.walls) {
    const PlanRoom& room = *findRoom(plan, in.room);
    const PlanElement& wall = room.boundary.elements[in.element];
    const std::string name =
        "wall " + std::to_string(in.room) + "." + std::to_string(in.element + 1);
    const double middle = wall.project((opening.start + opening.end) / 2);
    const double half = opening.width() / 2;
    if (found[0].empty() &&
        (middle - half < -exact || middle + half > wall.length() + exact))
      found[0] = name + formatText(" is %.3f m long, the opening would reach from %.3f "
                                   "to %.3f m along it",
                                   wall.length(), middle - half, middle + half);
    const Eigen::Vector2d place = wall.pointAt(middle) + exact * wall.normalAt(middle);
    if (found[1].empty() && (opening.bottom < room.floorAt(place) - exact ||
                             opening.top > room.ceilingAt(place) + exact))
      found[1] = name + formatText(" reaches from z %.3f to %.3f m, the opening would "
                                   "from %.3f to %.3f m",
                                   room.floorAt(place), room.ceilingAt(place),
                                   opening.bottom, opening.top);
  }
  for (const PlanOpening& other : plan.openings)
    if (found[2].empty() && &other != &opening &&
        (isAt(other, opening.start, opening.bottom, opening.top) ||
         isAt(other, opening.end, opening.bottom, opening.top) ||
         isAt(opening, (other.start + other.end) / 2, other.bottom, other.top)))
      found[2] = "it would overlap " + markOf(other);
  return found;
}

/** @brief Returns what does not fit but did before, or an empty text. */
std::string
newMisfit(const Floorplan& plan, const PlanOpening& opening, const Misfits& before = {})
{
  const Misfits now = misfitsOf(plan, opening);
  for (std::size_t k = 0; k < now.size(); ++k)
    if (before[k].empty() && !now[k].empty())
      return now[k];
  return {};
}

/** @brief Sets kind and size of an opening; its middle and its sill stay unless they
 * are given.
 * @return why that is not possible, or an empty text */
std::string
change(const Floorplan& plan, const OpeningChange& to, PlanOpening& opening)
{
  const OpeningKind kind = to.kind.value_or(opening.kind);
  opening.number = kind == opening.kind ? opening.number : 0;
  opening.kind = kind;
  const double width = to.width.value_or(opening.width());
  const double height = to.height.value_or(opening.height());
  if (!(std::min(width, height) > no_opening))
    return formatText("an opening is more than %.2f m wide and high, not %g x %g m",
                      no_opening, width, height);
  const Eigen::Vector2d middle = (opening.start + opening.end) / 2;
  const Eigen::Vector2d half = width / 2 * (opening.end - opening.start).normalized();
  opening.start = middle - half;
  opening.end = middle + half;
  opening.bottom += to.sill ? *to.sill - sillOf(plan, opening) : 0;
  opening.top = opening.bottom + height;
  opening.rise = std::min(opening.rise, height);
  opening.confidence = 1;
  opening.is_confirmed = false;
  if (to.width || to.height || to.sill)
    opening.forgetAccuracy();
  if (kind != OpeningKind::Door) {
    opening.hinge = OpeningHinge::Unknown;
    opening.swing = 0;
    opening.state = OpeningState::Unknown;
    return to.leaf || to.swing ? "only doors have leaves" : "";
  }
  const auto& rooms = opening.rooms;
  const std::uint32_t swing = to.swing             ? *to.swing
                              : opening.swing != 0 ? opening.swing
                              : rooms[0] != 0      ? rooms[0]
                                                   : rooms[1];
  if (to.swing && swing != rooms[0] && swing != rooms[1])
    return "room " + std::to_string(swing) + " is on neither side of it";
  if (to.swing && !to.leaf && opening.hinge == OpeningHinge::Unknown)
    return "its hinge must be told: left, right or double";
  if (!to.leaf && !to.swing)
    return {};
  const std::string leaf = to.leaf.value_or("");
  const bool is_first = swing == rooms[0];
  if (leaf == "none")
    opening.hinge = OpeningHinge::Unknown;
  else if (leaf == "double")
    opening.hinge = OpeningHinge::Both;
  else if (leaf == "left" || leaf == "right")
    opening.hinge =
        (leaf == "left") == is_first ? OpeningHinge::Start : OpeningHinge::End;
  else if (to.leaf)
    return "its hinge is left, right, double or none, not '" + leaf + "'";
  opening.swing = opening.hinge == OpeningHinge::Unknown ? 0 : swing;
  return {};
}

} // namespace

bool
PlanEditor::addOpening(std::uint32_t room,
                       std::size_t wall,
                       double at,
                       const OpeningChange& size)
{
  return apply(room, wall, [&](Floorplan& plan, PlanRoom& of, std::size_t w) {
    const PlanElement& face = of.boundary.elements[w];
    PlanOpening opening;
    opening.kind = size.kind.value_or(OpeningKind::Door);
    opening.rooms[0] = room;
    opening.walls = {{room, w}};
    opening.depth = unseen_reveal;
    const Eigen::Vector2d place = face.pointAt(at);
    for (const PlanWall& known : pairFaces(plan, {max_wall_}).walls)
      for (const bool is_face : {true, false}) {
        const WallFace& near = is_face ? known.face : *known.other;
        const WallFace& far = is_face ? *known.other : known.face;
        const double s = elementOf(plan, known.face).project(place);
        if (plan.rooms[near.room].id != room || near.element != w || near.loop != 0 ||
            far.loop != 0 || s < known.stretch.from || s > known.stretch.to)
          continue;
        opening.rooms[1] = plan.rooms[far.room].id;
        opening.walls.resize(1);
        opening.walls.push_back({opening.rooms[1], far.element});
        opening.depth = known.thickness;
      }
    const Eigen::Vector2d inwards = face.normalAt(at);
    const Eigen::Vector2d middle = place - opening.depth / 2 * inwards;
    const Eigen::Vector2d along(inwards.y(), -inwards.x());
    opening.start = middle - along / 2;
    opening.end = middle + along / 2;
    opening.bottom = of.floorAt(place + exact * inwards);
    std::string problem = change(plan, size, opening);
    plan.openings.push_back(opening);
    numberOpenings(plan);
    if (problem.empty())
      problem = newMisfit(plan, plan.openings.back());
    sentence_ = markOf(plan.openings.back()) + " is added to wall " +
                std::to_string(room) + "." + std::to_string(wall) + ": a " +
                sentenceOf(plan, plan.openings.back());
    return problem;
  });
}

bool
PlanEditor::setOpening(const std::string& number, const OpeningChange& to)
{
  return apply([&](Floorplan& plan) -> std::string {
    for (PlanOpening& opening : plan.openings) {
      if (markOf(opening) != number)
        continue;
      const std::string before = sentenceOf(plan, opening);
      const Misfits misfits = misfitsOf(plan, opening);
      const std::string problem = change(plan, to, opening);
      numberOpenings(plan);
      sentence_ = number + " was a " + before + "; " + markOf(opening) + " is a " +
                  sentenceOf(plan, opening);
      return problem.empty() ? newMisfit(plan, opening, misfits) : problem;
    }
    return lacksOpening(plan, number);
  });
}

bool
PlanEditor::confirm(const std::string& number)
{
  const auto confirmIt = [&](auto& thing) -> std::string {
    thing.is_confirmed = true;
    sentence_ = number + " is confirmed";
    return {};
  };
  unsigned room = 0;
  unsigned wall = 0;
  int length = 0;
  if (std::sscanf(number.c_str(), "%9u.%9u%n", &room, &wall, &length) == 2 &&
      static_cast<std::size_t>(length) == number.size())
    return apply(room, wall, [&](Floorplan&, PlanRoom& of, std::size_t w) {
      return confirmIt(of.boundary.elements[w]);
    });
  return apply([&](Floorplan& plan) {
    for (PlanOpening& opening : plan.openings)
      if (markOf(opening) == number)
        return confirmIt(opening);
    return lacksOpening(plan, number) +
           "; only a wall (3.12) or an opening (D3) can be confirmed, unless another "
           "edit removes it";
  });
}

bool
PlanEditor::closeOpening(const std::string& number)
{
  return apply([&](Floorplan& plan) -> std::string {
    const auto closed = std::find_if(
        plan.openings.begin(), plan.openings.end(),
        [&](const PlanOpening& opening) { return markOf(opening) == number; });
    if (closed == plan.openings.end())
      return lacksOpening(plan, number);
    sentence_ = number + ", a " + sentenceOf(plan, *closed) + ", is closed";
    plan.openings.erase(closed);
    return {};
  });
}

} // namespace pcl::sedr
