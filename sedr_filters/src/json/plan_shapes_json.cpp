// SPDX-License-Identifier: BSD-3-Clause
#include "../base/number_text.h"
#include "floorplan_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

namespace pcl::sedr {
namespace {

using Json = nlohmann::ordered_json;

constexpr double degrees = 180 / M_PI;

// In the order of their enumerations.
constexpr std::array<const char*, 4> kinds{"unknown", "door", "window", "passage"};
constexpr std::array<const char*, 4> hinges{"unknown", "start", "end", "both"};
constexpr std::array<const char*, 4> states{"unknown", "closed", "ajar", "open"};

template <typename Enum, std::size_t n>
void
readName(const Json& json,
         const char* what,
         const std::array<const char*, n>& names,
         Enum& value)
{
  if (!json.contains(what))
    return;
  const auto found = std::find(names.begin(), names.end(), json.at(what));
  if (found == names.end())
    throw std::invalid_argument(std::string("the ") + what +
                                " of an opening is not known: " + json.at(what).dump());
  value = static_cast<Enum>(found - names.begin());
}

/** @brief Writes the accuracy of a surface as a member of it, if it is known. */
void
accuracyToJson(const SurfaceAccuracy& accuracy, Json& surface)
{
  if (accuracy.isKnown())
    surface["accuracy"] = {{"standard_error", accuracy.standard_error},
                           {"deviation_95", accuracy.deviation_95}};
}

SurfaceAccuracy
accuracyFrom(const Json& surface)
{
  const Json accuracy = surface.value("accuracy", Json::object());
  return {accuracy.value("standard_error", 0.0), accuracy.value("deviation_95", 0.0)};
}

} // namespace

using Json = nlohmann::ordered_json;

// Elements and loops.

void
to_json(Json& json, const PlanElement& e)
{
  json = {{"type", e.isArc() ? "arc" : "segment"}, {"start", e.start}, {"end", e.end}};
  if (e.isArc()) {
    json["centre"] = e.centre;
    json["radius"] = e.radius;
    json["counter_clockwise"] = e.counter_clockwise;
  }
  json["inliers"] = e.inliers;
  json["residual"] = e.residual;
  if (e.evidence.isKnown())
    json["evidence"] = {{"seen", e.evidence.seen},
                        {"hidden", e.evidence.hidden},
                        {"opening", e.evidence.opening}};
  accuracyToJson(e.accuracy, json);
  if (e.tilt != 0)
    json["tilt"] = e.tilt * degrees;
}

void
from_json(const Json& json, PlanElement& e)
{
  json.at("start").get_to(e.start);
  json.at("end").get_to(e.end);
  const auto type = json.at("type").get<std::string>();
  if (type != "segment" && type != "arc")
    throw std::invalid_argument("an element is a segment or an arc, not a " + type);
  if (type == "arc") {
    json.at("centre").get_to(e.centre);
    json.at("radius").get_to(e.radius);
    json.at("counter_clockwise").get_to(e.counter_clockwise);
    if (!(e.radius > 0))
      throw std::invalid_argument("the radius of an arc must be above 0 m, it is " +
                                  numberText(e.radius));
  }
  readIfThere(json, "inliers", e.inliers);
  readIfThere(json, "residual", e.residual);
  if (json.contains("evidence")) {
    const Json& evidence = json.at("evidence");
    evidence.at("seen").get_to(e.evidence.seen);
    evidence.at("hidden").get_to(e.evidence.hidden);
    evidence.at("opening").get_to(e.evidence.opening);
  }
  e.accuracy = accuracyFrom(json);
  e.tilt = json.value("tilt", 0.0) / degrees;
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
to_json(Json& json, const PlanSlab& slab)
{
  json = {{"plane", slab.plane},
          {"inliers", slab.inliers},
          {"residual", slab.residual}};
  if (slab.inferred > 0)
    json["inferred"] = slab.inferred;
  accuracyToJson(slab.accuracy, json);
  if (!slab.curve)
    return;
  constexpr std::array<const char*, 3> names{"cylinder", "ellipsoid", "relief"};
  const SlabCurve& curve = *slab.curve;
  json["type"] = names.at(static_cast<std::size_t>(curve.kind));
  json["centre"] = curve.centre;
  json["axis"] = curve.axis;
  if (curve.kind == CurveKind::Relief) {
    json["spacing"] = curve.spacing;
    json["columns"] = curve.columns;
    json["heights"] = curve.heights;
    return;
  }
  json["base"] = curve.base;
  if (curve.kind == CurveKind::Ellipsoid)
    json["along"] = curve.along;
  json["across"] = curve.across;
  json["up"] = curve.up;
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

namespace {

std::shared_ptr<const SlabCurve>
curveFrom(const Json& json, const std::string& type)
{
  auto curve = std::make_shared<SlabCurve>();
  json.at("centre").get_to(curve->centre);
  if (type != "relief" || json.contains("axis")) // old reliefs lie along x
    json.at("axis").get_to(curve->axis);
  if (type == "relief") {
    curve->kind = CurveKind::Relief;
    json.at("spacing").get_to(curve->spacing);
    json.at("columns").get_to(curve->columns);
    json.at("heights").get_to(curve->heights);
    return curve;
  }
  if (type != "cylinder" && type != "ellipsoid")
    throw std::invalid_argument(
        "a facet is a plane, a cylinder, an ellipsoid or a relief, not a " + type);
  curve->kind = type == "ellipsoid" ? CurveKind::Ellipsoid : CurveKind::Cylinder;
  json.at("base").get_to(curve->base);
  json.at("across").get_to(curve->across);
  json.at("up").get_to(curve->up);
  if (type == "ellipsoid")
    json.at("along").get_to(curve->along);
  return curve;
}

} // namespace

void
from_json(const Json& json, PlanSlab& slab)
{
  json.at("plane").get_to(slab.plane);
  readIfThere(json, "inliers", slab.inliers);
  readIfThere(json, "residual", slab.residual);
  // A normal that was rounded; planProblem() refuses one that is no unit vector.
  const double error = std::abs(slab.plane.head<3>().norm() - 1);
  if (error > 1e-9 && error <= 1e-3)
    slab.plane /= slab.plane.head<3>().norm();
  slab.inferred = json.value("inferred", 0.0);
  slab.accuracy = accuracyFrom(json);
  const std::string type = json.value("type", "plane");
  if (type != "plane")
    slab.curve = curveFrom(json, type);
}

void
from_json(const Json& json, PlanDetail& detail)
{
  json.at("slab").get_to(detail.slab);
  json.at("boundary").get_to(detail.boundary);
  readIfThere(json, "holes", detail.holes);
}

void
to_json(Json& json, const PlanNiche& niche)
{
  json = {{"bottom", niche.bottom}, {"top", niche.top}, {"boundary", niche.boundary}};
}

void
from_json(const Json& json, PlanNiche& niche)
{
  json.at("boundary").get_to(niche.boundary);
  json.at("bottom").get_to(niche.bottom);
  json.at("top").get_to(niche.top);
}

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
to_json(Json& json, const PlanOpening& opening)
{
  Json walls = Json::array();
  for (const OpeningWall& wall : opening.walls)
    walls.push_back({{"room", wall.room}, {"element", wall.element}});
  Json head{{"shape", opening.rise > 0 ? "arched" : "flat"}};
  if (opening.rise > 0)
    head["rise"] = opening.rise;
  json = {{"kind", nameOf(opening.kind)},
          {"number", opening.number},
          {"rooms", opening.rooms},
          {"walls", walls},
          {"start", opening.start},
          {"end", opening.end},
          {"bottom", opening.bottom},
          {"top", opening.top},
          {"width", opening.width()},
          {"height", opening.height()},
          {"head", head},
          {"depth", opening.depth},
          {"hinge", hinges[static_cast<std::size_t>(opening.hinge)]},
          {"swing", opening.swing},
          {"state", states[static_cast<std::size_t>(opening.state)]},
          {"confidence", opening.confidence},
          {"residual", opening.residual}};
  if (opening.deviation_95 > 0)
    json["deviation_95"] = opening.deviation_95;
}

void
from_json(const Json& json, PlanOpening& opening)
{
  readName(json, "kind", kinds, opening.kind);
  readName(json, "hinge", hinges, opening.hinge);
  readName(json, "state", states, opening.state);
  json.at("rooms").get_to(opening.rooms);
  for (const Json& wall : json.value("walls", Json::array()))
    opening.walls.push_back(
        {wall.at("room").get<std::uint32_t>(), wall.at("element").get<std::size_t>()});
  json.at("start").get_to(opening.start);
  json.at("end").get_to(opening.end);
  json.at("bottom").get_to(opening.bottom);
  json.at("top").get_to(opening.top);
  opening.rise = json.value("head", Json::object()).value("rise", 0.0);
  opening.depth = json.value("depth", 0.0);
  if (json.contains("number"))
    opening.number = wholeFrom(json["number"], 0, "the number of an opening");
  opening.swing = json.value("swing", 0U);
  opening.confidence = json.value("confidence", 0.0);
  opening.residual = json.value("residual", 0.0);
  opening.deviation_95 = json.value("deviation_95", 0.0);
}

} // namespace pcl::sedr
