// SPDX-License-Identifier: BSD-3-Clause
#include "plan_check.h"

#include "../base/number_text.h"
#include "../base/printable.h"
#include "../walls/plan_walls.h"
#include "plan_geometry.h"

#include <pcl/sedr_filters/plan_editor.h>
#include <pcl/sedr_filters/plan_measures.h>

#include <boost/locale/encoding_utf.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr double max_radius = 1e5;           // metres
constexpr double max_gap_of_arc = 1e-3;      // of its ends from its circle, metres
constexpr double max_gap_of_loop = 1e-6;     // metres
constexpr std::size_t max_heights = 4000000; // of a relief
constexpr std::size_t max_steps = 1000;      // of a flight

/** @brief Throws a sentence unless `is_valid`. */
void
require(bool is_valid, const std::string& problem)
{
  if (!is_valid)
    throw std::invalid_argument(problem);
}

/** @param what with its article
 * @param unit with a blank before it */
void
checkRange(double value,
           double low,
           double high,
           const std::string& what,
           const char* unit = " m")
{
  require(value >= low && value <= high, what + " must lie from " + numberText(low) +
                                             " to " + numberText(high) + unit +
                                             ", it is " + numberText(value));
}

void
checkLength(double value, const std::string& what, double most = max_coordinate)
{
  require(std::abs(value) <= most, what + " must lie within " + numberText(most) +
                                       " m, it is " + numberText(value));
}

void
checkPlace(const Eigen::Vector2d& p)
{
  for (const double coordinate : p)
    checkLength(coordinate, "a coordinate");
}

void
checkAccuracy(const SurfaceAccuracy& accuracy)
{
  checkRange(accuracy.standard_error, 0, max_coordinate,
             "the standard error of a surface");
  checkRange(accuracy.deviation_95, 0, max_coordinate, "the deviation of a surface");
}

void
checkElement(const PlanElement& e)
{
  checkPlace(e.start);
  checkPlace(e.end);
  for (const auto& [name, share] : {std::make_pair("seen", e.evidence.seen),
                                    std::make_pair("hidden", e.evidence.hidden),
                                    std::make_pair("opening", e.evidence.opening)})
    checkRange(share, 0, 1, std::string("the share ") + name + " of an element", "");
  checkAccuracy(e.accuracy);
  checkRange(e.tilt * 180 / M_PI, -45, 45, "the tilt of a wall", " degrees");
  if (e.radius == 0)
    return;
  checkPlace(e.centre);
  checkRange(e.radius, 0, max_radius, "the radius of an arc");
  for (const Eigen::Vector2d& end : {e.start, e.end}) {
    const double gap = std::abs((end - e.centre).norm() - e.radius);
    require(gap <= max_gap_of_arc, "an end of an arc must lie on its circle, it is " +
                                       numberText(gap) + " m off");
  }
}

void
checkLoop(const PlanLoop& loop)
{
  require(!loop.elements.empty(), "a loop has no elements");
  for (std::size_t i = 0; i < loop.elements.size(); ++i) {
    checkElement(loop.elements[i]);
    const auto& next = loop.elements[(i + 1) % loop.elements.size()];
    const double gap = (loop.elements[i].end - next.start).norm();
    require(gap < max_gap_of_loop, "a loop is open by " + numberText(gap) +
                                       " m after element " + std::to_string(i));
  }
}

void
checkOuter(const PlanLoop& loop)
{
  checkLoop(loop);
  require(loop.area() > 0, "a boundary must run counter-clockwise around an area above "
                           "0 m2, it is " +
                               numberText(loop.area()) + " m2");
}

void
checkInner(const std::vector<PlanLoop>& loops)
{
  for (const PlanLoop& loop : loops) {
    checkLoop(loop);
    require(loop.area() < 0, "a column or hole must run clockwise around an area, it "
                             "is " +
                                 numberText(loop.area()) + " m2");
  }
}

void
checkSlab(const PlanSlab& slab)
{
  const double length = slab.plane.head<3>().norm();
  require(std::abs(length - 1) <= 1e-3,
          "the normal of a floor or ceiling must have length 1, it has " +
              numberText(length));
  require(slab.plane[2] >= min_upward,
          "the plane of a floor or ceiling must face up, its c is " +
              numberText(slab.plane[2]) + ", at least " + numberText(min_upward) +
              " is needed");
  // A place whose coordinates are within the limit is at most sqrt(3) times as far.
  checkLength(slab.plane[3], "the d of a floor or ceiling", 2 * max_coordinate);
  checkAccuracy(slab.accuracy);
  if (!slab.curve)
    return;
  checkPlace(slab.curve->centre);
  require(slab.curve->heights.size() <= max_heights,
          "a relief has at most " + std::to_string(max_heights) + " heights, not " +
              std::to_string(slab.curve->heights.size()));
  require(slab.curve->isFinite(),
          "the extents of a curved facet must be above 0 m and its heights finite");
}

