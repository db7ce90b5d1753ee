// SPDX-License-Identifier: BSD-3-Clause
#include "floorplan_format.h"

#include "../base/number_text.h"
#include "level_planes.h"
#include <pcl/sedr_filters/floorplan_io.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace pcl::sedr {

namespace {

using Json = nlohmann::ordered_json;

/** @brief Limits of values that are read, metres. */
constexpr double max_radius = 1e5;
constexpr double max_gap_of_arc = 1e-3; ///< of an arc's ends from its circle

/** @brief Reads the shares of an element, if there are any. */
ElementEvidence
evidenceFrom(const Json& json)
{
  ElementEvidence evidence;
  for (const auto& [name, share] : {std::make_pair("seen", &evidence.seen),
                                    std::make_pair("hidden", &evidence.hidden),
                                    std::make_pair("opening", &evidence.opening)}) {
    *share = json.at(name).get<double>();
    if (!(*share >= 0 && *share <= 1))
      throw std::invalid_argument(std::string("the share ") + name +
                                  " of an element lies from 0 to 1, it is " +
                                  numberText(*share));
  }
  return evidence;
}

/** @brief Throws if start or end of an arc are not on its circle. */
void
checkArc(const PlanElement& e)
{
  if (!(e.radius > 0 && e.radius <= max_radius))
    throw std::invalid_argument("the radius of an arc must be above 0 m and at most " +
                                numberText(max_radius) + " m, it is " +
                                numberText(e.radius));
  for (const Eigen::Vector2d& end : {e.start, e.end}) {
    const double gap = std::abs((end - e.centre).norm() - e.radius);
    if (!(gap <= max_gap_of_arc))
      throw std::invalid_argument("an end of an arc must lie on its circle, it is " +
                                  numberText(gap) + " m off");
  }
}

PlanElement
elementFrom(const Json& json)
{
  PlanElement e;
  e.start = pointFromJson(json.at("start"));
  e.end = pointFromJson(json.at("end"));
  const auto type = json.at("type").get<std::string>();
  if (type != "segment" && type != "arc")
    throw std::invalid_argument("an element is a segment or an arc, not a " + type);
  if (type == "arc") {
    e.centre = pointFromJson(json.at("centre"));
    e.radius = json.at("radius").get<double>();
    e.counter_clockwise = json.at("counter_clockwise").get<bool>();
    checkArc(e);
  }
  e.inliers = json.at("inliers").get<std::size_t>();
  e.residual = json.at("residual").get<double>();
  if (json.contains("evidence"))
    e.evidence = evidenceFrom(json.at("evidence"));
  return e;
}

PlanLoop
loopFrom(const Json& json)
{
  PlanLoop loop;
  for (const auto& e : json)
    loop.elements.push_back(elementFrom(e));
  for (std::size_t i = 0; i < loop.elements.size(); ++i) {
    const auto& next = loop.elements[(i + 1) % loop.elements.size()];
    const double gap = (loop.elements[i].end - next.start).norm();
    if (!(gap < 1e-6))
      throw std::invalid_argument("a loop is open by " + numberText(gap) +
                                  " m after element " + std::to_string(i));
  }
  if (loop.elements.empty())
    throw std::invalid_argument("a loop has no elements");
  return loop;
}

/** @brief Reads a loop that must run counter-clockwise and enclose an area. */
PlanLoop
outerLoopFrom(const Json& json)
{
  PlanLoop loop = loopFrom(json);
  const double area = loop.area();
  if (!(area > 0))
    throw std::invalid_argument(
        "a boundary must run counter-clockwise around an area above 0 m2, it is " +
        numberText(area) + " m2");
  return loop;
}

/** @brief Reads the loops of columns or holes, which must run clockwise. */
std::vector<PlanLoop>
innerLoopsFrom(const Json& json)
{
  std::vector<PlanLoop> loops;
  for (const auto& inner : json) {
    loops.push_back(loopFrom(inner));
    const double area = loops.back().area();
    if (!(area < 0))
      throw std::invalid_argument(
          "a column or hole must run clockwise around an area, it is " +
          numberText(area) + " m2");
  }
  return loops;
}

/** @brief Normalises a normal that was rounded; one of exact unit length is not
 * changed. Throws if the plane cannot be a floor or ceiling. */
void
makeUpward(Eigen::Vector4d& plane)
{
  const double length = plane.head<3>().norm();
  if (!(std::abs(length - 1) <= 1e-3))
    throw std::invalid_argument(
        "the normal of a floor or ceiling must have length 1, it has " +
        numberText(length));
  if (!(plane[2] >= min_upward * length))
    throw std::invalid_argument(
        "the plane of a floor or ceiling must face up, its c is " +
        numberText(plane[2]) + ", at least " + numberText(min_upward) + " is needed");
  // Bound for a place whose coordinates are within the limit: sqrt(3) times the limit.
  if (!(std::abs(plane[3]) <= 2 * max_coordinate))
    throw std::invalid_argument("the d of a floor or ceiling must lie within " +
                                numberText(2 * max_coordinate) + " m, it is " +
                                numberText(plane[3]));
  if (std::abs(length - 1) > 1e-9)
    plane /= length;
}

PlanSlab
slabFrom(const Json& json)
{
  PlanSlab slab;
  for (std::size_t k = 0; k < 4; ++k)
    slab.plane[static_cast<Eigen::Index>(k)] = json.at("plane").at(k).get<double>();
  makeUpward(slab.plane);
  slab.inliers = json.at("inliers").get<std::size_t>();
  slab.residual = json.at("residual").get<double>();
  readCurve(json, slab);
  return slab;
}

std::vector<PlanDetail>
detailsFrom(const Json& json, bool are_facets = false)
{
  std::vector<PlanDetail> details;
  for (const auto& d : json) {
    PlanDetail detail;
    detail.is_facet = are_facets;
    detail.slab = slabFrom(d.at("slab"));
    detail.boundary = outerLoopFrom(d.at("boundary"));
    detail.holes = innerLoopsFrom(d.at("holes"));
    details.push_back(std::move(detail));
  }
  return details;
}

/** @brief Reads the id of a room, which must not occur in `rooms`. */
std::uint32_t
idFrom(const Json& json, const std::vector<PlanRoom>& rooms)
{
  constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
  if (!json.is_number_unsigned() || json.get<std::uint64_t>() == 0 ||
      json.get<std::uint64_t>() > most)
    throw std::invalid_argument("the id of a room is a whole number from 1 to " +
                                std::to_string(most) + ", not " + json.dump());
  const auto id = json.get<std::uint32_t>();
  for (const auto& room : rooms)
    if (room.id == id)
      throw std::invalid_argument("two rooms have the id " + std::to_string(id));
  return id;
}

PlanRoom
roomFrom(const Json& json, const std::vector<PlanRoom>& rooms)
{
  PlanRoom room;
  room.id = idFrom(json.at("id"), rooms);
  room.floor = slabFrom(json.at("floor"));
  room.ceiling = slabFrom(json.at("ceiling"));
  room.boundary = outerLoopFrom(json.at("boundary"));
  room.columns = innerLoopsFrom(json.at("columns"));
  if (json.contains("facets"))
    room.details = detailsFrom(json.at("facets"), true);
  for (PlanDetail& detail : detailsFrom(json.at("details")))
    room.details.push_back(std::move(detail));
  // Older files do not have these.
  if (json.contains("floor_details"))
    room.floor_details = detailsFrom(json.at("floor_details"));
  if (json.contains("niches"))
    for (const auto& n : json.at("niches"))
      room.niches.push_back({outerLoopFrom(n.at("boundary")), slabFrom(n.at("bottom")),
                             slabFrom(n.at("top"))});
  return room;
}

} // namespace

