// SPDX-License-Identifier: BSD-3-Clause
// What PCL's own parts take on a scan, for performance.py: lines of "measured", a name,
// seconds, and the most memory beside the scan in MiB.
//
//     benchmark_pcl SCAN.pcd         pcl::VoxelGrid and pcl::ParallelVoxelGrid at 5 cm
//     benchmark_pcl SCAN.pcd chain   the first, and a chain from the file to a mesh
#include <pcl/sedr_filters/parallel_voxel_grid.h>

#include <pcl/common/io.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/filters/extract_indices.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/sac_segmentation.h>
#include <pcl/surface/poisson.h>

#include <malloc.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <string>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** @brief Returns a line of /proc/self/status in MiB; 0 if it is missing. */
double
memoryLine(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == name) {
      double kibibytes = 0;
      status >> kibibytes;
      return kibibytes / 1024;
    }
  return 0;
}

template <typename Work>
void
measure(const char* name, const Work& work)
{
  using Clock = std::chrono::steady_clock;
  malloc_trim(0);                              // what earlier work has left
  std::ofstream("/proc/self/clear_refs") << 5; // resets the peak
  const double before = memoryLine("VmRSS:");
  const auto start = Clock::now();
  work();
  const std::chrono::duration<double> seconds = Clock::now() - start;
  std::printf("measured %s %.4f %.0f\n", name, seconds.count(),
              memoryLine("VmHWM:") - before);
}

template <typename FilterT>
Cloud::Ptr
thinned(const Cloud::Ptr& scan, FilterT&& filter)
{
  filter.setInputCloud(scan);
  filter.setLeafSize(0.05F, 0.05F, 0.05F);
  Cloud::Ptr output(new Cloud);
  filter.filter(*output);
  return output;
}

// The chain of PCL's tutorials: voxels of 5 cm, the ten largest planes, normals of
// their points, Poisson.

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
meshFromTheFile(const char* path)
{
  Cloud::Ptr scan(new Cloud);
  pcl::io::loadPCDFile(path, *scan);
  pcl::Poisson<pcl::PointNormal> poisson;
  poisson.setDepth(9);
  poisson.setInputCloud(
      withNormals(tenPlanesOf(thinned(scan, pcl::VoxelGrid<pcl::PointXYZ>()))));
  pcl::PolygonMesh mesh;
  poisson.reconstruct(mesh);
}

} // namespace

int
main(int argc, char** argv)
{
  Cloud::Ptr scan(new Cloud);
  if (argc < 2 || pcl::io::loadPCDFile(argv[1], *scan) < 0) {
    std::fprintf(stderr, "usage: benchmark_pcl SCAN.pcd [chain]\n");
    return 1;
  }
  measure("VoxelGrid", [&] { thinned(scan, pcl::VoxelGrid<pcl::PointXYZ>()); });
  if (argc > 2)
    measure("ChainOfPclsParts", [&] { meshFromTheFile(argv[1]); });
  else
    for (const unsigned threads : {1U, 2U}) {
      pcl::ParallelVoxelGrid<pcl::PointXYZ> filter;
      filter.setNumberOfThreads(threads);
      measure(threads == 1 ? "ParallelVoxelGrid_1" : "ParallelVoxelGrid_2",
              [&] { thinned(scan, filter); });
    }
  return 0;
}