/** @param what with its article, and whose it is */
void
checkName(const std::string& name, const std::string& what)
{
  namespace conv = boost::locale::conv;
  constexpr std::size_t most = 255; // characters of a label in IFC
  std::u32string letters;
  try {
    letters = conv::utf_to_utf<char32_t>(name, conv::stop);
  }
  catch (const conv::conversion_error&) {
    require(false, what + " is not UTF-8");
  }
  require(letters.size() <= most, what + " has at most " + std::to_string(most) +
                                      " characters, not " +
                                      std::to_string(letters.size()));
  const auto odd = std::find_if_not(letters.begin(), letters.end(), isPrintable);
  require(odd == letters.end(), "character " +
                                    std::to_string(odd - letters.begin() + 1) + " of " +
                                    what + " cannot be printed");
}

/** @brief Checks that the ceiling is above the floor somewhere along the walls or the
 * edges of details. */
void
checkHeight(const PlanRoom& room)
{
  constexpr double beside = 0.01; // metres
  Eigen::Vector2d p;
  std::vector<PlanElement> edges = room.boundary.elements;
  for (const auto* details : {&room.details, &room.floor_details})
    for (const PlanDetail& detail : *details)
      edges.insert(edges.end(), detail.boundary.elements.begin(),
                   detail.boundary.elements.end());
  const bool is_above =
      std::any_of(edges.begin(), edges.end(), [&](const PlanElement& e) {
        const double middle = e.length() / 2;
        p = e.pointAt(middle) + beside * e.normalAt(middle);
        return room.ceilingAt(p) > room.floorAt(p);
      });
  require(is_above, "the ceiling of room " + std::to_string(room.id) + ", at z " +
                        shortDecimalText(room.ceilingAt(p), 3) +
                        " m, must be above its floor, at " +
                        shortDecimalText(room.floorAt(p), 3));
}

/** @brief Checks that no tilted walls meet below the ceiling over them. */
void
checkTilts(const PlanRoom& room)
{
  if (!isTilted(room))
    return;
  const auto meetBelow = [&](double z) {
    return "the tilted walls of room " + std::to_string(room.id) +
           " meet below its ceiling at z " + numberText(z) + " m: ";
  };
  double lowest = std::numeric_limits<double>::infinity(); // of the walls' heads
  for (std::size_t i = 0; i < room.boundary.elements.size(); ++i) {
    const PlanElement& foot = room.boundary.elements[i];
    const auto sizeAt = [&](double z) { // linear in z
      const PlanElement wall = wallAt(room, i, z);
      return foot.isArc() ? wall.radius
                          : (wall.end - wall.start).dot(foot.end - foot.start);
    };
    const double head = headOf(room, i);
    lowest = std::min(lowest, head);
    const double size = sizeAt(head);
    require(size > 0,
            meetBelow(head) + "nothing is left of wall " + std::to_string(room.id) +
                "." + std::to_string(i + 1) + " from z " +
                numberText(head + size / (sizeAt(head - 1) - size)) + " m on");
  }
  const std::string problem = outlineProblem(boundaryAt(room, lowest));
  require(problem.empty() || !outlineProblem(room.boundary).empty(),
          meetBelow(lowest) + "its outline there " + problem);
}

void
checkRoom(const PlanRoom& room)
{
  checkName(room.name, "the name of room " + std::to_string(room.id));
  checkSlab(room.floor);
  checkSlab(room.ceiling);
  checkOuter(room.boundary);
  checkInner(room.columns);
  for (const auto* details : {&room.details, &room.floor_details})
    for (const PlanDetail& detail : *details) {
      checkSlab(detail.slab);
      checkOuter(detail.boundary);
      checkInner(detail.holes);
    }
  for (const PlanNiche& niche : room.niches) {
    checkOuter(niche.boundary);
    checkSlab(niche.bottom);
    checkSlab(niche.top);
  }
  checkHeight(room);
  checkTilts(room);
}

using Ids = std::set<std::uint32_t>;

void
checkRoomId(std::uint32_t id, const std::string& what, const Ids& ids)
{
  require(ids.count(id) > 0, what + " names room " + std::to_string(id) +
                                 ", which the plan does not have");
}

void
checkStoreys(const std::vector<PlanStorey>& storeys, const Ids& ids)
{
  Ids placed;
  Ids numbers;
  for (const PlanStorey& storey : storeys) {
    checkName(storey.name, "the name of storey " + std::to_string(storey.number));
    checkLength(storey.floor, "the floor of a storey");
    checkLength(storey.ceiling, "the ceiling of a storey");
    require(numbers.insert(storey.number).second,
            "two storeys have the number " + std::to_string(storey.number));
    for (const std::uint32_t id : storey.rooms) {
      checkRoomId(id, "a storey", ids);
      require(placed.insert(id).second,
              "room " + std::to_string(id) + " is listed twice in the storeys");
    }
  }
}