Eigen::Vector2d
pointFromJson(const nlohmann::ordered_json& json)
{
  if (json.size() != 2)
    throw std::invalid_argument("a point has 2 coordinates, not " +
                                std::to_string(json.size()));
  const Eigen::Vector2d p(json.at(0).get<double>(), json.at(1).get<double>());
  for (const double coordinate : p)
    if (!(std::abs(coordinate) <= max_coordinate))
      throw std::invalid_argument("a coordinate must lie within " +
                                  numberText(max_coordinate) + " m, it is " +
                                  numberText(coordinate));
  return p;
}

Floorplan
floorplanFromJson(const std::string& text, std::string& problem)
{
  problem.clear();
  Floorplan plan;
  try {
    const Json json = Json::parse(text);
    if (json.at("format") != floorplan_format_name)
      throw std::invalid_argument("it is not a floor plan");
    if (json.at("version") != floorplan_format_version &&
        json.at("version") != floorplan_facets_version)
      throw std::invalid_argument(
          "it has version " + json.at("version").dump() + ", versions " +
          std::to_string(floorplan_format_version) + " and " +
          std::to_string(floorplan_facets_version) + " can be read");
    for (const auto& room : json.at("rooms"))
      plan.rooms.push_back(roomFrom(room, plan.rooms));
    readStoreys(json, plan);
  }
  catch (const std::exception& error) {
    problem = std::string("the floor plan cannot be read: ") + error.what();
    plan = {};
  }
  return plan;
}

bool
originFromJson(const std::string& text, Origin& origin)
{
  return readOrigin(Json::parse(text, nullptr, false), origin);
}

double
maxWallFromJson(const std::string& text, std::string& problem)
{
  problem.clear();
  Priors priors;
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("max_wall"))
    return priors.max_wall;
  const Json& stated = json["max_wall"];
  problem = stated.is_number()
                ? setPrior("max_wall", stated.get<double>(), priors)
                : "the max_wall must be a number, it is " + stated.dump();
  return priors.max_wall;
}

bool
readOrigin(const Json& json, Origin& origin)
{
  origin = {};
  if (!json.is_object() || !json.contains("origin"))
    return true;
  const Json& place = json["origin"];
  if (!place.is_array() || place.size() != 3)
    return false;
  Origin read;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!place[axis].is_number())
      return false;
    read.place[static_cast<Eigen::Index>(axis)] = place[axis].get<double>();
  }
  origin = read;
  return true;
}

} // namespace pcl::sedr
