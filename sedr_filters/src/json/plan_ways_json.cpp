// SPDX-License-Identifier: BSD-3-Clause
// Stairs, and the doorways of earlier versions.
#include "floorplan_format.h"

#include "../plan/opening_wall.h"
#include <pcl/sedr_filters/plan_opening.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace pcl::sedr {

using Json = nlohmann::ordered_json;

namespace {

/** @brief Reads rooms and heights of a stair, or of a doorway of versions 1 and 2. */
template <typename Way>
void
readWay(const Json& json, const std::string& what, Way& way)
{
  const Json& rooms = json.at("rooms");
  if (!rooms.is_array() || rooms.size() != 2)
    throw std::invalid_argument(what + " has 2 rooms, not " + rooms.dump());
  const std::vector<std::uint32_t> ids = roomsFrom(rooms, 0);
  std::copy(ids.begin(), ids.end(), way.rooms.begin());
  json.at("bottom").get_to(way.bottom);
  json.at("top").get_to(way.top);
}

/** @brief Fits an opening between the faces of its rooms: finds its walls, its depth
 * and the middle of the wall, and puts its first room to its left. With one face it is
 * as deep behind its ends as towards the face. */
void
fitBetweenFaces(const Floorplan& plan, PlanOpening& opening)
{
  const PlanElement* faces[2] = {};
  for (std::size_t k = 0; k < 2; ++k)
    if (const PlanRoom* const room = findRoom(plan, opening.rooms[k]))
      if (const auto wall = wallBeside(*room, opening)) {
        opening.walls.push_back({room->id, *wall});
        faces[k] = &room->boundary.elements[*wall];
      }
  if (opening.walls.empty())
    return;
  const std::size_t k = faces[0] ? 0 : 1;
  const PlanElement& near = *faces[k];
  const PlanElement* const far = faces[1 - k];
  const auto onto = [](const PlanElement& face, const Eigen::Vector2d& p) {
    return face.pointAt(face.project(p));
  };
  const Eigen::Vector2d middle = (opening.start + opening.end) / 2;
  const Eigen::Vector2d inwards = near.normalAt(near.project(middle));
  PlanOpening fitted = opening;
  for (Eigen::Vector2d* const end : {&fitted.start, &fitted.end}) {
    const Eigen::Vector2d here = onto(near, far ? onto(*far, *end) : *end);
    const Eigen::Vector2d there = far ? onto(*far, here) : 2 * *end - here;
    *end = (here + there) / 2;
    fitted.depth += (here - there).norm() / 2;
  }
  if (fitted.width() > 0)
    opening = fitted;
  const Eigen::Vector2d way = opening.end - opening.start;
  const bool is_left = way.x() * inwards.y() - way.y() * inwards.x() > 0;
  if (is_left != (k == 0))
    std::swap(opening.start, opening.end);
}

} // namespace

Json
stairsToJson(const Floorplan& plan)
{
  Json json = Json::array();
  for (PlanStair stair : plan.stairs) {
    for (std::uint32_t& id : stair.rooms)
      if (!findRoom(plan, id))
        id = 0;
    if (stair.leadsSomewhere())
      json.push_back(stair);
  }
  return json;
}

void
to_json(Json& json, const PlanStair& stair)
{
  json = {{"rooms", stair.rooms},
          {"at", stair.at},
          {"bottom", stair.bottom},
          {"top", stair.top}};
  if (!stair.flights.empty())
    json["flights"] = stair.flights;
}

void
to_json(Json& json, const PlanFlight& flight)
{
  json = {{"steps", flight.steps()}, {"rise", flight.rise},
          {"going", flight.going()}, {"bottom", flight.bottom},
          {"top", flight.top()},     {"outline", flight.outline()},
          {"risers", flight.risers}};
}

void
from_json(const Json& json, PlanStair& stair)
{
  readWay(json, "a stair", stair);
  json.at("at").get_to(stair.at);
  readIfThere(json, "flights", stair.flights);
}

void
from_json(const Json& json, PlanFlight& flight)
{
  json.at("risers").get_to(flight.risers);
  json.at("bottom").get_to(flight.bottom);
  json.at("rise").get_to(flight.rise);
}

void
addDoorways(const Json& json, Floorplan& plan)
{
  const std::vector<PlanOpening> openings = plan.openings;
  for (const Json& entry : json) {
    PlanOpening doorway;
    readWay(entry, "a doorway", doorway);
    entry.at("start").get_to(doorway.start);
    entry.at("end").get_to(doorway.end);
    const Eigen::Vector2d middle = (doorway.start + doorway.end) / 2;
    if (!(doorway.width() > 0) || doorway.height() == 0 ||
        std::any_of(openings.begin(), openings.end(), [&](const PlanOpening& opening) {
          return isAt(opening, middle, doorway.bottom, doorway.top);
        }))
      continue;
    fitBetweenFaces(plan, doorway);
    plan.openings.push_back(doorway);
  }
}

} // namespace pcl::sedr
