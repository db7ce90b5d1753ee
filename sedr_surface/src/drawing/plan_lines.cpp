// SPDX-License-Identifier: BSD-3-Clause
#include "plan_drawing.h"

#include "../sheet/text_places.h"
#include "../walls/wall_band.h"
#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include "sedr_filters/src/walls/plan_walls.h"

#include <pcl/sedr_filters/plan_measures.h>

#define BOOST_ALLOW_DEPRECATED_HEADERS // Boost.Geometry includes one
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pcl::sedr {
namespace {

/** @brief Returns both sides of the head of an arrow, metres. */
std::array<PlanElement, 2>
arrowHead(const Eigen::Vector2d& from, const Eigen::Vector2d& tip)
{
  constexpr double length = 0.15; // metres
  const Eigen::Vector2d way = length * (tip - from).normalized();
  const Eigen::Vector2d left(-way.y() / 2, way.x() / 2);
  return {segment(tip - way + left, tip), segment(tip, tip - way - left)};
}

constexpr double dot = 0.04; ///< radius of the mark at a foot, metres

/** @brief A flight as a plan shows it, which looks down from where it cuts. */
struct ShownFlight {
  const PlanFlight* flight = nullptr;
  std::uint32_t room = 0;
  std::size_t below = 0; ///< number of its risers below the cut

  bool isCut() const { return below < flight->steps(); }

  /** @brief Returns the outline of its treads up to the middle of the one that is cut.
   */
  PlanLoop outline() const
  {
    PlanFlight part = *flight;
    part.risers.resize(isCut() ? below + 1 : below);
    if (isCut())
      for (std::size_t side = 0; side < 2; ++side)
        part.risers[below][side] =
            (part.risers[below - 1][side] + part.risers[below][side]) / 2;
    return loopOf(part.outline());
  }

  /** @brief Returns its treads from one on, and the line on which one walks, from a dot
   * at its foot to an arrow. It ends in two break lines where the plan cuts it. */
  std::vector<PlanElement> linesFrom(std::size_t first) const
  {
    const auto& risers = flight->risers;
    const std::size_t last = below - 1;
    std::vector<PlanElement> found;
    const auto add = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
      found.push_back(segment(from, to));
    };
    for (std::size_t k = first; k <= last; ++k)
      add(risers[k][0], risers[k][1]);
    for (std::size_t k = first; k < last; ++k) {
      add(risers[k][0], risers[k + 1][0]);
      add(risers[k][1], risers[k + 1][1]);
      add(flight->middle(k), flight->middle(k + 1));
    }
    if (first == 0) {
      add(flight->middle(0) + Eigen::Vector2d(dot, 0),
          flight->middle(0) + Eigen::Vector2d(dot, 0));
      found.back().centre = flight->middle(0);
      found.back().radius = dot;
    }
    if (last > first)
      for (const PlanElement& side :
           arrowHead(flight->middle(last - 1), flight->middle(last)))
        found.push_back(side);
    if (!isCut())
      return found;
    const auto along = [&](std::size_t side, double up) -> Eigen::Vector2d {
      return risers[last][side] + up * (risers[last + 1][side] - risers[last][side]);
    };
    for (const double up : {0.15, 0.4})
      add(along(0, up), along(1, up + 0.45));
    add(risers[last][0], along(0, 0.4));
    add(risers[last][1], along(1, 0.85));
    return found;
  }
};

/** @brief Returns the convex outline of a stair's flights in plan. */
PlanLoop
stairwellOf(const PlanStair& stair)
{
  namespace geometry = boost::geometry;
  using Corner = geometry::model::d2::point_xy<double>;
  geometry::model::multi_point<Corner> ends;
  for (const PlanFlight& flight : stair.flights)
    for (const PlanFlight::Riser& riser : flight.risers)
      for (const Eigen::Vector2d& end : riser)
        ends.emplace_back(end.x(), end.y());
  geometry::model::polygon<Corner, false, false> hull;
  geometry::convex_hull(ends, hull);
  std::vector<Eigen::Vector2d> corners;
  for (const Corner& corner : hull.outer())
    corners.emplace_back(corner.x(), corner.y());
  return loopOf(corners);
}

/** @brief Adds the flights of all stairs: up to 1.2 m above the lower room's floor on a
 * plan with that room, whole on one that has the upper room only. What lies below
 * another flight that is drawn is left out, and what of a flight within the room is
 * beyond its walls. */
void
addStairs(const Floorplan& plan, std::vector<PlanLine>& lines)
{
  constexpr double cut = 1.2;     // metres above its floor
  constexpr double beside = 0.03; // lines as near to a flight are part of it, metres
  std::vector<ShownFlight> shown;
  for (const PlanStair& stair : plan.stairs) {
    const bool is_up = findRoom(plan, stair.rooms[0]) != nullptr;
    if (!is_up && !findRoom(plan, stair.rooms[1]))
      continue;
    for (const PlanFlight& flight : stair.flights) {
      std::size_t below = 0;
      while (below < flight.steps() &&
             (!is_up || flight.bottom + flight.rise * static_cast<double>(below) <
                            stair.bottom + cut))
        ++below;
      if (below > 0 && flight.steps() > 1)
        shown.push_back({&flight, stair.rooms[is_up ? 0 : 1], below});
    }
  }
  std::stable_sort(shown.begin(), shown.end(),
                   [](const ShownFlight& a, const ShownFlight& b) {
                     return a.flight->bottom > b.flight->bottom;
                   });
  std::vector<PlanLoop> above;
  for (const ShownFlight& flight : shown) {
    const auto isSeen = [&](const Eigen::Vector2d& p) {
      return std::none_of(above.begin(), above.end(), [&](const PlanLoop& other) {
        return other.contains(p) || other.distance(p) < beside;
      });
    };
    std::size_t first = 0; // after the last tread that is hidden
    for (std::size_t k = 0; k + 1 < flight.below; ++k)
      if (!isSeen((flight.flight->middle(k) + flight.flight->middle(k + 1)) / 2))
        first = k + 1;
    const PlanRoom& room = *findRoom(plan, flight.room);
    const auto isThrough = [&](const Eigen::Vector2d& p) { // a wall beside the flight
      std::size_t nearest = 0;
      for (std::size_t k = 1; k < flight.below; ++k)
        if ((flight.flight->middle(k) - p).norm() <
            (flight.flight->middle(nearest) - p).norm())
          nearest = k;
      return !room.contains(p) && room.contains(flight.flight->middle(nearest));
    };
    for (const PlanElement& line : first + 1 < flight.below
                                       ? flight.linesFrom(first)
                                       : std::vector<PlanElement>())
      for (const PlanElement& part : partsWhere(line, [&](double s) {
             const Eigen::Vector2d p = line.pointAt(s);
             return isSeen(p) && !isThrough(p);
           }))
        if (part.length() > beside)
          lines.push_back({part, PlanLayer::Stair, flight.room});
    above.push_back(flight.outline());
  }
}

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

  /** @brief Adds what of a loop is on no wall. */
  void addOffWalls(const PlanLoop& loop, PlanLayer layer)
  {
    for (const PlanElement& element : loop.elements) {
      const auto isFree = [&](double s) {
        const Eigen::Vector2d p = element.pointAt(s);
        return room_.boundary.distance(p) > on_wall &&
               std::none_of(
                   room_.columns.begin(), room_.columns.end(),
                   [&](const PlanLoop& c) { return c.distance(p) <= on_wall; });
      };
      for (const PlanElement& part : partsWhere(element, isFree))
        add(part, layer);
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
    for (const PlanElement& part : partsWhere(element, isFree))
      if (part.length() > std::min(shortest, 0.99 * element.length()))
        add(part, layer, std::exchange(note, ""));
  }

  /** @brief Adds the heads of tilted walls. */
  void addHeads()
  {
    const std::vector<PlanElement>& walls = room_.boundary.elements;
    for (std::size_t e = 0; e < walls.size(); ++e) {
      if (walls[e].tilt == 0)
        continue;
      add(wallAt(room_, e, headOf(room_, e)), PlanLayer::Ceiling,
          "tilt " + decimalText(std::abs(walls[e].tilt) * 180 / M_PI, 1) + "°");
    }
  }

  /** @brief Adds an arrow up each slope of the floor or ceiling. */
  void addSlopes(SurfaceSide side, const SurfaceLines& lines)
  {
    for (const NotedPart& part : lines.noted(room_, side))
      addSlope(part, side == SurfaceSide::Floor);
  }

private:
  /** @brief Adds an arrow with its share as note, of a ceiling its angle. */
  void addSlope(const NotedPart& part, bool is_floor)
  {
    const PlanSlab& slab = part.slab;
    constexpr double least = 0.01; // of a slope
    const auto upAt = [&](const Eigen::Vector2d& p) -> Eigen::Vector2d {
      const Eigen::Vector3d normal = slab.normalAt(p);
      return -normal.head<2>() / normal.z();
    };
    if (is_floor ? !slab.curve && upAt({0, 0}).norm() < least
                 : slab.curve || isLevel(slab)) // curved ceilings have contours
      return;
    const TextSpot spot = textSpotIn(part.outline, part.others);
    const Eigen::Vector2d up = upAt(spot.place);
    const double reach = std::min(0.8 * spot.radius, 1.0); // metres
    if (up.norm() < least || reach < 0.2 || !room_.contains(spot.place))
      return;
    const PlanLayer layer = is_floor ? PlanLayer::Floor : PlanLayer::Slope;
    const Eigen::Vector2d half = reach * up.normalized();
    add(segment(spot.place - half, spot.place + half), layer,
        is_floor ? shortDecimalText(100 * up.norm(), 1) + " %"
                 : decimalText(std::atan(up.norm()) * 180 / M_PI, 1) + "°");
    for (const PlanElement& side : arrowHead(spot.place - half, spot.place + half))
      add(side, layer);
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
    for (const PlanElement& part : partsWhere(far, isFree))
      lines.push_back({part, layer});
  }
}

} // namespace