void
checkFlight(const PlanFlight& flight)
{
  constexpr double max_rise = 1; // metres
  require(flight.steps() >= 2 && flight.steps() <= max_steps,
          "a flight has from 2 to " + std::to_string(max_steps) + " risers, not " +
              std::to_string(flight.steps()));
  require(flight.rise > 0 && flight.rise <= max_rise,
          "the rise of a flight must be above 0 m and at most " + numberText(max_rise) +
              " m, it is " + numberText(flight.rise));
  checkLength(flight.bottom, "a flight's bottom");
  for (const PlanFlight::Riser& riser : flight.risers)
    for (const Eigen::Vector2d& end : riser)
      checkPlace(end);
}

void
checkStair(const PlanStair& stair, const Ids& ids)
{
  for (const std::uint32_t id : stair.rooms)
    if (id != 0)
      checkRoomId(id, "a stair", ids);
  require(stair.leadsSomewhere(),
          "a stair leads from room " + std::to_string(stair.rooms[0]) + " to itself");
  checkLength(stair.bottom, "a stair's bottom");
  checkLength(stair.top, "a stair's top");
  require(stair.top >= stair.bottom,
          "a stair's top must not be below its bottom, it is by " +
              numberText(stair.bottom - stair.top) + " m");
  checkPlace(stair.at);
  for (const PlanFlight& flight : stair.flights)
    checkFlight(flight);
}

void
checkOpening(const PlanOpening& opening, const Floorplan& plan, const Ids& ids)
{
  for (const std::uint32_t id : {opening.rooms[0], opening.rooms[1], opening.swing})
    if (id != 0)
      checkRoomId(id, "an opening", ids);
  require(opening.walls.size() <= 2, "an opening is in at most 2 walls, not " +
                                         std::to_string(opening.walls.size()));
  for (const OpeningWall& wall : opening.walls)
    require(findRoom(plan, wall.room) &&
                wall.element < findRoom(plan, wall.room)->boundary.elements.size(),
            "an opening names wall " + std::to_string(wall.element) + " of room " +
                std::to_string(wall.room) + ", which the plan does not have");
  checkRange(opening.number, 0, 1e6, "the number of an opening", "");
  checkPlace(opening.start);
  checkPlace(opening.end);
  checkLength(opening.bottom, "an opening's bottom");
  checkLength(opening.top, "an opening's top");
  require(opening.width() > 0, "an opening has a width above 0 m");
  require(opening.height() > 0,
          "the top of " + markOf(opening) + ", at z " + numberText(opening.top) +
              " m, must be above its bottom, at " + numberText(opening.bottom));
  checkRange(opening.rise, 0, opening.height(), "the rise of an opening's head");
  checkRange(opening.depth, 0, max_coordinate, "the depth of an opening");
  checkRange(opening.residual, 0, max_coordinate, "the residual of an opening");
  checkRange(opening.deviation_95, 0, max_coordinate, "the deviation of an opening");
  for (const OpeningEdge& edge : opening.edges)
    checkRange(edge.error, 0, max_coordinate, "the error of an opening's edge");
  checkRange(opening.confidence, 0, 1, "the confidence of an opening", "");
}

void
checkPlan(const Floorplan& plan)
{
  Ids ids;
  for (const PlanRoom& room : plan.rooms) {
    require(ids.insert(room.id).second,
            "two rooms have the id " + std::to_string(room.id));
    checkRoom(room);
  }
  checkStoreys(plan.storeys, ids);
  for (const PlanStair& stair : plan.stairs)
    checkStair(stair, ids);
  std::set<std::string> marks;
  for (const PlanOpening& opening : plan.openings) {
    checkOpening(opening, plan, ids);
    require(opening.number == 0 || marks.insert(markOf(opening)).second,
            "two openings have the number " + markOf(opening));
  }
}

} // namespace

std::string
roomProblem(const PlanRoom& room)
{
  return planProblem({{room}});
}

std::string
mendTilts(PlanRoom& room)
{
  const std::string problem = roomProblem(room);
  PlanRoom straight = withVerticalWalls(room);
  if (problem.empty() || !roomProblem(straight).empty())
    return problem;
  room = std::move(straight);
  return "its walls are vertical in the plan: " + problem;
}

std::string
planProblem(const Floorplan& plan)
{
  try {
    checkPlan(plan);
    return {};
  }
  catch (const std::invalid_argument& error) {
    return error.what();
  }
}

} // namespace pcl::sedr
