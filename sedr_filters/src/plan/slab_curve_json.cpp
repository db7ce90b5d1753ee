// SPDX-License-Identifier: BSD-3-Clause
#include "floorplan_format.h"

#include <nlohmann/json.hpp>

#include <stdexcept>

namespace pcl::sedr {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t max_heights = 4000000; ///< of a relief

const char*
typeOf(const PlanSlab& slab)
{
  if (!slab.curve)
    return "plane";
  switch (slab.curve->kind) {
  case CurveKind::Cylinder:
    return "cylinder";
  case CurveKind::Ellipsoid:
    return "ellipsoid";
  case CurveKind::Relief:
    return "relief";
  }
  return "plane";
}

void
readRelief(const Json& json, SlabCurve& curve)
{
  curve.kind = CurveKind::Relief;
  curve.spacing = json.at("spacing").get<double>();
  curve.columns = json.at("columns").get<std::size_t>();
  const Json& heights = json.at("heights");
  if (heights.size() > max_heights)
    throw std::invalid_argument("a relief has at most " + std::to_string(max_heights) +
                                " heights, not " + std::to_string(heights.size()));
  for (const Json& z : heights)
    curve.heights.push_back(z.get<double>());
}

void
readRound(const Json& json, bool is_ellipsoid, SlabCurve& curve)
{
  curve.kind = is_ellipsoid ? CurveKind::Ellipsoid : CurveKind::Cylinder;
  curve.base = json.at("base").get<double>();
  for (Eigen::Index k = 0; k < 2; ++k)
    curve.axis[k] = json.at("axis").at(static_cast<std::size_t>(k)).get<double>();
  curve.across = json.at("across").get<double>();
  curve.up = json.at("up").get<double>();
  if (is_ellipsoid)
    curve.along = json.at("along").get<double>();
}

} // namespace

void
addCurveToJson(const PlanSlab& slab, Json& json)
{
  json["type"] = typeOf(slab);
  json["inferred"] = slab.inferred;
  if (!slab.curve)
    return;
  const SlabCurve& curve = *slab.curve;
  json["centre"] = pointToJson(curve.centre);
  if (curve.kind == CurveKind::Relief) {
    json["spacing"] = curve.spacing;
    json["columns"] = curve.columns;
    json["heights"] = curve.heights;
    return;
  }
  json["base"] = curve.base;
  json["axis"] = pointToJson(curve.axis);
  if (curve.kind == CurveKind::Ellipsoid)
    json["along"] = curve.along;
  json["across"] = curve.across;
  json["up"] = curve.up;
}

void
readCurve(const Json& json, PlanSlab& slab)
{
  slab.inferred = json.value("inferred", 0.0);
  const std::string type = json.value("type", "plane");
  if (type == "plane")
    return;
  SlabCurve curve;
  if (type != "relief" && type != "cylinder" && type != "ellipsoid")
    throw std::invalid_argument(
        "a facet is a plane, a cylinder, an ellipsoid or a relief, not a " + type);
  curve.centre = pointFromJson(json.at("centre"));
  if (type == "relief")
    readRelief(json, curve);
  else
    readRound(json, type == "ellipsoid", curve);
  if (!curve.isFinite())
    throw std::invalid_argument("the extents of a " + type +
                                " must be above 0 m and its heights finite");
  slab.curve = std::make_shared<const SlabCurve>(std::move(curve));
}

} // namespace pcl::sedr
