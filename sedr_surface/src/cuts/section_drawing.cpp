// SPDX-License-Identifier: BSD-3-Clause
#include "../drawing/plan_drawing.h"
#include "../sheet/text_places.h"
#include "../walls/wall_band.h"
#include "cut_drawing.h"
#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/plan/plan_geometry.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/floorplan_extrusion.h>

#include <algorithm>
#include <utility>

namespace pcl::sedr {
namespace {

constexpr double assumed_slab = 0.2; ///< thickness where one side was seen, metres
constexpr double max_slab = 1;       ///< more between two rooms is no slab

/** @brief A room's solid, and where it is cut. */
struct CutRoom {
  const PlanRoom* room = nullptr;
  std::vector<PlanLoop> loops;
};

PlanLoop
shifted(PlanLoop loop, double up)
{
  for (PlanElement& e : loop.elements)
    for (Eigen::Vector2d* p : {&e.start, &e.end})
      p->y() += up;
  return loop;
}

/** @brief Adds all that lies between a loop and those above it. */
void
addSlabs(const PlanLoop& loop,
         const std::vector<CutRoom>& rooms,
         std::vector<PlanArea>& bodies)
{
  const Eigen::AlignedBox2d box = boundsOf(loop);
  for (const CutRoom& other : rooms)
    for (const PlanLoop& o : other.loops) {
      const Eigen::AlignedBox2d b = boundsOf(o);
      const double from = std::max(b.min().x(), box.min().x());
      const double to = std::min(b.max().x(), box.max().x());
      const double top = b.min().y();
      if (from < to && top > box.max().y() && top < box.max().y() + max_slab)
        bodies.push_back(
            {rectangleOf(from, to, std::max(box.min().y(), top - max_slab), top)});
    }
}

/** @brief Adds what hangs down into a cut room, such as a beam, and the slab above it,
 * as high as on both sides. */
void
addBeams(const PlanLoop& loop, std::vector<PlanArea>& bodies)
{
  const std::vector<PlanElement>& all = loop.elements;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const PlanElement& down = all[(k + all.size() - 1) % all.size()];
    const PlanElement& up = all[(k + 1) % all.size()];
    const double top = std::min(down.start.y(), up.end.y());
    if (isUpright(down) && isUpright(up) && all[k].end.x() < all[k].start.x() &&
        top > all[k].start.y())
      bodies.push_back({rectangleOf(all[k].end.x(), all[k].start.x(), all[k].start.y(),
                                    top + assumed_slab)});
  }
}

/** @brief Adds what a cut room stands on, platforms filled. */
void
addFloor(const PlanLoop& loop, std::vector<PlanArea>& bodies)
{
  const double base = boundsOf(loop).min().y() - assumed_slab;
  for (const PlanElement& e : loop.elements)
    if (e.end.x() > e.start.x() && !isUpright(e))
      bodies.push_back(
          {loopOf({{e.start.x(), base}, {e.end.x(), base}, e.end, e.start})});
}

/** @brief Adds the walls and columns that a section cuts, with the slabs above and
 * below. */
void
addWalls(const Floorplan& plan,
         const std::vector<PlanWall>& walls,
         const SectionLine& line,
         std::vector<PlanArea>& bodies)
{
  constexpr double overlap = 1e-4; // with slabs, metres
  const Eigen::Vector2d way = (line.to - line.from).normalized();
  // What stands in or beside a room, whose heights hold at a place.
  const auto add = [&](const PlanRoom& room, double from, double to,
                       const Eigen::Vector2d& at) {
    const double floor = std::min(room.floorAt(at), heightsOf(room).low);
    const double ceiling = room.ceilingAt(at);
    double top = ceiling + assumed_slab;
    for (const PlanRoom& other : plan.rooms)
      if (other.contains(at) && other.floorAt(at) > ceiling &&
          other.floorAt(at) < ceiling + max_slab)
        top = std::max(top, other.floorAt(at));
    bodies.push_back(
        {rectangleOf(from - overlap, to + overlap, floor - assumed_slab, top)});
  };
  for (const PlanWall& wall : walls) {
    const PlanElement& face = elementOf(plan, wall.face);
    for (const auto& [from, to] : rangesIn(bandOf(plan, wall).boundary, line)) {
      constexpr double beside = 0.02; // metres
      const auto [at, inward] =
          faceAt(face, face.project(line.from + (from + to) / 2 * way));
      add(plan.rooms[wall.face.room], from, to, at + beside * inward);
    }
  }
  for (const PlanRoom& room : plan.rooms)
    for (const PlanLoop& column : room.columns)
      if (!isIsland(room, column))
        for (const auto& [from, to] : rangesIn(column, line))
          add(room, from, to, line.from + (from + to) / 2 * way);
}

/** @brief Adds the openings that a section runs through, as gaps upright between the
 * faces of their walls. */
void
addOpenings(const Floorplan& plan,
            const std::vector<PlanWall>& walls,
            const SectionLine& line,
            std::vector<OpeningGap>& gaps)
{
  const std::vector<OpeningGap> in_plan = openingGaps(plan, walls);
  for (std::size_t k = 0; k < in_plan.size(); ++k) {
    const auto& c = in_plan[k].corners;
    const double bottom = plan.openings[k].bottom;
    const double top = plan.openings[k].top;
    for (const auto& [from, to] : rangesIn(loopOf({c[0], c[3], c[2], c[1]}), line)) {
      OpeningGap gap = in_plan[k];
      gap.leaf.clear();
      gap.corners = {{{from, bottom}, {from, top}, {to, top}, {to, bottom}}};
      gaps.push_back(gap);
    }
  }
}

CutDrawing
sectionOf(const Floorplan& plan,
          const SectionLine& line,
          const DrawingSettings& settings)
{
  CutDrawing drawing;
  const std::vector<PlanWall> walls = findWalls(plan, {settings.max_wall});
  std::vector<CutRoom> rooms;
  for (const PlanRoom& room : plan.rooms)
    rooms.push_back({&room, cutOf(RoomFaces(room).solid, line)});
  std::vector<PlanArea> bodies;
  std::vector<PlanArea> open;
  addWalls(plan, walls, line, bodies);
  addOpenings(plan, walls, line, drawing.openings);
  const double zero = plan.rooms.empty() ? 0 : usualFloor(plan, storeysOf(plan)[0]);
  for (const CutRoom& cut : rooms)
    for (const PlanLoop& loop : cut.loops) {
      bodies.push_back({shifted(loop, assumed_slab)});
      addSlabs(loop, rooms, bodies);
      addBeams(loop, bodies);
      addFloor(loop, bodies);
      if (loop.area() > 0)
        open.push_back({loop});
      drawing.outlines.push_back(loop);
      const double floor = boundsOf(loop).min().y();
      for (const PlanElement& e : loop.elements)
        for (const PlanElement& part : cutAtGaps(e, drawing.openings)) {
          const bool is_floor = !isUpright(part) && part.start.y() - floor < 0.01 &&
                                part.end.y() - floor < 0.01 && part.length() > 0.5;
          drawing.lines.push_back({part, PlanLayer::Wall, cut.room->id,
                                   is_floor ? levelText(floor - zero) : ""});
        }
      const Eigen::Vector2d spot = textSpotIn(loop, {}).place;
      const Eigen::Vector2d at =
          line.from + spot.x() * (line.to - line.from).normalized();
      drawing.labels.push_back(
          {PlanLayer::Room,
           loop,
           {titleOf(*cut.room),
            "h " + decimalText(cut.room->ceilingAt(at) - cut.room->floorAt(at), 2) +
                " m"}});
    }
  drawing.addBodies(bodies, open, false);
  const std::vector<PlanLine> beyond = linesBeyond(plan, line, open);
  drawing.lines.insert(drawing.lines.begin(), beyond.begin(), beyond.end());
  const auto place = [](const Eigen::Vector2d& p) {
    return decimalText(p.x(), 2) + ", " + decimalText(p.y(), 2);
  };
  drawing.title = {
      line.letter.empty() ? "Section" : "Section " + line.letter + "-" + line.letter,
      "Section through",
      place(line.from) + " and " + place(line.to),
      "Rooms cut",
      std::to_string(
          std::count_if(rooms.begin(), rooms.end(),
                        [](const CutRoom& cut) { return !cut.loops.empty(); })),
      "Dimensions in metres, from face to face. Thin: beyond the cut. "
      "Levels above the usual "
      "floor of the lowest storey. Slabs and roofs of which one side was "
      "seen: 0.20 m assumed.",
      false};
  complete({drawing.outlines}, settings, drawing);
  return drawing;
}

/** @brief Returns the directions of the straight walls of a room, both ways. */
std::vector<Eigen::Vector2d>
directionsOf(const PlanRoom& room)
{
  std::vector<Eigen::Vector2d> ways;
  for (const PlanElement& e : room.boundary.elements)
    if (!e.isArc() && e.length() >= 1)
      for (const double sign : {1.0, -1.0})
        ways.push_back(sign * (e.end - e.start).normalized());
  return ways;
}

} // namespace

