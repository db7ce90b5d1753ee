// SPDX-License-Identifier: BSD-3-Clause
#include "../base/number_text.h"
#include "../plan/plan_geometry.h"
#include "floorplan_format.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace pcl::sedr {

using Json = nlohmann::ordered_json;

std::uint32_t
wholeFrom(const Json& json, std::uint32_t least, const char* what)
{
  constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
  if (!json.is_number_unsigned() || json.get<std::uint64_t>() < least ||
      json.get<std::uint64_t>() > most)
    throw std::invalid_argument(std::string(what) + " is a whole number from " +
                                std::to_string(least) + " to " + std::to_string(most) +
                                ", not " + json.dump());
  return json.get<std::uint32_t>();
}

void
PartFields::whole(const char* name,
                  std::uint32_t& value,
                  std::uint32_t least,
                  const char* what)
{
  if (areRead() && in_->contains(name))
    value = wholeFrom(in_->at(name), least, what);
  told(name, value);
}

void
PartFields::edges(std::array<OpeningEdge, 4>& edges)
{
  const auto isKnown = [](const OpeningEdge& edge) {
    return edge.error > 0 || edge.seen != EdgeSeen::Nothing;
  };
  if (areRead() && in_->contains("edges"))
    if (const Json& list = in_->at("edges"); !list.is_array() || list.size() != 4)
      throw std::invalid_argument(
          "an opening has 4 edges, not " +
          (list.is_array() ? std::to_string(list.size()) : list.dump()));
  optional("edges", edges, std::any_of(edges.begin(), edges.end(), isKnown));
}

void
PartFields::rooms(std::vector<std::uint32_t>& ids)
{
  told("rooms", ids);
  if (areRead())
    for (const Json& id : in_->at("rooms"))
      ids.push_back(wholeFrom(id, 1, "the id of a room"));
}

void
PartFields::rooms(std::array<std::uint32_t, 2>& ids, const std::string& of_what)
{
  told("rooms", ids);
  if (!areRead())
    return;
  const Json& rooms = in_->at("rooms");
  if (!rooms.is_array() || rooms.size() != 2)
    throw std::invalid_argument(of_what + " has 2 rooms, not " + rooms.dump());
  for (std::size_t k = 0; k < 2; ++k)
    ids[k] = wholeFrom(rooms[k], 0, "the id of a room");
}

