// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/impl/pcl_bases.hpp>
#include <pcl/sedr_filters/point_view.h>
#include <pcl/sedr_segmentation/horizontal_plane_detection.h>

#include <string>

namespace pcl {
namespace sedr {

/** @brief Runs HorizontalPlaneDetection on the coordinates of a cloud.
 * @return the reason if there are no planes, a sentence; else empty */
std::string detectHorizontalPlanes(const PointView& points,
                                   const pcl::Indices& indices,
                                   const LevelParameters& parameters,
                                   std::vector<pcl::HorizontalPlane>& planes);

} // namespace sedr

template <typename PointT>
bool
HorizontalPlaneDetection<PointT>::segment(std::vector<HorizontalPlane>& planes)
{
  planes.clear();
  this->clearError();
  if (!this->initCompute())
    return this->fail("HorizontalPlaneDetection", "no input cloud was set");
  const std::string problem = sedr::detectHorizontalPlanes(
      sedr::PointView(*input_), *indices_, parameters_, planes);
  for (HorizontalPlane& plane : planes)
    plane.inliers.header = plane.coefficients.header = input_->header;
  this->deinitCompute();
  return problem.empty() || this->fail("HorizontalPlaneDetection", problem);
}

} // namespace pcl

#define PCL_INSTANTIATE_HorizontalPlaneDetection(T)                                    \
  template class PCL_EXPORTS pcl::HorizontalPlaneDetection<T>;
