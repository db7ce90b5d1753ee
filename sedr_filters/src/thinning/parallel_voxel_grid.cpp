// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/impl/instantiate.hpp>
#include <pcl/sedr_filters/impl/parallel_voxel_grid.hpp>

void
pcl::ParallelVoxelGrid<pcl::PCLPointCloud2>::filter(const sedr::RowSource& source,
                                                    PCLPointCloud2& output)
{
  clearError();
  PCLPointCloud2 thinned;
  thinned.fields = source.fields();
  thinned.point_step = static_cast<pcl::uindex_t>(source.rowSize());
  thinned.height = 1;
  thinned.is_dense = true;
  const auto make = [&](std::size_t n) {
    thinned.width = static_cast<std::uint32_t>(n);
    thinned.row_step = thinned.width * thinned.point_step;
    thinned.data.resize(n * thinned.point_step);
    return thinned.data.data();
  };
  const std::string problem =
      thin(source, nullptr, {thinned.fields, source.rowSize(), make});
  output = std::move(thinned);
  if (!problem.empty())
    fail("ParallelVoxelGrid", problem);
}

PCL_INSTANTIATE(ParallelVoxelGrid, SEDR_POINT_TYPES)
