// SPDX-License-Identifier: BSD-3-Clause
#include "plan_edits.h"

#include "../base/number_text.h"
#include "../plan/plan_geometry.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <pcl/sedr_filters/plan_measures.h>
#include <string>
#include <utility>
#include <vector>

namespace pcl::sedr {

bool
isSame(const PlanLoop& a, const PlanLoop& b)
{
  return std::equal(a.elements.begin(), a.elements.end(), b.elements.begin(),
                    b.elements.end(), [](const PlanElement& e, const PlanElement& f) {
                      return e.start == f.start && e.end == f.end &&
                             e.centre == f.centre && e.radius == f.radius;
                    });
}

std::optional<std::size_t>
elementLike(const PlanRoom& room, const PlanElement& wall)
{
  const std::vector<PlanElement>& walls = room.boundary.elements;
  for (std::size_t k = 0; k < walls.size(); ++k)
    if (isSame({{walls[k]}}, {{wall}}))
      return k;
  return {};
}

namespace {

/** @brief Returns an opening as it was before an edit. */
const PlanOpening&
openingBefore(const Floorplan& before, const PlanOpening& opening)
{
  const auto was = std::find_if(
      before.openings.begin(), before.openings.end(), [&](const PlanOpening& o) {
        return o.number == opening.number && o.kind == opening.kind;
      });
  return was == before.openings.end() ? opening : *was;
}

/** @brief Returns the walls that an opening was in. */
std::vector<PlanElement>
wallsOf(const Floorplan& plan, const PlanOpening& opening)
{
  std::vector<PlanElement> walls;
  for (const OpeningWall& wall : opening.walls)
    if (const PlanRoom* const room = findRoom(plan, wall.room);
        room && wall.element < room->boundary.elements.size())
      walls.push_back(room->boundary.elements[wall.element]);
  return walls;
}

constexpr double negligible = 0.01; // metres

std::string
placeText(const char* what, const Eigen::Vector2d& at)
{
  return formatText("the %s at (%.2f, %.2f)", what, at.x(), at.y());
}

/** @brief Returns how far an opening reaches beyond the ends of a wall. */
double
beyondWall(const PlanOpening& opening, const PlanElement& wall)
{
  double most = 0;
  for (const Eigen::Vector2d& end : {opening.start, opening.end}) {
    const double s = wall.project(end);
    const Eigen::Vector2d off = end - wall.pointAt(s);
    const Eigen::Vector2d normal = wall.normalAt(s);
    most = std::max(most, std::abs(off.x() * normal.y() - off.y() * normal.x()));
  }
  return most;
}

/** @brief Returns how far an opening reaches above the ceiling of a room, of which it
 * is in a wall. */
double
aboveCeiling(const PlanOpening& opening, const PlanRoom& room, std::size_t wall)
{
  const PlanElement& face = room.boundary.elements[wall];
  const double s = face.project((opening.start + opening.end) / 2);
  return std::max(opening.top -
                      room.ceilingAt(face.pointAt(s) + negligible * face.normalAt(s)),
                  0.0);
}

/** @brief The room that a flight is in, and how far the flight reaches out of it. */
struct FlightRoom {
  std::uint32_t room = 0;
  double outside = std::numeric_limits<double>::infinity();
};

FlightRoom
roomAround(const Floorplan& plan, const PlanFlight& flight)
{
  const auto heightIn = [](const PlanRoom& room, const Eigen::Vector2d& p, double z) {
    return room.floor.heightAt(p) < z && room.ceiling.heightAt(p) > z;
  };
  const Eigen::Vector2d middle = flight.middle(flight.steps() / 2);
  FlightRoom best;
  for (const PlanRoom& room : plan.rooms) {
    if (!heightIn(room, middle, (flight.bottom + flight.top()) / 2))
      continue;
    double outside = 0;
    bool is_in = false;
    for (const Eigen::Vector2d& corner : flight.outline())
      if (room.boundary.contains(corner))
        is_in = true;
      else
        outside = std::max(outside, room.boundary.distance(corner));
    if (is_in && outside < best.outside)
      best = {room.id, outside};
  }
  return best;
}

} // namespace

void
forEachReference(Floorplan& plan,
                 const std::function<void(std::uint32_t&, const Eigen::Vector2d&)>& see)
{
  for (PlanOpening& opening : plan.openings) {
    const Eigen::Vector2d middle = (opening.start + opening.end) / 2;
    for (std::uint32_t* of : {&opening.rooms[0], &opening.rooms[1], &opening.swing})
      see(*of, middle);
    for (OpeningWall& wall : opening.walls)
      see(wall.room, middle);
  }
  for (PlanStair& stair : plan.stairs) {
    const auto& flights = stair.flights;
    see(stair.rooms[0], flights.empty() ? stair.at : flights.front().middle(0));
    see(stair.rooms[1],
        flights.empty() ? stair.at : flights.back().middle(flights.back().steps() - 1));
  }
}

void
renumber(Floorplan& plan, std::uint32_t from, std::uint32_t to)
{
  for (PlanOpening& opening : plan.openings)
    if (std::minmax(opening.rooms[0], opening.rooms[1]) == std::minmax(from, to))
      opening.walls.clear(); // it was between them
  forEachReference(plan, [&](std::uint32_t& room, const Eigen::Vector2d&) {
    room = room == from ? to : room;
  });
  const auto removeIf = [](auto& list, const auto& goes) {
    list.erase(std::remove_if(list.begin(), list.end(), goes), list.end());
  };
  for (PlanOpening& opening : plan.openings)
    removeIf(opening.walls, [](const OpeningWall& wall) { return wall.room == 0; });
  removeIf(plan.stairs, [](const PlanStair& stair) { return !stair.leadsSomewhere(); });
  for (PlanStorey& storey : plan.storeys)
    removeIf(storey.rooms, [from](std::uint32_t room) { return room == from; });
  removeIf(plan.storeys, [](const PlanStorey& storey) { return storey.rooms.empty(); });
}

std::vector<std::string>
attachOpenings(const Floorplan& before, Floorplan& plan, double max_wall)
{
  std::vector<std::string> told;
  const auto attach = [&](PlanOpening& opening) {
    const Eigen::Vector2d middle = (opening.start + opening.end) / 2;
    const std::string what =
        markOf(opening) + ": " +
        placeText(opening.kind == OpeningKind::Unknown ? "opening"
                                                       : nameOf(opening.kind),
                  middle);
    const PlanOpening& was = openingBefore(before, opening);
    const std::vector<PlanElement> before_walls = wallsOf(before, was);
    std::vector<OpeningWall> walls;
    for (const OpeningWall& wall : opening.walls) {
      const PlanRoom* const room = findRoom(plan, wall.room);
      if (!room)
        continue;
      std::optional<std::size_t> element;
      double known = 0; // how far it reached beyond a wall
      for (const PlanElement& old : before_walls) {
        element = element ? element : elementLike(*room, old);
        known = std::max(known, beyondWall(opening, old));
      }
      const bool is_same = element.has_value();
      if (!is_same)
        element = wallBeside(*room, opening);
      if (!element)
        continue;
      walls.push_back({wall.room, *element});
      const double beyond = beyondWall(opening, room->boundary.elements[*element]);
      if (!is_same && beyond > negligible + known)
        told.push_back(what +
                       formatText(", %.2f m wide, reaches %.2f m beyond wall ",
                                  opening.width(), beyond) +
                       std::to_string(wall.room) + "." + std::to_string(*element + 1));
      double known_above = 0;
      for (const OpeningWall& old : was.walls)
        if (const PlanRoom* const r = findRoom(before, old.room);
            r && old.room == wall.room && old.element < r->boundary.elements.size())
          known_above = std::max(known_above, aboveCeiling(was, *r, old.element));
      const double above = aboveCeiling(opening, *room, *element);
      if (above > negligible + known_above)
        told.push_back(what + formatText(", up to z %.2f m, reaches %.2f m above the "
                                         "ceiling of room %.0f",
                                         opening.top, above,
                                         static_cast<double>(wall.room)));
    }
    opening.walls = walls;
    const bool is_between_none =
        opening.rooms != was.rooms && opening.rooms[0] == opening.rooms[1];
    const bool goes = walls.empty() && (!was.walls.empty() || is_between_none);
    if (goes)
      told.push_back(what + " is in no wall any more: it is left out");
    else if (walls.size() < was.walls.size() ||
             (opening.depth > max_wall && was.depth <= max_wall))
      told.push_back(
          what +
          " is in no wall between its rooms any more: the IFC may be without it");
    return goes;
  };
  plan.openings.erase(
      std::remove_if(plan.openings.begin(), plan.openings.end(), attach),
      plan.openings.end());
  return told;
}

std::vector<std::string>
flightsThroughWalls(const Floorplan& before, const Floorplan& plan)
{
  std::vector<std::string> told;
  for (const PlanStair& stair : plan.stairs)
    for (const PlanFlight& flight : stair.flights) {
      const FlightRoom old = roomAround(before, flight);
      const FlightRoom now = roomAround(plan, flight);
      if (now.outside <= old.outside + negligible)
        continue;
      const std::string what =
          placeText("flight of stairs", flight.middle(flight.steps() / 2));
      told.push_back(now.room == 0
                         ? what + " is in no room any more"
                         : what + formatText(", from z %.2f to %.2f m, reaches %.2f m "
                                             "through a wall of room %.0f",
                                             flight.bottom, flight.top(), now.outside,
                                             static_cast<double>(now.room)));
    }
  return told;
}

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
