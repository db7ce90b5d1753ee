// SPDX-License-Identifier: BSD-3-Clause
#include "storey_band.h"

#include <pcl/io/pcd_io.h>
#include <pcl/sedr_filters/parallel_voxel_grid.h>
#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_surface/indoor_structure_reconstruction.h>
#include <pcl/sedr_surface/triangle_mesh.h>

#include <fstream>
#include <iostream>
#include <string>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

namespace {

// [mirror]
/** @brief What a polished floor shows: every fourth point once more, as far below it.
 */
Cloud::Ptr
withMirrorImage(const Cloud& scan)
{
  Cloud::Ptr mirrored(new Cloud(scan));
  for (std::size_t i = 0; i < scan.size(); i += 4)
    mirrored->push_back({scan[i].x, scan[i].y, -scan[i].z});
  return mirrored;
}
// [mirror]

// [use]
/** @brief Between thinning and the rest of the chain: what is not of the storey goes.
 */
Cloud::Ptr
storeyOf(const Cloud::ConstPtr& thinned, double floor, double ceiling)
{
  StoreyBand<pcl::PointXYZ> band;
  band.setInputCloud(thinned);
  band.setHeights(floor, ceiling);
  Cloud::Ptr storey(new Cloud);
  band.filter(*storey);
  if (!band.getErrorMessage().empty())
    std::cerr << band.getErrorMessage() << '\n';
  return storey;
}

bool
reconstruct(const Cloud::ConstPtr& scan, double floor, double ceiling)
{
  pcl::ParallelVoxelGrid<pcl::PointXYZ> grid;
  grid.setInputCloud(scan);
  grid.setLeafSize(0.05f, 0.05f, 0.05f);
  Cloud::Ptr thinned(new Cloud);
  grid.filter(*thinned);

  const Cloud::Ptr storey = storeyOf(thinned, floor, ceiling);
  std::cout << storey->size() << " of " << thinned->size() << " points are kept\n";

  pcl::sedr::StructureChain chain; // all stages after the thinning
  chain.getStages().floorplan_fitting.setRawCloud(scan);
  if (!chain.findStructure(storey) || !chain.makeMesh()) {
    std::cerr << chain.getModel().failed_stage << ": " << chain.getModel().problem
              << '\n';
    return false;
  }
  for (const auto& room : chain.getModel().plan->rooms)
    std::cout << "room " << room.id << ": " << room.area() << " m2, "
              << pcl::sedr::clearHeight(room).mean << " m high\n";
  std::ofstream file("mesh.ply", std::ios::binary);
  return !!(file << pcl::sedr::meshToPly(chain.getStages().poisson.getMesh())
                 << std::flush);
}
// [use]

} // namespace

int
main(int argc, char** argv)
{
  Cloud scan;
  if (argc != 4 || pcl::io::loadPCDFile(argv[1], scan) < 0) {
    std::cerr << "usage: own_stage SCAN.pcd FLOOR CEILING (heights in metres)\n";
    return 1;
  }
  return reconstruct(withMirrorImage(scan), std::stod(argv[2]), std::stod(argv[3])) ? 0
                                                                                    : 2;
}