void
DrawnSurfaces::findLines(double finest)
{
  ceiling = surfaceLines(faces.room, SurfaceSide::Ceiling, finest);
  floor = surfaceLines(faces.room, SurfaceSide::Floor, finest);
}

std::vector<PlanLine>
planLines(const Floorplan& plan,
          const std::vector<PlanWall>& walls,
          const std::vector<DrawnSurfaces>& surfaces,
          DrawingView view)
{
  const bool is_floor = view == DrawingView::Floor;
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
    for (const PlanNiche& niche : room.niches)
      lines.addOffWalls(niche.boundary, PlanLayer::Niche);
    for (const SurfaceLine& line : surfaces[r].ceiling.lines) {
      const PlanLayer layer = line.is_crease ? PlanLayer::Ridge : PlanLayer::Ceiling;
      is_floor ? lines.addOverhead(line.element, layer, line.text)
               : lines.add(line.element, layer, line.text);
    }
    lines.addHeads();
    if (!is_floor) {
      for (const SurfaceLine& line : contourLines(surfaces[r].faces))
        lines.add(line.element, PlanLayer::Contour, line.text);
      lines.addSlopes(SurfaceSide::Ceiling, surfaces[r].ceiling);
      continue;
    }
    for (const SurfaceLine& line : surfaces[r].floor.lines)
      lines.add(line.element, PlanLayer::Floor);
    lines.addSlopes(SurfaceSide::Floor, surfaces[r].floor);
    for (const double height : headrooms)
      for (const SurfaceLine& line : heightLines(surfaces[r].faces, height))
        lines.addOverhead(line.element, PlanLayer::Headroom, line.text);
  }
  if (is_floor)
    addStairs(plan, all);
  return all;
}

} // namespace pcl::sedr
