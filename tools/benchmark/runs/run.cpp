// SPDX-License-Identifier: BSD-3-Clause
#include "run.h"

#include "benchmark/figures/scene_truth.h"
#include "kept_files.h"

#include "simulator/scan/scan.h"

#include <pcl/common/io.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <cmath>
#include <exception>
#include <map>
#include <memory>
#include <stdexcept>

namespace pcl::sedr::benchmark {

namespace {

using Reconstruction = pcl::IndoorStructureReconstruction<pcl::PointXYZ>;

sim::Scan
scanOf(const sim::Scene& scene, const RunSettings& settings)
{
  sim::ScanOptions options;
  options.seed = settings.seed;
  options.noise = settings.noise;
  options.threads = settings.threads;
  if (settings.rays > 0)
    options.rays_per_station = settings.rays;
  return sim::scan(scene, options);
}

ScanPositions
positionsOf(const sim::Scan& scan)
{
  ScanPositions positions;
  std::size_t row = 0;
  for (const sim::ScanPosition& station : scan.positions) {
    const Eigen::Vector3d place(station.place.x, station.place.y, station.place.z);
    positions.push_back({row, place.cast<float>()});
    row += station.points;
  }
  return positions;
}

LabelledPoints
labelled(const std::vector<sim::ScanPoint>& scan)
{
  LabelledPoints result;
  pcl::PointCloud<pcl::PointXYZ>::Ptr points(new pcl::PointCloud<pcl::PointXYZ>);
  points->reserve(scan.size());
  result.labels.reserve(scan.size());
  for (const sim::ScanPoint& p : scan) {
    points->emplace_back(p.x, p.y, p.z);
    result.labels.push_back(p.label);
  }
  result.points = points;
  return result;
}

LabelledPoints
labelled(const StructureChain::StructureCloud& structure)
{
  LabelledPoints result;
  pcl::PointCloud<pcl::PointXYZ>::Ptr points(new pcl::PointCloud<pcl::PointXYZ>);
  pcl::copyPointCloud(structure, *points);
  for (const auto& p : structure)
    result.labels.push_back(p.label);
  result.points = points;
  return result;
}

/** @brief Runs the chain with its defaults.
 * @return the reason for a missing result; empty on success */
std::string
reconstruct(Reconstruction& chain, bool with_mesh)
{
  if (!with_mesh)
    return chain.findStructure() ? "" : chain.getErrorMessage();
  pcl::PolygonMesh mesh;
  chain.reconstruct(mesh);
  return mesh.polygons.empty() ? chain.getErrorMessage() : "";
}

void
noteStages(const Reconstruction& chain, RunRow& row)
{
  row.seconds = 0;
  for (const StageReport& stage : chain.getStageReports()) {
    row.stage_seconds.emplace_back(stage.name, stage.seconds);
    row.seconds += stage.seconds;
  }
  for (const std::string& warning : chain.getChain().warnings)
    row.warnings += (row.warnings.empty() ? "" : " | ") + warning;
}

std::map<std::uint32_t, double>
meshVolumes(const Reconstruction& chain)
{
  std::map<std::uint32_t, double> volumes;
  for (const auto& report : chain.getChain().poisson.getReports())
    volumes[report.room] = report.volume;
  return volumes;
}

void
noteLabels(const LabelScores& scores, RunRow& row)
{
  for (std::size_t k = 0; k < scores.size(); ++k)
    row.labels[k] = {scores[k].recall(), scores[k].precision()};
}

/** @brief Compares the results of the chain with the truth. */
void
measure(const Reconstruction& chain,
        const SceneTruth& truth,
        const LabelledPoints& scan,
        const RunSettings& settings,
        RunRow& row)
{
  const bool has_mesh = settings.with_mesh && row.failure.empty();
  row.rooms =
      measureRooms(*chain.getFloorplan(), truth.rooms,
                   has_mesh ? meshVolumes(chain) : std::map<std::uint32_t, double>());
  row.plan = measurePlan(*chain.getFloorplan(), truth.rooms);
  row.solid = measureSolid(chain.getChain().extrusion.getMesh(), *truth.fine_mesh,
                           *chain.getFloorplan(), truth.rooms, settings.threads);
  if (chain.getStructure()->empty())
    return;
  const LabelledPoints structure = labelled(*chain.getStructure());
  const double voxel_diagonal = std::sqrt(3.0) * chain.getVoxelSize();
  row.structure = measureStructure(structure.points, *truth.mesh, settings.threads);
  noteLabels(scoreLabels(structure, scan, voxel_diagonal, settings.threads), row);
  if (has_mesh)
    row.mesh = measureModel(
        std::make_shared<const TriangleMesh>(chain.getChain().tiltedMesh()), truth.mesh,
        settings.threads);
}

void
simulateAndReconstruct(const sim::Scene& scene,
                       const RunSettings& settings,
                       RunRow& row)
{
  const KeptFiles kept(settings.keep, row);
  const SceneTruth truth = truthOf(scene);
  row.rooms.rooms_true = truth.rooms.size();
  const sim::Scan scan = scanOf(scene, settings);
  row.points = scan.points.size();
  kept.keepInput(scan, truth, scene.name);

  Reconstruction chain;
  const LabelledPoints cloud = labelled(scan.points);
  chain.setPriors(settings.priors);
  chain.setNumberOfThreads(settings.threads);
  chain.setInputCloud(cloud.points);
  if (settings.tells_positions)
    chain.setScanPositions(positionsOf(scan));
  row.failure = reconstruct(chain, settings.with_mesh);
  noteStages(chain, row);
  kept.keepResult(chain, settings.with_mesh && row.failure.empty());
  measure(chain, truth, cloud, settings, row);
}

} // namespace

RunRow
rowOf(const sim::Scene& scene, const RunSettings& settings)
{
  RunRow row;
  row.scene = scene.name;
  row.noise = settings.noise;
  row.seed = settings.seed;
  row.with_mesh = settings.with_mesh;
  row.rooms.rooms_true = scene.rooms.size();
  return row;
}

RunRow
runScene(const sim::Scene& scene, const RunSettings& settings)
{
  RunRow row = rowOf(scene, settings);
  try {
    simulateAndReconstruct(scene, settings, row);
  }
  catch (const std::exception& error) {
    row.failure = error.what();
  }
  return row;
}

} // namespace pcl::sedr::benchmark
