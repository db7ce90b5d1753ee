// SPDX-License-Identifier: BSD-3-Clause
#include "../sheet/text_places.h"
#include "sedr_filters/src/base/quantiles.h"
#include "unlikely_places.h"

#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_filters/priors.h>
#include <pcl/sedr_surface/plan_review.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Log-odds of being right. */
struct Weights {
  std::array<double, 3> within;                         ///< without signs
  std::vector<std::pair<const char*, double>> of_signs; ///< by name
};

const double max_wall = Priors().max_wall;

/** @brief What test/benchmarks/certainty_grades.py fits; the only place for it. */
const Weights&
wallWeights()
{
  static const Weights weights{{-3.34, -2.80, -2.72},
                               {{"log_length", 0.73},
                                {"measured", 2.61},
                                {"placed", 2.45},
                                {"log_error", -1.39},
                                {"two_faces", 1.14},
                                {"off", -0.89},
                                {"passed", -5.0},    // odd scenes, odd_scenes.py
                                {"in_line", -3.5}}}; // likewise
  return weights;
}

const Weights&
openingWeights()
{
  static const Weights weights{{-1.07, 0.14, 0.91},
                               {{"log_confidence", 0.34},
                                {"log_error", -0.97},
                                {"two_faces", 1.10},
                                {"unknown_kind", -0.93},
                                {"unseen_jamb", -1.6}}};
  return weights;
}

std::vector<std::string>
namesOf(const Weights& weights)
{
  std::vector<std::string> names;
  for (const auto& sign : weights.of_signs)
    names.emplace_back(sign.first);
  return names;
}

/** @param error standard error of its place, metres; 0: not known */
Certainty
certaintyBy(const Weights& weights, Certainty certainty, double error = 0)
{
  double odds = 0;
  for (std::size_t k = 0; k < weights.of_signs.size(); ++k)
    odds += weights.of_signs[k].second * certainty.signs[k];
  for (std::size_t k = 0; k < weights.within.size(); ++k)
    certainty.within[k] =
        (error > 0 ? std::erf(certainty_steps[k] / (error * std::sqrt(2))) : 1) /
        (1 + std::exp(-odds - weights.within[k]));
  return certainty;
}

/** @brief Returns the median of the errors that are known, metres. */
double
usualError(std::vector<double> errors)
{
  errors.erase(std::remove(errors.begin(), errors.end(), 0.0), errors.end());
  return errors.empty() ? 0 : middleValue(errors);
}

/** @brief Returns the logarithm of an error that is known as a multiple of the usual
 * one, so that the noise of a scan cancels out. */
double
logError(double error, double usual)
{
  return std::log(error / usual);
}

} // namespace

std::vector<std::string>
wallSigns()
{
  return namesOf(wallWeights());
}

std::vector<std::string>
openingSigns()
{
  return namesOf(openingWeights());
}

std::vector<Certainty>
certaintyOfWalls(const Floorplan& plan, const std::vector<PlanWarning>& warnings)
{
  using Wall = std::pair<std::uint32_t, std::size_t>;
  struct Told {
    double off = 0;          // square metres
    double passed = 0;       // metres under a ceiling that goes on
    bool is_in_line = false; // with the edge of a soffit beyond its end
  };
  std::map<Wall, Told> told;
  for (const PlanWarning& warning : warnings) {
    Told& of_wall = told[{warning.room, warning.wall}];
    const std::vector<double>& values = warning.values;
    const bool is_off = warning.kind == WarningKind::WallOff;
    of_wall.off += is_off && !values.empty() ? values[0] : 0;
    of_wall.passed += is_off && values.size() > 2 ? values[2] : 0;
    of_wall.is_in_line |= warning.kind == WarningKind::InLine;
  }
  std::vector<double> errors;
  bool is_any_known = false;
  for (const PlanRoom& room : plan.rooms)
    for (const PlanElement& wall : room.boundary.elements) {
      errors.push_back(wall.accuracy.standard_error);
      is_any_known = is_any_known || wall.evidence.isKnown();
    }
  const double usual = usualError(std::move(errors));
  const auto thicknesses = wallThicknesses(plan, max_wall);
  std::vector<Certainty> walls;
  for (std::size_t r = 0; r < plan.rooms.size(); ++r)
    for (std::size_t e = 0; e < plan.rooms[r].boundary.elements.size(); ++e) {
      const PlanRoom& room = plan.rooms[r];
      const PlanElement& wall = room.boundary.elements[e];
      const Eigen::Vector2d middle = wall.pointAt(wall.length() / 2);
      const double area =
          wall.length() * (room.ceilingAt(middle) - room.floorAt(middle));
      WallShares shares = wallShares(plan, room, e);
      const bool is_unseen = is_any_known && !wall.evidence.isKnown();
      if (is_unseen && area > 0)
        shares = {area, 0, 0, 1};
      if (!(shares.area > 0))
        continue;
      const double error = wall.accuracy.standard_error;
      const Told& of_wall = told[{room.id, e + 1}];
      walls.push_back(certaintyBy(
          wallWeights(),
          {std::to_string(room.id) + "." + std::to_string(e + 1),
           room.id,
           e,
           area,
           {std::log(std::max(wall.length(), 0.01)), shares.measured,
            error > 0 ? 1.0 : 0.0, error > 0 ? logError(error, usual) : 0,
            thicknesses[r][e] > 0 ? 1.0 : 0.0, std::min(of_wall.off / shares.area, 1.0),
            // It also goes on behind windows up to the ceiling, which are right.
            std::min(of_wall.passed / wall.length(), 1.0) * shares.area / area,
            of_wall.is_in_line ? 1.0 : 0.0}},
          error));
      if (wall.is_confirmed)
        walls.back().within.fill(1);
    }
  return walls;
}