namespace {

constexpr double degrees = 180 / M_PI;

// In the order of their enumerations.
constexpr std::array<const char*, 4> kinds{"unknown", "door", "window", "passage"};
constexpr std::array<const char*, 4> hinges{"unknown", "start", "end", "both"};
constexpr std::array<const char*, 4> states{"unknown", "closed", "ajar", "open"};
constexpr std::array<const char*, 4> edges_seen{"nothing", "leaf", "rim", "reveal"};
constexpr std::array<const char*, 3> curves{"cylinder", "ellipsoid", "relief"};

/** @brief A property of an opening with names, or of an edge of one.
 * @param refusal of another name */
template <typename Enum>
void
describeName(PartFields& fields,
             const char* what,
             const std::array<const char*, 4>& names,
             Enum& value,
             const std::string& refusal = {})
{
  std::string name = names[static_cast<std::size_t>(value)];
  fields.optional(what, name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw std::invalid_argument(
        (refusal.empty() ? std::string("the ") + what + " of an opening is not known:"
                         : refusal) +
        " " + nlohmann::json(name).dump());
  value = static_cast<Enum>(found - names.begin());
}

} // namespace

// Elements and loops.

void
describe(PartFields& fields, ElementEvidence& evidence)
{
  fields.needed("seen", evidence.seen);
  fields.needed("hidden", evidence.hidden);
  fields.needed("opening", evidence.opening);
}

void
describe(PartFields& fields, SurfaceAccuracy& accuracy)
{
  fields.optional("standard_error", accuracy.standard_error);
  fields.optional("deviation_95", accuracy.deviation_95);
}

void
describe(PartFields& fields, PlanElement& e)
{
  std::string type = e.isArc() ? "arc" : "segment";
  fields.needed("type", type);
  fields.needed("start", e.start);
  fields.needed("end", e.end);
  if (type != "segment" && type != "arc")
    throw std::invalid_argument("an element is a segment or an arc, not a " + type);
  if (type == "arc") {
    fields.needed("centre", e.centre);
    fields.needed("radius", e.radius);
    fields.needed("counter_clockwise", e.counter_clockwise);
    if (!(e.radius > 0))
      throw std::invalid_argument("the radius of an arc must be above 0 m, it is " +
                                  numberText(e.radius));
  }
  fields.optional("inliers", e.inliers);
  fields.optional("residual", e.residual);
  fields.optional("evidence", e.evidence, e.evidence.isKnown());
  fields.optional("accuracy", e.accuracy, e.accuracy.isKnown());
  double tilt = e.tilt * degrees;
  fields.optional("tilt", tilt, tilt != 0);
  fields.optional("confirmed", e.is_confirmed, e.is_confirmed);
  e.tilt = tilt / degrees;
}

void
to_json(Json& json, const PlanLoop& loop)
{
  json = loop.elements;
}

void
from_json(const Json& json, PlanLoop& loop)
{
  json.get_to(loop.elements);
}

// Floors, ceilings and their parts.

void
describe(PartFields& fields, PlanSlab& slab)
{
  fields.needed("plane", slab.plane);
  fields.optional("inliers", slab.inliers);
  fields.optional("residual", slab.residual);
  fields.optional("inferred", slab.inferred, slab.inferred > 0);
  fields.optional("accuracy", slab.accuracy, slab.accuracy.isKnown());
  // A normal that was rounded; planProblem() refuses one that is no unit vector.
  const double error = std::abs(slab.plane.head<3>().norm() - 1);
  if (fields.areRead() && error > 1e-9 && error <= 1e-3)
    slab.plane /= slab.plane.head<3>().norm();
  SlabCurve curve = slab.curve ? *slab.curve : SlabCurve();
  std::string type =
      slab.curve ? curves.at(static_cast<std::size_t>(curve.kind)) : "plane";
  fields.optional("type", type, slab.curve != nullptr);
  if (type == "plane")
    return;
  const auto kind = std::find(curves.begin(), curves.end(), type);
  if (kind == curves.end())
    throw std::invalid_argument(
        "a facet is a plane, a cylinder, an ellipsoid or a relief, not a " + type);
  curve.kind = static_cast<CurveKind>(kind - curves.begin());
  fields.needed("centre", curve.centre);
  if (curve.kind == CurveKind::Relief) {
    fields.optional("axis", curve.axis); // old reliefs lie along x
    fields.needed("spacing", curve.spacing);
    fields.needed("columns", curve.columns);
    fields.needed("heights", curve.heights);
  }
  else {
    fields.needed("axis", curve.axis);
    fields.needed("base", curve.base);
    if (curve.kind == CurveKind::Ellipsoid)
      fields.needed("along", curve.along);
    fields.needed("across", curve.across);
    fields.needed("up", curve.up);
  }
  slab.curve = std::make_shared<const SlabCurve>(std::move(curve));
}

Json
facetToJson(const PlanSlab& slab)
{
  Json json = slab;
  if (!slab.curve)
    json["type"] = "plane";
  json["inferred"] = slab.inferred;
  return json;
}

void
describe(PartFields& fields, PlanDetail& detail)
{
  fields.needed("slab", detail.slab);
  fields.needed("boundary", detail.boundary);
  fields.optional("holes", detail.holes);
}

void
describe(PartFields& fields, PlanNiche& niche)
{
  fields.needed("bottom", niche.bottom);
  fields.needed("top", niche.top);
  fields.needed("boundary", niche.boundary);
}

// Openings.

const char*
nameOf(OpeningKind kind)
{
  return kinds[static_cast<std::size_t>(kind)];
}

std::string
markOf(const PlanOpening& opening)
{
  constexpr char letters[] = "ODWP"; // in the order of OpeningKind
  return letters[static_cast<std::size_t>(opening.kind)] +
         std::to_string(opening.number);
}

void
describe(PartFields& fields, OpeningWall& wall)
{
  fields.needed("room", wall.room);
  fields.needed("element", wall.element);
}

void
describe(PartFields& fields, OpeningEdge& edge)
{
  describeName(fields, "seen", edges_seen, edge.seen,
               "an edge of an opening is seen by nothing, leaf, rim or reveal, not by");
  fields.optional("error", edge.error);
}

void
describe(PartFields& fields, PlanOpening& opening)
{
  Json head{{"shape", opening.rise > 0 ? "arched" : "flat"}};
  if (opening.rise > 0)
    head["rise"] = opening.rise;
  describeName(fields, "kind", kinds, opening.kind);
  fields.whole("number", opening.number, 0, "the number of an opening");
  fields.needed("rooms", opening.rooms);
  fields.optional("walls", opening.walls);
  fields.needed("start", opening.start);
  fields.needed("end", opening.end);
  fields.needed("bottom", opening.bottom);
  fields.needed("top", opening.top);
  fields.told("width", opening.width());
  fields.told("height", opening.height());
  fields.optional("head", head);
  opening.rise = head.value("rise", 0.0);
  fields.optional("depth", opening.depth);
  describeName(fields, "hinge", hinges, opening.hinge);
  fields.optional("swing", opening.swing);
  describeName(fields, "state", states, opening.state);
  fields.optional("confidence", opening.confidence);
  fields.optional("residual", opening.residual);
  fields.optional("deviation_95", opening.deviation_95, opening.deviation_95 > 0);
  fields.edges(opening.edges);
  fields.optional("confirmed", opening.is_confirmed, opening.is_confirmed);
}

// Storeys and stairs.

void
describe(PartFields& fields, PlanStorey& storey)
{
  fields.whole("number", storey.number, 1, "the number of a storey");
  if (fields.areRead())
    storey.name = storeyName(storey.number);
  fields.optional("name", storey.name);
  fields.optional("floor", storey.floor);
  fields.optional("ceiling", storey.ceiling);
  fields.rooms(storey.rooms);
  if (fields.areRead())
    std::sort(storey.rooms.begin(), storey.rooms.end());
}

void
describe(PartFields& fields, PlanStair& stair)
{
  fields.rooms(stair.rooms, "a stair");
  fields.needed("at", stair.at);
  fields.needed("bottom", stair.bottom);
  fields.needed("top", stair.top);
  fields.optional("flights", stair.flights, !stair.flights.empty());
}

void
describe(PartFields& fields, PlanFlight& flight)
{
  fields.told("steps", flight.steps());
  fields.needed("rise", flight.rise);
  fields.told("going", flight.going());
  fields.needed("bottom", flight.bottom);
  fields.told("top", flight.top());
  fields.told("outline", flight.outline());
  fields.needed("risers", flight.risers);
}

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

} // namespace pcl::sedr
