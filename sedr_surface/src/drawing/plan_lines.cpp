// SPDX-License-Identifier: BSD-3-Clause
#include "plan_lines.h"
#include "../walls/wall_band.h"
#include "text_spot.h"

#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/walls/plan_walls.h"

#include "sedr_filters/src/plan/plan_bounds.h"
#include "sedr_filters/src/plan/plan_segment.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {
namespace {

/** @brief Headrooms drawn below a roof, metres. Area rules such as the former DIN 277
 * count half of what is lower than the first. Building codes require the second over
 * half of a habitable room. */
constexpr double headrooms[] = {1.5, 2.3};

constexpr double on_wall = 0.03; ///< distance of what coincides with a wall, metres

/** @brief Collects the lines of a room. */
class RoomLines {
public:
  RoomLines(const Floorplan& plan, const PlanRoom& room, std::vector<PlanLine>& lines)
      : room_(room)
      , lines_(lines)
  {
    for (const PlanStair& stair : plan.stairs)
      if (stair.rooms[0] == room.id)
        stairs_.push_back(stairwellOf(stair));
  }

  void add(const PlanElement& element, PlanLayer layer, const std::string& note = "")
  {
    if (element.length() > 0)
      lines_.push_back({element, layer, room_.id, note});
  }

  void addLoop(const PlanLoop& loop, PlanLayer layer)
  {
    for (const PlanElement& element : loop.elements)
      add(element, layer);
  }

  /** @brief Adds what of a loop is on no wall and, if asked for, in the room. */
  void addOffWalls(const PlanLoop& loop, PlanLayer layer, bool is_inside)
  {
    for (const PlanElement& element : loop.elements) {
      const auto isFree = [&](double s) {
        const Eigen::Vector2d p = element.pointAt(s);
        return (!is_inside || room_.contains(p)) &&
               room_.boundary.distance(p) > on_wall &&
               std::none_of(
                   room_.columns.begin(), room_.columns.end(),
                   [&](const PlanLoop& c) { return c.distance(p) <= on_wall; });
      };
      forEachPart(element, isFree, [&](const PlanElement& part, bool is_free) {
        if (is_free)
          add(part, layer);
      });
    }
  }

  /** @brief Adds a line of the ceiling, except below a stair, which the plan cuts
   * lower, and what little is left of it beside one. */
  void addOverhead(const PlanElement& element, PlanLayer layer, std::string note)
  {
    constexpr double shortest = 0.6; // metres
    const auto isFree = [&](double s) {
      return std::none_of(stairs_.begin(), stairs_.end(),
                          [p = element.pointAt(s)](const PlanLoop& stair) {
                            return stair.contains(p);
                          });
    };
    forEachPart(element, isFree, [&](const PlanElement& part, bool is_free) {
      if (is_free && part.length() > std::min(shortest, 0.99 * element.length()))
        add(part, layer, std::exchange(note, ""));
    });
  }

  /** @brief Adds the lines of headroom; the longest of each carries its height. */
  void addHeadroom()
  {
    for (const double height : headrooms) {
      const std::vector<PlanElement> found = heightLines(room_, height);
      const auto longest = std::max_element(
          found.begin(), found.end(), [](const PlanElement& a, const PlanElement& b) {
            return a.length() < b.length();
          });
      for (auto line = found.begin(); line != found.end(); ++line)
        addOverhead(*line, PlanLayer::Headroom,
                    line == longest ? "h " + decimalText(height, 2) : "");
    }
  }

  /** @brief Adds the heads of tilted walls. */
  void addHeads()
  {
    const std::vector<PlanElement>& walls = room_.boundary.elements;
    for (std::size_t e = 0; e < walls.size(); ++e) {
      if (walls[e].tilt == 0)
        continue;
      PlanRoom alone = withVerticalWalls(room_); // each has a head of its own
      alone.boundary.elements[e].tilt = walls[e].tilt;
      const PlanLoop head = boundaryAt(room_, headOf(alone));
      add(head.elements[e], PlanLayer::Ceiling,
          "tilt " + decimalText(std::abs(walls[e].tilt) * 180 / M_PI, 1) + "°");
    }
  }

