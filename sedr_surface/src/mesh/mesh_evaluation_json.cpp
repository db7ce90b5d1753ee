// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_surface/mesh_evaluation.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ostream>

namespace pcl::sedr {
namespace {

using Json = nlohmann::ordered_json;

/** @brief Returns a number with nine digits, null if it is not finite. */
Json
number(double value)
{
  if (!std::isfinite(value))
    return nullptr;
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return std::strtod(text, nullptr);
}

Json
toJson(const DistanceStatistics& s)
{
  return {{"count", s.count},
          {"mean", number(s.mean)},
          {"rms", number(s.rms)},
          {"median", number(s.median)},
          {"p95", number(s.p95)},
          {"p99", number(s.p99)},
          {"max", number(s.max)},
          {"within_1cm", number(s.within_1cm)},
          {"within_5cm", number(s.within_5cm)},
          {"beyond_5cm", number(1 - s.within_5cm)},
          {"histogram_range", number(s.histogram_range)},
          {"histogram", s.histogram},
          {"beyond_histogram", s.beyond_histogram}};
}

Json
toJson(const MeshFigures& figures)
{
  const MeshTopology& t = figures.topology;
  Json json{{"closed_manifold", figures.closed},
            {"closed_manifold_when_welded", figures.closed_when_welded},
            {"closed", t.isClosed()},
            {"area", number(figures.area)},
            {"volume", number(figures.volume)},
            {"vertices", t.vertices},
            {"edges", t.edges},
            {"triangles", t.triangles},
            {"euler_characteristic", t.euler_characteristic},
            {"boundary_edges", t.boundary_edges},
            {"non_manifold_edges", t.non_manifold_edges},
            {"non_manifold_vertices", t.non_manifold_vertices},
            {"inconsistent_edges", t.inconsistent_edges},
            {"degenerate_triangles", t.degenerate_triangles},
            {"duplicate_triangles", t.duplicate_triangles}};
  if (figures.self_intersections)
    json["self_intersections"] = *figures.self_intersections;
  json["component_count"] = t.components.size();
  json["components"] = Json::array();
  // A broken mesh can have thousands of small components; the largest are listed.
  const std::size_t listed = std::min<std::size_t>(t.components.size(), 100);
  for (std::size_t i = 0; i < listed; ++i) {
    const MeshComponent& c = t.components[i];
    json["components"].push_back({{"triangles", c.triangles},
                                  {"area", number(c.area)},
                                  {"volume", number(c.signed_volume)},
                                  {"closed", c.closed}});
  }
  return json;
}

} // namespace

void
writeJson(std::ostream& stream, const MeshEvaluationResult& result)
{
  Json json{{"mesh", toJson(result.mesh)}};
  if (result.truth)
    json["truth"] = toJson(*result.truth);
  if (result.cloud_to_mesh)
    json["cloud_to_mesh"] = toJson(*result.cloud_to_mesh);
  if (result.mesh_to_truth)
    json["mesh_to_truth"] = toJson(*result.mesh_to_truth);
  if (result.truth_to_mesh)
    json["truth_to_mesh"] = toJson(*result.truth_to_mesh);
  if (result.truth)
    json["sample_spacing"] = number(result.sample_spacing);
  if (result.cloud_to_mesh)
    json["skipped_points"] = result.skipped_points;
  stream << json.dump(2);
}

} // namespace pcl::sedr
