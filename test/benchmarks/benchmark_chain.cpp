// SPDX-License-Identifier: BSD-3-Clause
// The chain and one written by hand from PCL's classes, both including reading:
//
//     benchmark_chain SCAN.pcd [options of google-benchmark]
#include "scan_file.h"

#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

#include <pcl/common/io.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/filters/extract_indices.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/sac_segmentation.h>
#include <pcl/surface/poisson.h>

#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

std::string scan_path;

Cloud::Ptr
readScan()
{
  Cloud::Ptr scan(new Cloud);
  pcl::io::loadPCDFile(scan_path, *scan);
  return scan;
}

// The chain of PCL's tutorials: voxels of 5 cm, the ten largest planes, normals of
// their points, Poisson.

Cloud::Ptr
thinnedByPcl(const Cloud::Ptr& scan)
{
  pcl::VoxelGrid<pcl::PointXYZ> filter;
  filter.setInputCloud(scan);
  filter.setLeafSize(0.05f, 0.05f, 0.05f);
  Cloud::Ptr thinned(new Cloud);
  filter.filter(*thinned);
  return thinned;
}

Cloud::Ptr
tenPlanesOf(Cloud::Ptr rest)
{
  pcl::SACSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setModelType(pcl::SACMODEL_PLANE);
  segmentation.setMethodType(pcl::SAC_RANSAC);
  segmentation.setOptimizeCoefficients(true);
  segmentation.setMaxIterations(1000);
  segmentation.setDistanceThreshold(0.07);
  Cloud::Ptr planes(new Cloud);
  for (int k = 0; k < 10 && rest->size() > 100; ++k) {
    pcl::PointIndices::Ptr inliers(new pcl::PointIndices);
    pcl::ModelCoefficients plane;
    segmentation.setInputCloud(rest);
    segmentation.segment(*inliers, plane);
    if (inliers->indices.empty())
      break;
    pcl::ExtractIndices<pcl::PointXYZ> extract;
    extract.setInputCloud(rest);
    extract.setIndices(inliers);
    Cloud found;
    extract.filter(found);
    *planes += found;
    extract.setNegative(true);
    Cloud::Ptr left(new Cloud);
    extract.filter(*left);
    rest = left;
  }
  return planes;
}

pcl::PointCloud<pcl::PointNormal>::Ptr
withNormals(const Cloud::Ptr& points)
{
  Eigen::Vector4f middle;
  pcl::compute3DCentroid(*points, middle);
  pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(points);
  estimation.setKSearch(20);
  estimation.setViewPoint(middle.x(), middle.y(), middle.z());
  pcl::PointCloud<pcl::Normal> normals;
  estimation.compute(normals);
  pcl::PointCloud<pcl::PointNormal>::Ptr result(new pcl::PointCloud<pcl::PointNormal>);
  pcl::concatenateFields(*points, normals, *result);
  return result;
}

void
ChainOfPclsParts(benchmark::State& state)
{
  std::size_t triangles = 0;
  for (auto _ : state) {
    pcl::Poisson<pcl::PointNormal> poisson;
    poisson.setDepth(9);
    poisson.setInputCloud(withNormals(tenPlanesOf(thinnedByPcl(readScan()))));
    pcl::PolygonMesh mesh;
    poisson.reconstruct(mesh);
    triangles = mesh.polygons.size();
  }
  state.counters["triangles"] = static_cast<double>(triangles);
}

using Chain = pcl::IndoorStructureReconstruction<pcl::PointXYZ>;

/** @brief Returns a chain that reads the scan as pcl_sedr does: it thins while reading.
 */
std::unique_ptr<Chain>
chainFromTheFile()
{
  auto chain = std::make_unique<Chain>();
  chain->setInputSource(std::make_shared<pcl::sedr::tools::ScanFile>(scan_path));
  return chain;
}

/** @brief Measures up to the stage after the plan is fitted. */
void
SedrToThePlan(benchmark::State& state)
{
  using Clock = std::chrono::steady_clock;
  for (auto _ : state) {
    const auto start = Clock::now();
    double seconds = 0;
    const std::unique_ptr<Chain> chain = chainFromTheFile();
    chain->setStageCallback([&](const std::string& stage) {
      if (stage == "StructureRefinement")
        seconds = std::chrono::duration<double>(Clock::now() - start).count();
      return true;
    });
    if (!chain->findStructure())
      state.SkipWithError(chain->getErrorMessage().c_str());
    state.SetIterationTime(seconds);
  }
}

void
SedrToTheMesh(benchmark::State& state)
{
  std::size_t triangles = 0;
  for (auto _ : state) {
    const std::unique_ptr<Chain> chain = chainFromTheFile();
    if (!chain->findStructure() || !chain->makeMesh())
      state.SkipWithError(chain->getErrorMessage().c_str());
    triangles = chain->getStages().poisson.getMesh().triangles.size();
  }
  state.counters["triangles"] = static_cast<double>(triangles);
}

void
SedrToTheSolid(benchmark::State& state)
{
  std::size_t rooms = 0;
  for (auto _ : state) {
    const std::unique_ptr<Chain> chain = chainFromTheFile();
    if (!chain->findStructure())
      state.SkipWithError(chain->getErrorMessage().c_str());
    rooms = chain->getFloorplan() ? chain->getFloorplan()->rooms.size() : 0;
  }
  state.counters["rooms"] = static_cast<double>(rooms);
}

/** @brief Reads the bytes of the file from the page cache. */
void
Reading(benchmark::State& state)
{
  std::vector<char> buffer(std::size_t{1} << 20);
  for (auto _ : state) {
    std::ifstream file(scan_path, std::ios::binary);
    while (file.read(buffer.data(), static_cast<std::streamsize>(buffer.size())))
      benchmark::DoNotOptimize(buffer.data());
  }
}

/** @brief Measures pcl::VoxelGrid alone, on a scan in memory. */
void
VoxelGrid(benchmark::State& state)
{
  const Cloud::Ptr scan = readScan();
  for (auto _ : state)
    benchmark::DoNotOptimize(thinnedByPcl(scan));
}

benchmark::internal::Benchmark*
repeated(benchmark::internal::Benchmark* b)
{
  return b->Iterations(1)->Repetitions(5)->MeasureProcessCPUTime()->Unit(
      benchmark::kMillisecond);
}

void
measured(benchmark::internal::Benchmark* b)
{
  repeated(b)->UseRealTime();
}

void
measuredByHand(benchmark::internal::Benchmark* b)
{
  repeated(b)->UseManualTime();
}

BENCHMARK(Reading)->Apply(measured);
BENCHMARK(VoxelGrid)->Apply(measured);
BENCHMARK(SedrToThePlan)->Apply(measuredByHand);
BENCHMARK(SedrToTheSolid)->Apply(measured);
BENCHMARK(SedrToTheMesh)->Apply(measured);
BENCHMARK(ChainOfPclsParts)->Apply(measured);

} // namespace

int
main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  Cloud scan;
  if (argc != 2 || pcl::io::loadPCDFile(argv[1], scan) < 0) {
    std::fprintf(stderr, "usage: benchmark_chain SCAN.pcd [--benchmark_...]\n");
    return 1;
  }
  scan_path = argv[1];
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
