// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sedr_filters/impl/pcl_bases.hpp>
#include <pcl/sedr_segmentation/opening_detection.h>

#include <string>

namespace pcl {
namespace sedr {

/** @brief Runs OpeningDetection on the coordinates of a cloud.
 * @return the reason for a failure, a sentence; empty on success */
std::string findOpenings(const PointView& points,
                         const IndicesConstPtr& indices,
                         const SightLines* sight,
                         const Priors& priors,
                         unsigned threads,
                         Floorplan& plan,
                         std::shared_ptr<const OpeningSearch>& search);

} // namespace sedr

template <typename PointT>
bool
OpeningDetection<PointT>::segment(sedr::Floorplan& plan)
{
  if (!this->initCompute())
    return fail("OpeningDetection", "no input cloud was set");
  const bool is_done = segment(sedr::PointView(*input_), indices_, plan);
  this->deinitCompute();
  return is_done;
}

template <typename PointT>
bool
OpeningDetection<PointT>::segment(const sedr::PointView& points,
                                  const IndicesConstPtr& indices,
                                  sedr::Floorplan& plan)
{
  search_.reset();
  this->clearError();
  const std::string problem = sedr::findOpenings(points, indices, sight_.get(), priors_,
                                                 threads_, plan, search_);
  return problem.empty() || fail("OpeningDetection", problem);
}

} // namespace pcl

#define PCL_INSTANTIATE_OpeningDetection(T)                                            \
  template class PCL_EXPORTS pcl::OpeningDetection<T>;