SectionLine
sectionThroughRooms(const Floorplan& plan)
{
  SectionLine best;
  std::pair<std::size_t, double> most{0, 0};
  for (const PlanRoom& room : plan.rooms) {
    const Eigen::Vector2d at = textSpotIn(room.boundary, room.columns).place;
    std::vector<Eigen::Vector2d> ways = directionsOf(room);
    if (ways.empty()) // it is round
      ways.emplace_back(1, 0);
    for (const Eigen::Vector2d& way : ways) {
      const SectionLine line{at, at + way, "A"};
      std::pair<std::size_t, double> cut{0, 0}; // rooms, metres
      for (const PlanRoom& other : plan.rooms) {
        const auto ranges = rangesIn(other.boundary, line);
        cut.first += ranges.empty() ? 0 : 1;
        for (const auto& [from, to] : ranges)
          cut.second += to - from;
      }
      constexpr double rounding = 1e-6; // metres
      if (cut.first > most.first ||
          (cut.first == most.first && cut.second > most.second + rounding)) {
        most = cut;
        best = line;
      }
    }
  }
  return best;
}

std::optional<SectionLine>
sectionThroughStairs(const Floorplan& plan)
{
  for (const PlanStair& stair : plan.stairs) {
    if (stair.flights.empty() || stair.flights.front().steps() < 2)
      continue;
    const PlanFlight& flight = stair.flights.front();
    const Eigen::Vector2d up = flight.middle(flight.steps() - 1) - flight.middle(0);
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (std::size_t k = 0; k < flight.steps(); ++k)
      middle += flight.middle(k) / static_cast<double>(flight.steps());
    Eigen::Vector2d way = up.normalized();
    double farthest = 0; // climbed along a wall
    if (const PlanRoom* const room = findRoom(plan, stair.rooms[0]))
      for (const Eigen::Vector2d& along : directionsOf(*room))
        if (along.dot(up) > farthest) {
          farthest = along.dot(up);
          way = along;
        }
    return SectionLine{middle, middle + way, "B"};
  }
  return std::nullopt;
}

std::vector<std::string>
drawSection(const Floorplan& plan,
            const SectionLine& line,
            const std::vector<DrawingFormat>& formats,
            const DrawingSettings& settings)
{
  if (std::all_of(plan.rooms.begin(), plan.rooms.end(), [&](const PlanRoom& room) {
        return rangesIn(room.boundary, line).empty();
      }))
    return {};
  Floorplan numbered = plan;
  numberOpenings(numbered);
  return written(sectionOf(numbered, line, settings), formats, settings);
}

} // namespace pcl::sedr