  /** @brief Adds an arrow up each slope of the floor, with its share as note. */
  void addSlopes()
  {
    std::vector<PlanLoop> others = room_.columns;
    for (auto detail = room_.floor_details.rbegin();
         detail != room_.floor_details.rend(); ++detail) { // later ones hold
      std::vector<PlanLoop> off = others;
      off.insert(off.end(), detail->holes.begin(), detail->holes.end());
      addSlope(detail->slab, detail->boundary, off);
      others.push_back(detail->boundary);
    }
    addSlope(room_.floor, room_.boundary, others);
  }

private:
  void addSlope(const PlanSlab& slab,
                const PlanLoop& outline,
                const std::vector<PlanLoop>& others)
  {
    constexpr double least = 0.01; // of a slope
    const auto upAt = [&](const Eigen::Vector2d& p) -> Eigen::Vector2d {
      const Eigen::Vector3d normal = slab.normalAt(p);
      return -normal.head<2>() / normal.z();
    };
    if (!slab.curve && upAt({0, 0}).norm() < least)
      return;
    const TextSpot spot = textSpotIn(outline, others);
    const Eigen::Vector2d up = upAt(spot.place);
    const double reach = std::min(0.8 * spot.radius, 1.0); // metres
    if (up.norm() < least || reach < 0.2 || !room_.contains(spot.place))
      return;
    const Eigen::Vector2d half = reach * up.normalized();
    add(segment(spot.place - half, spot.place + half), PlanLayer::Floor,
        shortDecimalText(100 * up.norm(), 1) + " %");
    for (const PlanElement& side : arrowHead(spot.place - half, spot.place + half))
      add(side, PlanLayer::Floor);
  }

  const PlanRoom& room_;
  std::vector<PlanLine>& lines_;
  std::vector<PlanLoop> stairs_; ///< that lead up from it
};

/** @brief Adds the far sides of walls with one seen face, without what runs within
 * another wall or a room. */
void
addFarSides(const Floorplan& plan,
            const std::vector<PlanWall>& walls,
            std::vector<PlanLine>& lines)
{
  constexpr double beyond = 0.001; // metres
  std::vector<PlanLoop> covers;
  for (const PlanRoom& room : plan.rooms)
    covers.push_back(room.boundary);
  for (const PlanWall& wall : walls)
    covers.push_back(bandOf(plan, wall).boundary);
  std::vector<Eigen::AlignedBox2d> boxes;
  for (const PlanLoop& cover : covers)
    boxes.push_back(boundsOf(cover));
  for (const PlanWall& wall : walls) {
    if (wall.other)
      continue;
    const PlanElement far = farSideOf(plan, wall);
    const auto isFree = [&](double s) {
      const Eigen::Vector2d p = far.pointAt(s) - beyond * far.normalAt(s);
      for (std::size_t k = 0; k < covers.size(); ++k)
        if (boxes[k].contains(p) && covers[k].contains(p))
          return false;
      return true;
    };
    const PlanLayer layer = wall.isAssumed() || isGuess(plan, wall.face)
                                ? PlanLayer::Guess
                                : PlanLayer::Outside;
    forEachPart(far, isFree, [&](const PlanElement& part, bool is_free) {
      if (is_free)
        lines.push_back({part, layer});
    });
  }
}

} // namespace

std::vector<CeilingLines>
ceilingsOf(const Floorplan& plan, double finest)
{
  std::vector<CeilingLines> lines;
  for (const PlanRoom& room : plan.rooms)
    lines.push_back(ceilingLines(room, finest));
  return lines;
}

std::vector<PlanLine>
planLines(const Floorplan& plan,
          const std::vector<PlanWall>& walls,
          const std::vector<CeilingLines>& ceilings)
{
  std::vector<PlanLine> all;
  addFarSides(plan, walls, all);
  for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
    const PlanRoom& room = plan.rooms[r];
    RoomLines lines(plan, room, all);
    for (std::size_t e = 0; e < room.boundary.elements.size(); ++e)
      lines.add(room.boundary.elements[e], wallShares(plan, room, e).isGuess()
                                               ? PlanLayer::Guess
                                               : PlanLayer::Wall);
    for (const PlanLoop& column : room.columns)
      lines.addLoop(column,
                    isIsland(room, column) ? PlanLayer::Wall : PlanLayer::Column);
    for (const CeilingLine& line : ceilings[r].lines)
      lines.addOverhead(line.element,
                        line.is_crease ? PlanLayer::Ridge : PlanLayer::Ceiling,
                        line.text);
    for (const PlanDetail& detail : room.floor_details) {
      lines.addOffWalls(detail.boundary, PlanLayer::Floor, true);
      for (const PlanLoop& hole : detail.holes)
        lines.addOffWalls(hole, PlanLayer::Floor, true);
    }
    for (const PlanNiche& niche : room.niches)
      lines.addOffWalls(niche.boundary, PlanLayer::Niche, false);
    lines.addSlopes();
    lines.addHeadroom();
    lines.addHeads();
  }
  addStairs(plan, all);
  return all;
}

