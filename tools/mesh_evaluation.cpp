// SPDX-License-Identifier: BSD-3-Clause
#include "bytes/whole_file.h"
#include "run_tool.h"
#include "scan_options.h"
#include "tool_cloud.h"
#include "tool_error.h"

#include <pcl/common/point_tests.h>
#include <pcl/sedr_surface/mesh_evaluation.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <algorithm>
#include <cstdio>
#include <sstream>

using namespace pcl::sedr::tools;
using pcl::sedr::DistanceStatistics;
using pcl::sedr::MeshEvaluationResult;
using pcl::sedr::MeshFigures;
using pcl::sedr::TriangleMesh;

namespace {

struct Settings {
  std::string model;
  std::string truth;
  std::string cloud;
  std::string labels;
  std::string near;
  double near_distance = 0.05;
  std::string json;
};

std::shared_ptr<TriangleMesh>
load(const std::string& path)
{
  auto mesh = std::make_shared<TriangleMesh>();
  throwProblem(pcl::sedr::loadMesh(path, *mesh));
  return mesh;
}

/** @brief Loads a mesh relative to `origin`. */
std::shared_ptr<const TriangleMesh>
loadFrom(const pcl::sedr::Origin& origin, const std::string& path)
{
  const auto mesh = load(path);
  const Eigen::Vector3d shift = originOfModel(path).place - origin.place;
  for (auto& vertex : mesh->vertices)
    vertex += shift;
  return mesh;
}

/** @brief Parses a list of labels such as "1,2,3". */
std::vector<std::uint32_t>
parseLabels(const std::string& list)
{
  std::vector<std::uint32_t> labels;
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) {
    if (word.empty() || word.size() > 9 ||
        word.find_first_not_of("0123456789") != std::string::npos)
      throw ToolError(
          "--labels takes numbers with commas between them, such as 1,2,3, not '" +
          list + "'");
    labels.push_back(static_cast<std::uint32_t>(std::stoul(word)));
  }
  return labels;
}

/** @brief Returns the finite points with one of the labels, near the other mesh, as far
 * as these are asked for. */
pcl::IndicesPtr
select(const Settings& settings, const ToolCloud& cloud)
{
  if (!settings.labels.empty() && !cloud.has_label)
    throw ToolError(cloud.path + " has no field 'label', which --labels asks for");
  const std::vector<std::uint32_t> labels = parseLabels(settings.labels);
  auto selected = std::make_shared<pcl::Indices>();
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const pcl::PointXYZ& p = (*cloud.points)[i];
    if (!pcl::isFinite(p) ||
        (!labels.empty() &&
         std::find(labels.begin(), labels.end(), cloud.label[i]) == labels.end()))
      continue;
    selected->push_back(static_cast<pcl::index_t>(i));
    points.push_back(p.getVector3fMap().cast<double>());
  }
  if (!settings.near.empty()) {
    const auto reference = loadFrom(originOfModel(settings.model), settings.near);
    const std::string problem = reference->problem();
    if (!problem.empty() || reference->triangles.empty())
      throw ToolError(settings.near + " cannot be measured from: " +
                      (problem.empty() ? "it has no triangles" : problem));
    const auto distances = pcl::sedr::MeshDistance(*reference).distances(points);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < distances.size(); ++k)
      if (distances[k] <= settings.near_distance)
        (*selected)[kept++] = (*selected)[k];
    selected->resize(kept);
  }
  if (selected->empty())
    throw ToolError("none of the " + std::to_string(cloud.size()) + " points of " +
                        cloud.path + " is what --labels and --near ask for",
                    NothingFound);
  return selected;
}

