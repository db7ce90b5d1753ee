// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_filters/floorplan_io.h>

#include "number_text.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace pcl {
namespace sedr {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format_name = "sedr-floorplan";
constexpr int format_version = 1;

Json
toJson(const Eigen::Vector2d& p)
{
  return Json::array({p.x(), p.y()});
}

/** @brief Limits of what is read: beyond them no room was ever scanned, and double
 * precision, grids and files of single precision lose the millimetres. Metres. */
constexpr double most_coordinate = 1e6;
constexpr double most_radius = 1e5;
constexpr double most_gap_of_arc = 1e-3; ///< of an arc's ends from its circle
constexpr double least_upward =
    0.7; ///< c of a floor or ceiling: at most 45 degrees of slope

Eigen::Vector2d
pointFrom(const Json& json)
{
  if (json.size() != 2)
    throw std::invalid_argument("a point has 2 coordinates, not " +
                                std::to_string(json.size()));
  const Eigen::Vector2d p(json.at(0).get<double>(), json.at(1).get<double>());
  for (const double coordinate : p)
    if (!(std::abs(coordinate) <= most_coordinate))
      throw std::invalid_argument("a coordinate must lie within " +
                                  numberText(most_coordinate) + " m, it is " +
                                  numberText(coordinate));
  return p;
}

Json
toJson(const PlanElement& e)
{
  Json json{{"type", e.isArc() ? "arc" : "segment"},
            {"start", toJson(e.start)},
            {"end", toJson(e.end)}};
  if (e.isArc()) {
    json["centre"] = toJson(e.centre);
    json["radius"] = e.radius;
    json["counter_clockwise"] = e.counter_clockwise;
  }
  json["inliers"] = e.inliers;
  json["residual"] = e.residual;
  return json;
}

/** @brief Throws where start and end of an arc are not on its circle. */
void
checkArc(const PlanElement& e)
{
  if (!(e.radius > 0 && e.radius <= most_radius))
    throw std::invalid_argument("the radius of an arc must be above 0 m and at most " +
                                numberText(most_radius) + " m, it is " +
                                numberText(e.radius));
  for (const Eigen::Vector2d& end : {e.start, e.end}) {
    const double gap = std::abs((end - e.centre).norm() - e.radius);
    if (!(gap <= most_gap_of_arc))
      throw std::invalid_argument("an end of an arc must lie on its circle, it is " +
                                  numberText(gap) + " m off");
  }
}

PlanElement
elementFrom(const Json& json)
{
  PlanElement e;
  e.start = pointFrom(json.at("start"));
  e.end = pointFrom(json.at("end"));
  const auto type = json.at("type").get<std::string>();
  if (type != "segment" && type != "arc")
    throw std::invalid_argument("an element is a segment or an arc, not a " + type);
  if (type == "arc") {
    e.centre = pointFrom(json.at("centre"));
    e.radius = json.at("radius").get<double>();
    e.counter_clockwise = json.at("counter_clockwise").get<bool>();
    checkArc(e);
  }
  e.inliers = json.at("inliers").get<std::size_t>();
  e.residual = json.at("residual").get<double>();
  return e;
}

Json
toJson(const PlanLoop& loop)
{
  Json json = Json::array();
  for (const auto& e : loop.elements)
    json.push_back(toJson(e));
  return json;
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
      throw std::invalid_argument("a loop is open by " + std::to_string(gap) +
                                  " m after element " + std::to_string(i));
  }
  if (loop.elements.empty())
    throw std::invalid_argument("a loop has no elements");
  return loop;
}

/** @brief A loop that must run counter-clockwise around some area. */
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

Json
loopsToJson(const std::vector<PlanLoop>& loops)
{
  Json json = Json::array();
  for (const auto& loop : loops)
    json.push_back(toJson(loop));
  return json;
}

std::vector<PlanLoop>
loopsFrom(const Json& json)
{
  std::vector<PlanLoop> loops;
  for (const auto& loop : json)
    loops.push_back(loopFrom(loop));
  return loops;
}

Json
toJson(const PlanSlab& slab)
{
  return {{"plane", {slab.plane[0], slab.plane[1], slab.plane[2], slab.plane[3]}},
          {"inliers", slab.inliers},
          {"residual", slab.residual}};
}

