// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/impl/pcl_bases.hpp>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>

#include <vector>

namespace pcl {
namespace sedr {

/** @brief Input of CeilingBoundaryWallGrowing; a null pointer means no points. */
struct WallInput {
  PointView points;
  const pcl::Indices& candidates;
  const pcl::IndicesConstPtr& ceiling;
  const pcl::IndicesConstPtr& floor;
  const pcl::IndicesConstPtr& details;
};

/** @brief Runs CeilingBoundaryWallGrowing on the coordinates of a cloud.
 * @return the reason for a failure, a sentence; empty on success */
std::string growWalls(const WallInput& input,
                      const BoundaryOptions& boundary,
                      const WallGrowingOptions& growing,
                      GrownWalls& result);

} // namespace sedr

template <typename PointT>
bool
CeilingBoundaryWallGrowing<PointT>::segment(pcl::PointIndices& walls)
{
  walls = pcl::PointIndices();
  result_ = sedr::GrownWalls();
  this->clearError();
  if (!input_ || !this->initCompute())
    return this->fail("CeilingBoundaryWallGrowing", "no input cloud was set");
  walls.header = input_->header;
  const sedr::WallInput input{sedr::PointView(*input_), *indices_, ceiling_, floor_,
                              details_};
  const std::string problem = sedr::growWalls(input, boundary_, growing_, result_);
  walls.indices = result_.with_details;
  this->deinitCompute();
  return problem.empty() || this->fail("CeilingBoundaryWallGrowing", problem);
}

} // namespace pcl

#define PCL_INSTANTIATE_CeilingBoundaryWallGrowing(T)                                  \
  template class PCL_EXPORTS pcl::CeilingBoundaryWallGrowing<T>;