void
print(const char* name, const MeshFigures& figures)
{
  const auto yes = [](bool value) { return value ? "yes" : "no"; };
  const auto& topology = figures.topology;
  std::printf("%s\n", name);
  std::printf("  closed manifold     %s%s%s\n", yes(figures.closed),
              figures.closed ? "" : ": ", topology.problem().c_str());
  if (figures.closed != figures.closed_when_welded)
    std::printf("  with equal vertices made one: %s\n",
                yes(figures.closed_when_welded));
  std::printf("  vertices, triangles %zu, %zu\n", topology.vertices,
              topology.triangles);
  std::printf("  components          %zu\n", topology.components.size());
  if (figures.self_intersections)
    std::printf("  self-intersections  %zu\n", *figures.self_intersections);
  std::printf("  area                %.3f m2\n", figures.area);
  std::printf("  volume              %.3f m3%s\n", figures.volume,
              figures.volume < 0 ? ", the faces look inwards" : "");
}

void
print(const char* name, const std::optional<DistanceStatistics>& s)
{
  if (s)
    std::printf("%-14s %9zu %8.3f %8.3f %8.3f %8.3f %8.3f %8.3f %7.2f %7.2f\n", name,
                s->count, 100 * s->mean, 100 * s->rms, 100 * s->median, 100 * s->p95,
                100 * s->p99, 100 * s->max, 100 * s->within_1cm, 100 * s->within_5cm);
}

void
print(const MeshEvaluationResult& result)
{
  print("model", result.mesh);
  if (result.truth)
    print("truth", *result.truth);
  if (!result.truth && !result.cloud_to_mesh)
    return;
  std::printf("\n%-14s %9s %8s %8s %8s %8s %8s %8s %7s %7s\n", "distances, cm",
              "samples", "mean", "rms", "median", "p95", "p99", "max", "% <=1",
              "% <=5");
  print("cloud to model", result.cloud_to_mesh);
  print("model to truth", result.mesh_to_truth);
  print("truth to model", result.truth_to_mesh);
}

int
run(const Settings& settings, pcl::MeshEvaluation& evaluation)
{
  if (!settings.json.empty())
    checkWritable(settings.json);
  if (settings.cloud.empty() && !(settings.labels + settings.near).empty())
    throw ToolError("--labels and --near choose points of a cloud, but there is no "
                    "--cloud");
  evaluation.setInputMesh(load(settings.model));
  ScanSettings reading; // of the cloud
  reading.origin = originOfModel(settings.model);
  if (!settings.truth.empty())
    evaluation.setTruth(loadFrom(*reading.origin, settings.truth));
  if (!settings.cloud.empty()) {
    const ToolCloud cloud = loadCloud(settings.cloud, reading);
    evaluation.setInputCloud(cloud.points);
    if (!settings.labels.empty() || !settings.near.empty())
      evaluation.setIndices(select(settings, cloud));
  }
  MeshEvaluationResult result;
  {
    const Progress progress("measuring distances");
    if (!evaluation.compute(result))
      throw ToolError(evaluation.getErrorMessage(), NothingFound);
  }
  if (!settings.json.empty())
    writeWhole(settings.json, [&result](std::ostream& stream) {
      pcl::sedr::writeJson(stream, result);
      stream << '\n';
    });
  print(result);
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  pcl::MeshEvaluation evaluation;
  evaluation.setNumberOfThreads(0);
  Settings settings;
  bool find_intersections = evaluation.getFindSelfIntersections();
  Options options(
      "pcl_mesh_evaluation",
      "Tells whether a mesh is closed and how far it lies from a cloud and from the "
      "truth.");
  options.file("MODEL", settings.model, "PLY or OBJ mesh to judge");
  options.text("truth", settings.truth, "PLY or OBJ mesh that the model should be");
  options.text("cloud", settings.cloud, "PCD or PLY cloud to measure from the model");
  options.text("labels", settings.labels, "only points of these labels, such as 1,2,3");
  options.text("near", settings.near,
               "only points near this PLY or OBJ mesh, such as a model of the walls");
  options.number("near-distance", settings.near_distance, "m", "how near, with --near",
                 Range::atLeast(0));
  options.text("json", settings.json, "file to write all figures to");
  options.flag("self-intersections", find_intersections,
               "look for triangles of the model that go through each other");
  return runTool(options, argc, argv, [&] {
    evaluation.setFindSelfIntersections(find_intersections);
    return run(settings, evaluation);
  });
}
