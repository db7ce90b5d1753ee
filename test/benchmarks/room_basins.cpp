// SPDX-License-Identifier: BSD-3-Clause
// What border_odds.py fits: room_basins SCAN.pcd prints the basins of a scan's air.
#include "sedr_segmentation/src/air/air_measures.h"
#include "sedr_segmentation/src/parting/room_borders.h"
#include "sedr_segmentation/src/parting/room_parting.h"

#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>
#include <pcl/sedr_filters/parallel_voxel_grid.h>

#include <cmath>
#include <cstdio>

using namespace pcl::sedr;

int
main(int argc, char** argv)
{
  constexpr double cell = 0.05;
  pcl::PointCloud<pcl::PointXYZ>::Ptr scan(new pcl::PointCloud<pcl::PointXYZ>);
  if (argc != 2 || pcl::io::loadPCDFile(argv[1], *scan) < 0)
    return 1;
  pcl::PointCloud<pcl::PointXYZ> thinned;
  pcl::ParallelVoxelGrid<pcl::PointXYZ> thinning;
  thinning.setInputCloud(scan);
  thinning.filter(thinned);
  const VoxelColumns fine(PointView(thinned), {}, cell, cell, 0);
  VoxelColumns seen = fine.halved(0);
  seen.keepSurfaces(0);
  VoxelColumns columns = seen;
  columns.closeDots(2, 0);
  columns.closeHoles(4, 0);
  const AirGaps air(columns, seen, {}, &fine);
  const PartingParameters parameters;
  const auto reach = std::lround(parameters.lintel_reach / columns.cellSize());
  const std::vector<float> dip = dipOfCeiling(air, static_cast<int>(reach));
  RoomLabels labels(roomBasins(air, dip, parameters));
  const RoomBorders basins(air, dip, parameters, labels);
  for (std::uint32_t r = 0; r < basins.size(); ++r) {
    const RoomExtent& basin = basins.room(r);
    std::printf("basin %u %zu %g %g\n", r, labels.sizes()[r], basin.depth, basin.ends);
    for (const auto& [other, b] : basin.beside)
      if (r < other)
        std::printf("border %u %u %g %g %g %g %g %g\n", r, other, b.links, b.walls,
                    b.drops, b.dip, b.stacked, b.clear);
  }
  for (std::uint32_t g = 0; g < air.size(); ++g)
    if (labels.hasRoom(g))
      std::printf("gap %u %.3f %.3f %.3f %.3f\n", labels.roomOf(g), air.placeOf(g).x(),
                  air.placeOf(g).y(), columns.heightOf(air[g].low),
                  columns.heightOf(air[g].high));
}
