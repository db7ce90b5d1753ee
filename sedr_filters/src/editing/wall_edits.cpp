// SPDX-License-Identifier: BSD-3-Clause
#include "../base/number_text.h"
#include "../plan/missing_things.h"
#include "plan_edits.h"

#include <pcl/sedr_filters/plan_editor.h>
#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <type_traits>
#include <vector>

namespace pcl::sedr {
namespace {

constexpr double nearly = 10 * M_PI / 180; // square or parallel, radians

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

/** @brief Returns the angle of a line against an axis, radians. */
double
angleTo(const PlanElement& axis, const PlanElement& line)
{
  const Eigen::Vector2d a = axis.end - axis.start;
  const Eigen::Vector2d b = line.end - line.start;
  return std::atan2(cross(a, b), a.dot(b));
}

/** @brief How a wall moves: it turns about its middle, then shifts outwards. */
struct WallMotion {
  double turn = 0;     ///< radians
  double distance = 0; ///< metres

  bool isNone() const { return turn == 0 && distance == 0; }
  Eigen::Affine2d of(const PlanElement& wall, double share = 1) const
  {
    const Eigen::Vector2d middle = (wall.start + wall.end) / 2;
    const Eigen::Vector2d off = -share * distance * wall.normalAt(0);
    return Eigen::Translation2d(middle + off) * Eigen::Rotation2Dd(share * turn) *
           Eigen::Translation2d(-middle);
  }
};

/** @brief Moves walls of a room, with what is in them: doors to other rooms by half.
 * @param motions one a wall
 * @return why that is not possible, or an empty text */
std::string
moveWalls(Floorplan& plan, PlanRoom& room, const std::vector<WallMotion>& motions)
{
  std::vector<PlanElement> lines = room.boundary.elements;
  for (PlanNiche& niche : room.niches) {
    const std::size_t wall = wallOf(room, niche);
    for (PlanElement& side : niche.boundary.elements)
      move(side, motions[wall].of(lines[wall]));
  }
  for (PlanOpening& opening : plan.openings)
    for (const OpeningWall& in : opening.walls) {
      if (in.room != room.id)
        continue;
      const WallMotion& motion = motions[in.element];
      if (motion.isNone())
        continue;
      const bool has_other = opening.walls.size() > 1; // it stays
      const Eigen::Affine2d to = motion.of(lines[in.element], has_other ? 0.5 : 1);
      opening.start = to * opening.start;
      opening.end = to * opening.end;
      opening.is_confirmed = false;
      opening.depth = std::max(opening.depth - (has_other ? motion.distance : 0), 0.0);
    }
  for (std::size_t w = 0; w < lines.size(); ++w) {
    const WallMotion& motion = motions[w];
    const double off =
        std::abs(motion.distance) + std::abs(motion.turn) * lines[w].length() / 2;
    if (off > std::max(touching, motion.turn == 0 ? 0 : lines[w].residual))
      setByHand(plan, lines[w]);
    if (!motion.isNone())
      move(lines[w], motion.of(lines[w]));
  }
  return meetAgain(lines, room.boundary);
}

std::string
moveOne(Floorplan& plan, PlanRoom& room, std::size_t wall, const WallMotion& motion)
{
  std::vector<WallMotion> motions(room.boundary.elements.size());
  motions[wall] = motion;
  return moveWalls(plan, room, motions);
}

std::string
wallName(const PlanRoom& room, std::size_t wall)
{
  return "wall " + std::to_string(room.id) + "." + std::to_string(wall + 1);
}

std::string
movedText(const PlanRoom& room, std::size_t wall, double distance)
{
  return wallName(room, wall) + " is moved " + (distance < 0 ? "inwards" : "outwards") +
         formatText(" by %.3f m", std::abs(distance));
}

} // namespace

bool
PlanEditor::square(std::uint32_t room)
{
  return apply(room, [&](Floorplan& plan, PlanRoom& changed) -> std::string {
    const std::vector<PlanElement>& lines = changed.boundary.elements;
    const auto longest = std::max_element(
        lines.begin(), lines.end(), [](const PlanElement& a, const PlanElement& b) {
          return (a.isArc() ? 0 : a.length()) < (b.isArc() ? 0 : b.length());
        });
    if (longest->isArc())
      return "room " + std::to_string(room) + " has no straight wall";
    std::vector<WallMotion> motions(lines.size());
    std::size_t turned = 0;
    double most = 0;
    for (std::size_t w = 0; w < lines.size(); ++w) {
      const double off = std::remainder(angleTo(*longest, lines[w]), M_PI / 2);
      if (lines[w].isArc() || std::abs(off) > nearly)
        continue;
      motions[w].turn = -off;
      most = std::max(most, std::abs(off));
      turned += std::abs(off) * lines[w].length() > touching ? 1 : 0;
    }
    sentence_ = std::to_string(turned) + (turned == 1 ? " wall" : " walls") +
                " of room " + std::to_string(room) +
                formatText(" turned by up to %.2f degrees", most * 180 / M_PI);
    return moveWalls(plan, changed, motions);
  });
}

bool
PlanEditor::moveWall(std::uint32_t room, std::size_t wall, double distance)
{
  return apply(room, wall, [&](Floorplan& plan, PlanRoom& of, std::size_t w) {
    if (!std::isfinite(distance))
      return wallName(of, w) + " cannot be moved by " + numberText(distance) + " m";
    if (of.boundary.elements[w].isArc())
      return wallName(of, w) + " is an arc, only straight walls can be moved";
    sentence_ = movedText(of, w, distance);
    return moveOne(plan, of, w, {0, distance});
  });
}

bool
PlanEditor::removeJog(std::uint32_t room, std::size_t wall)
{
  return apply(room, wall, [&](Floorplan& plan, PlanRoom& of, std::size_t w) {
    const std::vector<PlanElement>& walls = of.boundary.elements;
    const auto beside = [&](std::size_t steps) {
      return (w + walls.size() + steps) % walls.size();
    };
    const auto longer = [&](std::size_t a, std::size_t b) {
      return walls[a].length() < walls[b].length() ? b : a;
    };
    const auto isParallel = [&](std::size_t a, std::size_t b) {
      return !walls[a].isArc() && !walls[b].isArc() &&
             std::abs(angleTo(walls[a], walls[b])) < nearly;
    };
    const std::size_t before = beside(walls.size() - 1);
    const std::size_t after = beside(1);
    std::size_t moved = w; // the end of a notch
    std::size_t line = longer(beside(walls.size() - 2), beside(2));
    if (isParallel(before, after)) {
      line = longer(before, after);
      moved = before + after - line;
    }
    else if (walls.size() < 8 || !isParallel(beside(walls.size() - 2), beside(2)) ||
             !isParallel(line, w))
      return wallName(of, w) + " is neither between two parallel walls nor the end of "
                               "a notch or bay";
    Eigen::Vector2d way;
    const PlanElement& onto = walls[line];
    const Eigen::Vector2d middle = walls[moved].pointAt(walls[moved].length() / 2);
    const double turn = -angleTo(onto, walls[moved]);
    const double distance = offLine(onto, middle, way) / std::cos(turn);
    if (std::abs(distance) > max_wall_)
      return wallName(of, w) + " is no jog: " + wallName(of, moved) +
             formatText(" would move by %.3f m, more than a wall is thick, %.3f m",
                        std::abs(distance), max_wall_);
    sentence_ =
        movedText(of, moved, distance) + " into the line of " + wallName(of, line);
    return moveOne(plan, of, moved, {turn, distance});
  });
}

bool
PlanEditor::remove(const std::string& part)
{
  unsigned room = 0;
  std::sscanf(part.c_str(), "room_%9u_", &room);
  return apply(room, [&](Floorplan&, PlanRoom& of) {
    std::string problem = "room " + std::to_string(room) + " has ";
    const auto removeFrom = [&](auto& parts, const std::string& kind) {
      problem += std::to_string(parts.size()) + " " + kind + "s";
      for (std::size_t k = 0; k < parts.size(); ++k)
        if (part ==
            "room_" + std::to_string(room) + "_" + kind + "_" + std::to_string(k + 1)) {
          const auto gone = parts[k];
          parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(k));
          if constexpr (std::is_same_v<decltype(gone), const PlanDetail>)
            if (gone.is_facet)
              cover(gone.boundary, {of.boundary}, of, kind == "floor_detail");
          sentence_ = part + " is removed";
          return;
        }
    };
    removeFrom(of.columns, "column");
    problem += ", ";
    removeFrom(of.floor_details, "floor_detail");
    problem += ", ";
    removeFrom(of.details, "detail");
    problem += " and ";
    removeFrom(of.niches, "niche");
    return sentence_.empty() ? problem : "";
  });
}

} // namespace pcl::sedr
