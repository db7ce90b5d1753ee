// SPDX-License-Identifier: BSD-3-Clause
// The chain against one written by hand from PCL's parts, from the file on:
//
//     benchmark_chain SCAN.pcd [options of google-benchmark]
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

#include <cstdio>
#include <string>

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

// What PCL's tutorials chain: voxels of 5 cm, the ten largest planes, their points'
// normals, Poisson.

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

void
SedrToTheMesh(benchmark::State& state)
{
  std::size_t triangles = 0;
  for (auto _ : state) {
    pcl::IndoorStructureReconstruction<pcl::PointXYZ> chain;
    chain.setInputCloud(readScan());
    pcl::PolygonMesh mesh;
    chain.reconstruct(mesh);
    triangles = mesh.polygons.size();
    if (mesh.polygons.empty())
      state.SkipWithError(chain.getErrorMessage().c_str());
  }
  state.counters["triangles"] = static_cast<double>(triangles);
}

void
SedrToTheSolid(benchmark::State& state)
{
  std::size_t rooms = 0;
  for (auto _ : state) {
    pcl::IndoorStructureReconstruction<pcl::PointXYZ> chain;
    chain.setInputCloud(readScan());
    if (!chain.findStructure())
      state.SkipWithError(chain.getErrorMessage().c_str());
    rooms = chain.getFloorplan() ? chain.getFloorplan()->rooms.size() : 0;
  }
  state.counters["rooms"] = static_cast<double>(rooms);
}

void
Reading(benchmark::State& state)
{
  for (auto _ : state)
    benchmark::DoNotOptimize(readScan());
}

/** @brief pcl::VoxelGrid alone, on a scan that is in memory. */
void
VoxelGrid(benchmark::State& state)
{
  const Cloud::Ptr scan = readScan();
  for (auto _ : state)
    benchmark::DoNotOptimize(thinnedByPcl(scan));
}

void
measured(benchmark::internal::Benchmark* b)
{
  b->Iterations(1)->Repetitions(5)->UseRealTime()->MeasureProcessCPUTime()->Unit(
      benchmark::kMillisecond);
}

BENCHMARK(Reading)->Apply(measured);
BENCHMARK(VoxelGrid)->Apply(measured);
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
