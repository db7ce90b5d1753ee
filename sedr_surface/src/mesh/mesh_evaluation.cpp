// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_surface/mesh_evaluation.h>

#include "mesh_repair.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ostream>

namespace pcl {
namespace sedr {

MeshFigures
measureMesh(const TriangleMesh& mesh)
{
  MeshFigures figures;
  figures.topology = checkTopology(mesh);
  figures.closed = figures.topology.isClosedManifold();
  TriangleMesh welded; // without attributes of triangles
  welded.vertices = mesh.vertices;
  welded.triangles = mesh.triangles;
  figures.closed_when_welded = weldVertices(welded) == 0
                                   ? figures.closed
                                   : checkTopology(welded).isClosedManifold();
  figures.area = mesh.area();
  figures.volume = mesh.signedVolume();
  figures.bounds = mesh.bounds();
  return figures;
}

} // namespace sedr

namespace {

constexpr const char* class_name = "MeshEvaluation";

/** @brief Shallower intersections may be rounding to floats in files, metres. */
constexpr double min_intersection = 1e-5;

} // namespace

MeshEvaluation::MeshInput::MeshInput(const pcl::PolygonMesh::ConstPtr& polygons)
{
  if (!polygons)
    return;
  auto converted = std::make_shared<sedr::TriangleMesh>();
  problem = sedr::fromPolygonMesh(*polygons, *converted);
  mesh = converted;
}

MeshEvaluation::MeshInput::MeshInput(
    const std::shared_ptr<const sedr::TriangleMesh>& triangles)
    : mesh(triangles)
    , problem(triangles ? triangles->problem() : std::string())
{}

bool
MeshEvaluation::checkParameters()
{
  if (!mesh_.mesh)
    return fail(class_name, "no mesh is set");
  const std::string problem =
      sedr::positiveProblem({{"the sample spacing", sample_spacing_}});
  return problem.empty() || fail(class_name, problem);
}

bool
MeshEvaluation::checkMesh(const MeshInput& input, const char* what)
{
  std::string problem = input.problem;
  if (problem.empty() && input.mesh->empty())
    problem = "it has no triangles";
  if (problem.empty() && !(input.mesh->area() > 0))
    problem = "its " + std::to_string(input.mesh->triangles.size()) +
              " triangles have no area";
  return problem.empty() ||
         fail(class_name, std::string("the ") + what + " is no mesh: " + problem);
}

bool
MeshEvaluation::selectPoints(std::vector<Eigen::Vector3d>& points, std::size_t& skipped)
{
  if (indices_) {
    const std::string problem = sedr::indicesProblem(*indices_, points_.size());
    if (!problem.empty())
      return fail(class_name, problem);
  }
  const std::size_t count = indices_ ? indices_->size() : points_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t index = indices_ ? static_cast<std::size_t>((*indices_)[i]) : i;
    if (points_.isFinite(index))
      points.push_back(points_[index].cast<double>());
  }
  skipped = count - points.size();
  if (points.empty())
    return fail(class_name, "the cloud has no point to measure, " +
                                std::to_string(skipped) + " of " +
                                std::to_string(count) + " are not finite");
  return true;
}

bool
MeshEvaluation::compute(sedr::MeshEvaluationResult& result)
{
  clearError();
  result = {};
  std::vector<Eigen::Vector3d> points;
  std::size_t skipped = 0;
  if (!checkParameters() || !checkMesh(mesh_, "model") ||
      (truth_.mesh && !checkMesh(truth_, "truth")) ||
      (cloud_ && !selectPoints(points, skipped)))
    return false;
  const auto& mesh = mesh_.mesh;
  const auto& truth = truth_.mesh;
  result.mesh = sedr::measureMesh(*mesh);
  if (find_self_intersections_)
    result.mesh.self_intersections =
        sedr::findSelfIntersections(*mesh, min_intersection).size();
  result.skipped_points = skipped;
  if (!truth && !cloud_)
    return true;
  const auto measure = [&](const auto& places, const sedr::MeshDistance& from) {
    return sedr::summarizeDistances(from.distances(places, threads_));
  };
  const sedr::MeshDistance to_mesh(*mesh);
  if (cloud_)
    result.cloud_to_mesh = measure(points, to_mesh);
  if (!truth)
    return true;
  const auto of_mesh = sedr::sampleMesh(*mesh, sample_spacing_, seed_);
  const auto of_truth = sedr::sampleMesh(*truth, sample_spacing_, seed_);
  result.truth = sedr::measureMesh(*truth);
  result.mesh_to_truth = measure(of_mesh.points, sedr::MeshDistance(*truth));
  result.truth_to_mesh = measure(of_truth.points, to_mesh);
  result.sample_spacing = std::max(of_mesh.spacing, of_truth.spacing);
  return true;
}

} // namespace pcl

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
