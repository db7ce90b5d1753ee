// SPDX-License-Identifier: BSD-3-Clause
#include "run_tool.h"
#include "scan_file.h"
#include "scan_options.h"
#include "stage_pictures.h"
#include "tool_cloud.h"
#include "tool_error.h"

#include "sedr_segmentation/src/scan/scan_excerpt.h"
#include <pcl/sedr_filters/parallel_voxel_grid.h>
#include <pcl/sedr_segmentation/building.h>

#include <pcl/conversions.h>

#include <vector>

using namespace pcl::sedr;
using namespace pcl::sedr::tools;

namespace {

struct Settings : StageFiles {
  ScanOptions reading;
  float leaf = 0;
  unsigned int minimum_points = 0;
  bool keep_strays = false;
  bool scan_axes = false;
};

/** @brief Returns the frame of the building, found from an excerpt of a scan. */
BuildingFrame
frameOf(const Settings& settings, const ScanFile& scan)
{
  constexpr std::size_t enough = 5000000; // points of a scan
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (const Eigen::Vector3f& p : excerptOf(scan, enough, 0))
    cloud->emplace_back(p.x(), p.y(), p.z());
  pcl::ParallelVoxelGrid<pcl::PointXYZ> grid;
  grid.setLeafSize(settings.leaf, settings.leaf, settings.leaf);
  grid.setRemoveStrays(!settings.keep_strays);
  grid.setInputCloud(cloud);
  grid.filter(*cloud);
  return findBuildingFrame(PointView(*cloud), {}, 0, Eigen::Matrix3d::Identity(),
                           settings.leaf);
}

/** @brief Moves a cloud to another frame. */
void
move(const BuildingFrame& frame, pcl::PCLPointCloud2& cloud)
{
  pcl::PointCloud<pcl::PointXYZ> points;
  pcl::fromPCLPointCloud2(cloud, points);
  std::vector<Eigen::Vector3f> moved(points.size());
  movePoints(frame, PointView(points), 0, moved.data());
  setCoordinates(cloud, 0, moved);
}

pcl::PCLPointCloud2
compute(const Settings& settings, const ScanFile& scan)
{
  const Progress progress("thinning");
  pcl::ParallelVoxelGrid<pcl::PCLPointCloud2> grid;
  grid.setLeafSize(settings.leaf, settings.leaf, settings.leaf);
  grid.setMinimumPointsNumberPerVoxel(settings.minimum_points);
  grid.setRemoveStrays(!settings.keep_strays);
  pcl::PCLPointCloud2 thinned;
  if (settings.scan_axes)
    grid.filter(scan, thinned);
  else {
    const BuildingFrame frame = frameOf(settings, scan);
    grid.filter(MovedRows(scan, frame, 0, true), thinned);
    throwProblem(grid.getErrorMessage());
    move(frame.to(BuildingFrame()), thinned);
  }
  throwProblem(grid.getErrorMessage());
  return thinned;
}

int
run(const Settings& settings)
{
  settings.check();
  const ScanFile scan(settings.input, settings.reading.resolved());
  ToolCloud cloud;
  cloud.path = settings.input;
  cloud.origin = scan.origin();
  cloud.blob = compute(settings, scan);
  cloud.points.reset(new pcl::PointCloud<pcl::PointXYZ>);
  cloud.knows_viewpoint = scan.knowsViewpoint();
  cloud.points->sensor_origin_ = scan.viewpoint();
  cloud.points->sensor_orientation_ = scan.orientation();
  if (rowsOf(cloud.blob) == 0)
    throw ToolError("no voxel of " + std::to_string(settings.leaf) + " m holds " +
                        std::to_string(settings.minimum_points) + " or more of the " +
                        std::to_string(scan.size()) + " points",
                    NothingFound);
  warnOfPositions(scan);
  settings.save(cloud, settings.reading.resolved());
  say(std::to_string(scan.size()) + " points -> " + std::to_string(rowsOf(cloud.blob)));
  return Done;
}

} // namespace

int
main(int argc, char** argv)
{
  const pcl::ParallelVoxelGrid<pcl::PCLPointCloud2> defaults;
  Settings settings;
  settings.leaf = defaults.getLeafSize().x();
  settings.minimum_points = defaults.getMinimumPointsNumberPerVoxel();

  Options options(
      "pcl_parallel_voxel_grid",
      "Thins a cloud to the mean of the points of each voxel, all fields averaged.");
  options.file("INPUT", settings.input,
               "PCD, PLY, E57, LAS or text to thin; - is the standard input");
  options.file("OUTPUT", settings.output, "PCD or PLY file to write");
  settings.picture.declare(options);
  options.number("leaf", settings.leaf, "m", "edge of a voxel", Range::above(0));
  options.number("min-points", settings.minimum_points, "",
                 "voxels with fewer points give none");
  options.flag("keep-strays", settings.keep_strays,
               "keep voxels that points scattered in the air explain");
  options.flag(
      "scan-axes", settings.scan_axes,
      "lay the voxels along the axes of the scan as pcl_voxel_grid does, not of "
      "the building: faster, but they depend on how the scan lies");
  addScanOptions(options, settings.reading);
  return runTool(options, argc, argv, [&] { return run(settings); });
}
