// SPDX-License-Identifier: BSD-3-Clause
#include "model_figures.h"

#include "scene_truth.h"

#include <pcl/sedr_surface/mesh_distance.h>
#include <pcl/sedr_surface/mesh_evaluation.h>

#include <stdexcept>
#include <vector>

namespace pcl::sedr::benchmark {

namespace {

/** @brief Returns the points in the zone around details. */
std::vector<Eigen::Vector3d>
inDetailZone(const std::vector<Eigen::Vector3d>& points,
             const TriangleMesh& details,
             unsigned threads)
{
  std::vector<Eigen::Vector3d> zone;
  const auto distances = MeshDistance(details).distances(points, threads);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (distances[i] <= detail_zone)
      zone.push_back(points[i]);
  return zone;
}

/** @brief Measures the zone around details with the samples of MeshEvaluation. */
void
measureDetails(const TriangleMesh& mesh,
               const TriangleMesh& truth,
               const pcl::MeshEvaluation& evaluation,
               ModelFigures& figures)
{
  const TriangleMesh details = detailsOf(truth);
  if (details.empty())
    return;
  const unsigned threads = evaluation.getNumberOfThreads();
  const auto samples =
      sampleMesh(truth, evaluation.getSampleSpacing(), evaluation.getSeed());
  const auto zone = inDetailZone(samples.points, details, threads);
  const auto distances =
      summarizeDistances(MeshDistance(mesh).distances(zone, threads));
  figures.detail_within_1cm = distances.within_1cm;
  figures.detail_within_5cm = distances.within_5cm;
}

} // namespace

ModelFigures
measureModel(const std::shared_ptr<const TriangleMesh>& mesh,
             const std::shared_ptr<const TriangleMesh>& truth,
             unsigned threads)
{
  pcl::MeshEvaluation evaluation;
  evaluation.setInputMesh(mesh);
  evaluation.setTruth(truth);
  evaluation.setNumberOfThreads(threads);
  MeshEvaluationResult result;
  if (!evaluation.compute(result))
    throw std::runtime_error(evaluation.getErrorMessage());

  ModelFigures figures;
  const MeshTopology& topology = result.mesh.topology;
  figures.components = topology.components.size();
  figures.closed = topology.isClosed();
  figures.edge_manifold = topology.isEdgeManifold();
  figures.vertex_manifold = topology.isVertexManifold();
  figures.closed_manifold = result.mesh.closed;

  const DistanceStatistics& to_mesh = *result.truth_to_mesh;
  figures.truth_to_mesh_mean = to_mesh.mean;
  figures.truth_to_mesh_rms = to_mesh.rms;
  figures.truth_to_mesh_p95 = to_mesh.p95;
  figures.truth_to_mesh_max = to_mesh.max;
  figures.truth_within_1cm = to_mesh.within_1cm;
  figures.truth_within_5cm = to_mesh.within_5cm;

  const DistanceStatistics& to_truth = *result.mesh_to_truth;
  figures.mesh_to_truth_mean = to_truth.mean;
  figures.mesh_to_truth_p95 = to_truth.p95;
  figures.mesh_to_truth_max = to_truth.max;
  figures.mesh_beyond_5cm = 1 - to_truth.within_5cm;

  measureDetails(*mesh, *truth, evaluation, figures);
  return figures;
}

} // namespace pcl::sedr::benchmark