namespace {

/** @brief Returns the thickness of the wall of an opening that leads outside; the depth
 * of others. */
double
depthOf(const Floorplan& plan,
        const std::vector<PlanWall>& walls,
        const PlanOpening& opening)
{
  if (!opening.leadsOutside())
    return opening.depth;
  const Eigen::Vector2d middle = (opening.start + opening.end) / 2;
  for (const PlanWall& wall : walls)
    for (const OpeningWall& in : opening.walls) {
      const double s = elementOf(plan, wall.face).project(middle);
      if (!wall.other && wall.face.loop == 0 && wall.face.element == in.element &&
          plan.rooms[wall.face.room].id == in.room && s >= wall.stretch.from &&
          s <= wall.stretch.to)
        return wall.thickness;
    }
  return opening.depth;
}

/** @brief Returns the gap of an opening, from the face that was seen on. */
OpeningGap
gapOf(const Floorplan& plan, const PlanOpening& opening, double depth)
{
  const Eigen::Vector2d way = (opening.end - opening.start) / opening.width();
  const Eigen::Vector2d left(-way.y(), way.x());
  const double beyond = depth - opening.depth / 2; // from the middle of the wall
  const Eigen::Vector2d to_left =
      (opening.rooms[0] == 0 ? beyond : opening.depth / 2) * left;
  const Eigen::Vector2d to_right =
      (opening.rooms[0] == 0 ? opening.depth / 2 : beyond) * left;
  OpeningGap gap;
  gap.corners = {opening.start + to_left, opening.end + to_left, opening.end - to_right,
                 opening.start - to_right};
  gap.mark = markOf(opening);
  gap.width = opening.width();
  gap.height = opening.height();
  gap.kind = opening.kind;
  gap.sill = sillOf(plan, opening);
  for (const OpeningLeaf& door : leavesOf(opening)) {
    PlanElement swing = segment(door.open, door.shut);
    swing.centre = door.hinge;
    swing.radius = (door.open - door.hinge).norm();
    const Eigen::Vector2d to_shut = door.shut - door.hinge;
    const Eigen::Vector2d to_open = door.open - door.hinge;
    swing.counter_clockwise = to_open.x() * to_shut.y() > to_open.y() * to_shut.x();
    gap.leaf.insert(gap.leaf.end(), {segment(door.hinge, door.open), swing});
  }
  return gap;
}

} // namespace

std::vector<PlanElement>
fillingOf(const OpeningGap& gap)
{
  std::vector<double> shares; // of the depth of the wall
  if (gap.kind == OpeningKind::Window)
    shares = {0.4, 0.6};
  if (gap.kind == OpeningKind::Door && gap.leaf.empty())
    shares = {0.5};
  std::vector<PlanElement> lines;
  for (const double share : shares)
    lines.push_back(
        segment(gap.corners[0] + share * (gap.corners[3] - gap.corners[0]),
                gap.corners[1] + share * (gap.corners[2] - gap.corners[1])));
  return lines;
}

std::vector<PlanElement>
linesOf(const OpeningGap& gap)
{
  const auto& c = gap.corners;
  std::vector<PlanElement> lines{segment(c[0], c[3]), segment(c[1], c[2])};
  if (gap.kind == OpeningKind::Window) // both faces go on below it
    lines.insert(lines.end(), {segment(c[0], c[1]), segment(c[3], c[2])});
  const std::vector<PlanElement> filling = fillingOf(gap);
  lines.insert(lines.end(), filling.begin(), filling.end());
  lines.insert(lines.end(), gap.leaf.begin(), gap.leaf.end());
  return lines;
}

namespace {

/** @brief Returns the distance of a place from the line or circle of an element. */
double
offLine(const PlanElement& e, const Eigen::Vector2d& p)
{
  return e.isArc()
             ? std::abs((p - e.centre).norm() - e.radius)
             : Eigen::Hyperplane<double, 2>::Through(e.start, e.end).absDistance(p);
}

} // namespace

std::vector<PlanElement>
cutAtGaps(const PlanElement& element, const std::vector<OpeningGap>& gaps)
{
  constexpr double on_face = 0.05; // metres between an arc and the end of its opening
  constexpr double shortest = 1e-4;
  if (element.length() < shortest)
    return {element};
  std::vector<std::pair<double, double>> cuts;
  for (const OpeningGap& gap : gaps)
    for (const auto& [a, b] : {std::pair(0, 1), std::pair(3, 2)})
      if (offLine(element, gap.corners[a]) < on_face &&
          offLine(element, gap.corners[b]) < on_face)
        cuts.push_back(std::minmax(
            {element.project(gap.corners[a]), element.project(gap.corners[b])}));
  std::sort(cuts.begin(), cuts.end());
  cuts.emplace_back(element.length(), element.length());
  std::vector<PlanElement> parts;
  double from = 0;
  for (const auto& [start, end] : cuts) {
    if (start - from > shortest)
      parts.push_back(
          from == 0 && start == element.length() ? element : element.part(from, start));
    from = std::max(from, end);
  }
  return parts;
}

std::vector<OpeningGap>
openingGaps(const Floorplan& plan, const std::vector<PlanWall>& walls)
{
  std::vector<OpeningGap> gaps;
  for (const PlanOpening& opening : plan.openings)
    gaps.push_back(gapOf(plan, opening, depthOf(plan, walls, opening)));
  return gaps;
}

} // namespace pcl::sedr
