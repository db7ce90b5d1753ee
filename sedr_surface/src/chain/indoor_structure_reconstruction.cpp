// SPDX-License-Identifier: BSD-3-Clause
#include "sedr_filters/src/base/number_text.h"
#include "sedr_segmentation/src/adjust/plan_adjustment.h"
#include "sedr_segmentation/src/scan/scan_excerpt.h"
#include <pcl/sedr_surface/impl/indoor_structure_reconstruction.hpp>

#include <pcl/impl/instantiate.hpp>

namespace pcl::sedr {

std::string
voxelProblem(double voxel_size, double grid_size)
{
  if (voxel_size <= 1.001 * grid_size)
    return {};
  return "the voxel size " + numberText(voxel_size) +
         " m must not be above the grid size " + numberText(grid_size) +
         " m, or cells stay empty";
}

std::size_t
excerptStep(std::size_t points)
{
  return rawStep(points, AdjustmentParameters().max_points);
}

std::string
thinWithExcerpt(const RowSource& source,
                unsigned threads,
                const std::function<void(const RowSource&)>& thin,
                std::shared_ptr<std::vector<Eigen::Vector3f>>& excerpt)
{
  const ScanExcerpt scan(source, AdjustmentParameters().max_points, threads);
  thin(scan);
  const std::string problem = scan.problem();
  if (problem.empty())
    excerpt = scan.points();
  return problem;
}

} // namespace pcl::sedr

PCL_INSTANTIATE(IndoorStructureReconstruction, SEDR_POINT_TYPES)