std::vector<Certainty>
certaintyOfOpenings(const Floorplan& plan)
{
  std::vector<double> errors;
  for (const PlanOpening& opening : plan.openings)
    errors.push_back(opening.residual);
  const double usual = usualError(std::move(errors));
  std::vector<Certainty> openings;
  for (std::size_t k = 0; k < plan.openings.size(); ++k) {
    const PlanOpening& opening = plan.openings[k];
    const double sure = std::clamp(opening.confidence, 0.01, 0.999);
    const double error = logError(std::max(opening.residual, 1e-9), usual);
    if (opening.residual > 0 && opening.confidence > 0) {
      openings.push_back(certaintyBy(
          openingWeights(),
          {markOf(opening),
           std::max(opening.rooms[0], opening.rooms[1]),
           k,
           opening.width() * opening.height(),
           {std::log(sure / (1 - sure)), error, opening.walls.size() > 1 ? 1.0 : 0.0,
            opening.kind == OpeningKind::Unknown ? 1.0 : 0.0,
            static_cast<double>(opening.widthError() > 0 &&
                                opening.jambsSeen() == EdgeSeen::Nothing)}}));
      if (opening.is_confirmed)
        openings.back().within.fill(1);
    }
  }
  return openings;
}

namespace {

constexpr double min_room_area = 2;    // square metres
constexpr double min_room_width = 0.8; // metres, of the largest circle in it
constexpr double min_height = 2;       // metres
constexpr double max_height = 6;       // metres
constexpr double max_walls = 8;        // of a room, if they are short:
constexpr double min_mean_wall = 1.25; // metres
constexpr double min_door_width = 0.7; // metres
constexpr double min_storey_area = 5;  // square metres
constexpr double min_noise = 0.005;    // metres
constexpr double in_line = 0.05;       // metres, of what lies on one line
constexpr double worth_word = 0.5;     // metres, of walls and edges
constexpr double most_walled = 0.55;   // of the outline of what stands in a corner

/** @brief Checks whether a door, passage or stair leads into a room. */
bool
hasWayIn(const Floorplan& plan, std::uint32_t room)
{
  const auto leadsIn = [room](const auto& way) {
    return way.rooms[0] == room || way.rooms[1] == room;
  };
  return std::any_of(plan.openings.begin(), plan.openings.end(),
                     [&](const PlanOpening& opening) {
                       return opening.kind != OpeningKind::Window && leadsIn(opening);
                     }) ||
         std::any_of(plan.stairs.begin(), plan.stairs.end(), leadsIn);
}

/** @brief Returns how far the middle of an arc is off its chord, metres. */
double
riseOf(const PlanElement& arc)
{
  return (arc.pointAt(arc.length() / 2) - (arc.start + arc.end) / 2).norm();
}

/** @brief Returns how much of an edge lies on the line of a wall, metres. */
double
lengthAlong(const PlanElement& edge, const PlanElement& wall, bool on_wall)
{
  const double length = wall.length();
  const Eigen::Vector2d along = (wall.end - wall.start) / length;
  const auto placeOf = [&](const Eigen::Vector2d& p) {
    const Eigen::Vector2d d = p - wall.start;
    const double off = along.x() * d.y() - along.y() * d.x();
    return Eigen::Vector2d(along.dot(d), std::abs(off));
  };
  const Eigen::Vector2d a = placeOf(edge.start), b = placeOf(edge.end);
  if (edge.isArc() || wall.isArc() || !(length > 0) || a.y() > in_line ||
      b.y() > in_line)
    return 0;
  const auto [low, high] = std::minmax(a.x(), b.x());
  if (low > length + in_line || high < -in_line)
    return 0; // they do not meet
  const double both = std::max(0.0, std::min(high, length) - std::max(low, 0.0));
  return on_wall ? both : high - low - both;
}

/** @brief Returns how much of an edge lies on the outline of a room, metres. */
double
lengthOnWalls(const PlanElement& edge, const PlanRoom& room)
{
  double length = 0;
  for (const PlanElement& wall : room.boundary.elements)
    length += lengthAlong(edge, wall, true);
  return length;
}

/** @brief Returns for how long edges of soffits go on along the line of a wall where it
 * ends, and no other wall is, metres. */
double
soffitInLine(const PlanRoom& room, const PlanElement& wall)
{
  double length = 0;
  for (const PlanDetail& detail : room.details)
    for (const PlanElement& edge : detail.boundary.elements)
      if (const double beyond = lengthAlong(edge, wall, false); beyond > 0)
        length += beyond - lengthOnWalls(edge, room) + lengthAlong(edge, wall, true);
  return length;
}

/** @brief Returns the share of the outline of a detail that lies at walls. */
double
walledShare(const PlanDetail& detail, const PlanRoom& room)
{
  double walled = 0;
  for (const PlanElement& edge : detail.boundary.elements)
    walled += lengthOnWalls(edge, room);
  return walled / detail.boundary.length();
}

void
addRoom(const Floorplan& plan, const PlanRoom& room, std::vector<PlanWarning>& found)
{
  const TextSpot spot = textSpotIn(room.boundary, room.columns);
  const auto addAt = [&](const Eigen::Vector2d& place, std::size_t wall,
                         WarningKind kind, std::vector<double> values) {
    found.push_back({kind, std::move(values), room.id, wall, {}, place});
  };
  const auto add = [&](WarningKind kind, double value) {
    addAt(spot.place, 0, kind, {value});
  };
  const std::vector<PlanElement>& walls = room.boundary.elements;
  if (!hasWayIn(plan, room.id))
    add(WarningKind::NoDoor, room.area());
  if (room.area() < min_room_area)
    add(WarningKind::SmallRoom, room.area());
  if (2 * spot.radius < min_room_width)
    add(WarningKind::NarrowRoom, 2 * spot.radius);
  const ClearHeight height = clearHeight(room);
  if (height.least < 0)
    addAt(height.lowest, 0, WarningKind::Height, {height.least});
  else if (height.usual < min_height || height.usual > max_height)
    add(WarningKind::Height, height.usual);
  const double mean = room.perimeter() / static_cast<double>(walls.size());
  if (static_cast<double>(walls.size()) > max_walls && mean < min_mean_wall)
    add(WarningKind::ShortWalls, mean);
  for (std::size_t e = 0; e < walls.size(); ++e)
    if (walls[e].isArc() &&
        riseOf(walls[e]) < 2 * std::max(walls[e].residual, min_noise))
      addAt(walls[e].pointAt(walls[e].length() / 2), e + 1, WarningKind::FlatArc,
            {100 * riseOf(walls[e]), walls[e].radius});
    else if (const double edge = soffitInLine(room, walls[e]);
             walls[e].length() >= worth_word && edge >= worth_word)
      addAt(walls[e].pointAt(walls[e].length() / 2), e + 1, WarningKind::InLine,
            {edge});
  for (const PlanDetail& detail : room.floor_details) {
    const Eigen::Vector2d middle = textSpotIn(detail.boundary, {}).place;
    const double rise = detail.slab.heightAt(middle) - room.floor.heightAt(middle);
    if (rise > 0 && walledShare(detail, room) < most_walled)
      addAt(middle, 0, WarningKind::RaisedFloor, {detail.boundary.area(), rise});
  }
}

} // namespace

std::vector<PlanWarning>
unlikelyPlaces(const Floorplan& plan)
{
  std::vector<PlanWarning> found;
  for (const PlanRoom& room : plan.rooms)
    addRoom(plan, room, found);
  for (const PlanOpening& opening : plan.openings)
    if (opening.kind == OpeningKind::Door && opening.width() < min_door_width)
      found.push_back({WarningKind::NarrowDoor,
                       {opening.width()},
                       std::max(opening.rooms[0], opening.rooms[1]),
                       0,
                       {},
                       (opening.start + opening.end) / 2});
  for (const PlanStorey& storey : storeysOf(plan)) {
    const Floorplan part = partOf(plan, storey);
    double area = 0;
    for (const PlanRoom& room : part.rooms)
      area += room.area();
    if (area < min_storey_area)
      found.push_back({WarningKind::SmallStorey,
                       {area},
                       0,
                       0,
                       storey.name,
                       textSpotIn(part.rooms[0].boundary, {}).place});
  }
  std::stable_sort(
      found.begin(), found.end(),
      [](const PlanWarning& a, const PlanWarning& b) { return a.kind < b.kind; });
  return found;
}

} // namespace pcl::sedr
