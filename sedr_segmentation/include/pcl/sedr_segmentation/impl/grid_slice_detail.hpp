// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/impl/pcl_bases.hpp>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_segmentation/grid_slice_detail.h>

#include <pcl/sedr_filters/priors.h>

#include <string>

namespace pcl {
namespace sedr {

/** @brief Input of GridSliceDetail. */
struct SliceInput {
  PointView points;
  const pcl::Indices& indices;
  const pcl::IndicesConstPtr& ceiling;
  const pcl::IndicesConstPtr& floor;
  double floor_height; ///< metres, NaN: that of the floor
  std::uint64_t seed;  ///< of the ceiling's plane
};

/** @brief Runs GridSliceDetail on the coordinates of a cloud.
 * @return the reason for a failure, a sentence; empty on success */
std::string analyseSlices(const SliceInput& input,
                          const SliceParameters& parameters,
                          SliceDetails& details);

} // namespace sedr

template <typename PointT>
bool
GridSliceDetail<PointT>::segment(PointIndices& details)
{
  details.indices.clear();
  result_ = sedr::SliceDetails();
  this->clearError();
  if (!this->initCompute())
    return fail("GridSliceDetail", "no input cloud was set");
  details.header = input_->header;
  const std::string problem = sedr::analyseSlices(
      {sedr::PointView(*input_), *indices_, ceiling_, floor_, floor_height_, seed_},
      parameters_, result_);
  details.indices = result_.indices;
  this->deinitCompute();
  return problem.empty() || fail("GridSliceDetail", problem);
}

} // namespace pcl

#define PCL_INSTANTIATE_GridSliceDetail(T)                                             \
  template class PCL_EXPORTS pcl::GridSliceDetail<T>;