/** @brief Brings a normal that was rounded to unit length, and leaves one that was not
 * as it is. Throws where the plane is none of a floor or ceiling. */
void
makeUpward(Eigen::Vector4d& plane)
{
  const double length = plane.head<3>().norm();
  if (!(std::abs(length - 1) <= 1e-3))
    throw std::invalid_argument(
        "the normal of a floor or ceiling must have length 1, it has " +
        numberText(length));
  if (!(plane[2] >= least_upward * length))
    throw std::invalid_argument(
        "the plane of a floor or ceiling must face up, its c is " +
        numberText(plane[2]) + ", at least " + numberText(least_upward) + " is needed");
  // Of a place whose coordinates are within the limit: sqrt(3) times it.
  if (!(std::abs(plane[3]) <= 2 * most_coordinate))
    throw std::invalid_argument("the d of a floor or ceiling must lie within " +
                                numberText(2 * most_coordinate) + " m, it is " +
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
  return slab;
}

Json
detailsToJson(const std::vector<PlanDetail>& details)
{
  Json json = Json::array();
  for (const auto& detail : details)
    json.push_back({{"slab", toJson(detail.slab)},
                    {"boundary", toJson(detail.boundary)},
                    {"holes", loopsToJson(detail.holes)}});
  return json;
}

std::vector<PlanDetail>
detailsFrom(const Json& json)
{
  std::vector<PlanDetail> details;
  for (const auto& d : json) {
    PlanDetail detail;
    detail.slab = slabFrom(d.at("slab"));
    detail.boundary = outerLoopFrom(d.at("boundary"));
    detail.holes = loopsFrom(d.at("holes"));
    details.push_back(std::move(detail));
  }
  return details;
}

Json
toJson(const PlanRoom& room)
{
  Json niches = Json::array();
  for (const auto& niche : room.niches)
    niches.push_back({{"bottom", toJson(niche.bottom)},
                      {"top", toJson(niche.top)},
                      {"boundary", toJson(niche.boundary)}});
  return {{"id", room.id},
          {"area", room.area()},
          {"perimeter", room.perimeter()},
          {"floor", toJson(room.floor)},
          {"ceiling", toJson(room.ceiling)},
          {"boundary", toJson(room.boundary)},
          {"columns", loopsToJson(room.columns)},
          {"details", detailsToJson(room.details)},
          {"floor_details", detailsToJson(room.floor_details)},
          {"niches", niches}};
}

/** @brief The id of a room, which none of `rooms` may have. */
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
  room.columns = loopsFrom(json.at("columns"));
  room.details = detailsFrom(json.at("details"));
  // Files of before there were these do not have them.
  if (json.contains("floor_details"))
    room.floor_details = detailsFrom(json.at("floor_details"));
  if (json.contains("niches"))
    for (const auto& n : json.at("niches"))
      room.niches.push_back({outerLoopFrom(n.at("boundary")), slabFrom(n.at("bottom")),
                             slabFrom(n.at("top"))});
  return room;
}

} // namespace

std::string
floorplanToJson(const Floorplan& plan)
{
  Json rooms = Json::array();
  for (const auto& room : plan.rooms)
    rooms.push_back(toJson(room));
  const Json json{{"format", format_name},
                  {"version", format_version},
                  {"unit", "m"},
                  {"rooms", rooms}};
  return json.dump(1) + "\n";
}

Floorplan
floorplanFromJson(const std::string& text, std::string& problem)
{
  problem.clear();
  Floorplan plan;
  try {
    const Json json = Json::parse(text);
    if (json.at("format") != format_name)
      throw std::invalid_argument("it is not a floor plan");
    if (json.at("version") != format_version)
      throw std::invalid_argument("it has version " + json.at("version").dump() +
                                  ", version " + std::to_string(format_version) +
                                  " can be read");
    for (const auto& room : json.at("rooms"))
      plan.rooms.push_back(roomFrom(room, plan.rooms));
  }
  catch (const std::exception& error) {
    problem = std::string("the floor plan cannot be read: ") + error.what();
    plan.rooms.clear();
  }
  return plan;
}

} // namespace sedr
} // namespace pcl
