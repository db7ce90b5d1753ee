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
#include <functional>
#include <initializer_list>
#include <memory>
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

namespace {

/** @brief Raises a slab by hand. */
void
lift(PlanSlab& slab, double by)
{
  slab.plane[3] -= by * slab.plane[2];
  if (slab.curve)
    slab.curve = std::make_shared<const SlabCurve>(moved(*slab.curve, 0, {0, 0, by}));
  setByHand(slab);
}

/** @brief Raises a floor or ceiling with its slopes. */
void
lift(PlanSlab& slab, std::vector<PlanDetail>& details, double by)
{
  lift(slab, by);
  for (PlanDetail& detail : details)
    if (detail.is_facet)
      lift(detail.slab, by);
}

constexpr const char* no_rise = "a stair would lead nowhere";

/** @brief Raises the ends of stairs that stand on floors that were raised.
 * @param is_moved tells it of a room and a height of its floor
 * @return false if one would then not rise */
bool
moveStairs(Floorplan& plan,
           const std::function<bool(std::uint32_t, double)>& is_moved,
           double by)
{
  for (PlanStair& stair : plan.stairs) {
    const double low = stair.bottom;
    const double old_rise = stair.top - low;
    stair.bottom += is_moved(stair.rooms[0], stair.bottom) ? by : 0;
    stair.top += is_moved(stair.rooms[1], stair.top) ? by : 0;
    const double stretch = (stair.top - stair.bottom) / old_rise;
    if (!(stretch > 0))
      return false;
    for (PlanFlight& flight : stair.flights) {
      flight.bottom = stair.bottom + stretch * (flight.bottom - low);
      flight.rise *= stretch;
    }
  }
  return true;
}

/** @brief Returns where a ceiling would then lie lower below the floor than before, or
 * an empty text. */
std::string
crossingProblem(const PlanRoom& before, const PlanRoom& room)
{
  const ClearHeight clear = clearHeight(room);
  if (clear.least > 0 || clear.least >= clearHeight(before).least)
    return {};
  return formatText("its ceiling would then be %.3f m below its floor at (%.2f, %.2f)",
                    -clear.least, clear.lowest.x(), clear.lowest.y());
}

/** @brief Forgets how well an opening is known, but for its other edges. */
void
forgetEdges(PlanOpening& opening, std::initializer_list<std::size_t> edges)
{
  const auto before = opening.edges;
  opening.forgetAccuracy();
  opening.edges = before;
  for (const std::size_t k : edges)
    opening.edges[k] = {};
}

/** @brief Returns a sentence, "the floor of room 3 is at z 0.100 m, it was at 0.000".
 */
std::string
raisedText(const char* what, std::uint32_t number, double before, double by)
{
  return what + std::to_string(number) +
         formatText(" is at z %.3f m, it was at %.3f", before + by, before);
}

} // namespace

bool
PlanEditor::setFloor(std::uint32_t room, double z)
{
  return apply(room, [&](Floorplan& plan, PlanRoom& of) -> std::string {
    const RoomHeights heights = heightsOf(of);
    if (!(z < heights.high))
      return formatText("its ceiling is at z %.3f m", heights.high);
    constexpr double on_floor = 0.05; // metres
    for (PlanOpening& opening : plan.openings)
      if (std::count(opening.rooms.begin(), opening.rooms.end(), room) > 0 &&
          std::abs(opening.bottom - heights.low) < on_floor) {
        opening.bottom = z;
        forgetEdges(opening, {2});
      }
    const auto isOnIt = [&](std::uint32_t id, double foot) {
      return id == room && std::abs(foot - heights.low) < on_floor;
    };
    if (!moveStairs(plan, isOnIt, z - heights.low))
      return no_rise;
    lift(of.floor, of.floor_details, z - heights.low);
    sentence_ = raisedText("the floor of room ", room, heights.low, z - heights.low);
    return crossingProblem(*findRoom(plan_, room), of);
  });
}

bool
PlanEditor::setCeiling(std::uint32_t room, double z)
{
  return apply(room, [&](Floorplan&, PlanRoom& of) -> std::string {
    const RoomHeights heights = heightsOf(of);
    if (!(z > heights.low))
      return formatText("its floor is at z %.3f m", heights.low);
    lift(of.ceiling, of.details, z - heights.high);
    sentence_ =
        raisedText("the ceiling of room ", room, heights.high, z - heights.high);
    return crossingProblem(*findRoom(plan_, room), of);
  });
}

bool
PlanEditor::setStorey(std::uint32_t number, double z)
{
  return apply([&](Floorplan& plan) -> std::string {
    const std::vector<PlanStorey> storeys = storeysOf(plan);
    const PlanStorey* const storey = findStorey(storeys, number);
    if (!storey)
      return lacksStorey(storeys, number);
    const double floor = usualFloor(plan, *storey);
    const double by = z - floor;
    const auto isOf = [&](std::uint32_t room) {
      return std::count(storey->rooms.begin(), storey->rooms.end(), room) > 0;
    };
    for (PlanRoom& room : plan.rooms) {
      if (!isOf(room.id))
        continue;
      for (PlanSlab* const slab : {&room.floor, &room.ceiling})
        lift(*slab, by);
      for (auto* const details : {&room.floor_details, &room.details})
        for (PlanDetail& detail : *details)
          lift(detail.slab, by);
      for (PlanNiche& niche : room.niches)
        for (PlanSlab* const slab : {&niche.bottom, &niche.top})
          lift(*slab, by);
    }
    for (PlanOpening& opening : plan.openings)
      if (isOf(opening.rooms[opening.rooms[0] == 0 ? 1 : 0])) {
        opening.bottom += by;
        opening.top += by;
        forgetEdges(opening, {2, 3});
      }
    if (!moveStairs(
            plan, [&](auto room, double) { return isOf(room); }, by))
      return no_rise;
    sentence_ = raisedText("the usual floor of storey ", number, floor, by);
    return {};
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
