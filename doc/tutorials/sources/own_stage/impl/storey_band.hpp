// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "storey_band.h"

#include <pcl/common/point_tests.h>
#include <pcl/filters/impl/filter_indices.hpp>

#include <cmath>
#include <string>

// [validate]
template <typename PointT>
bool
StoreyBand<PointT>::validate()
{
  const std::string band =
      "from " + std::to_string(floor_) + " to " + std::to_string(ceiling_) + " m";
  if (!(ceiling_ > floor_) || !std::isfinite(floor_) || !std::isfinite(ceiling_))
    return this->fail("StoreyBand",
                      "the ceiling must be above the floor, it goes " + band);
  if (!(margin_ >= 0) || !std::isfinite(margin_))
    return this->fail("StoreyBand", "the margin must be at least 0 m, it is " +
                                        std::to_string(margin_));
  const std::string problem =
      pcl::sedr::indicesProblem(*this->indices_, this->input_->size());
  return problem.empty() || this->fail("StoreyBand", problem);
}
// [validate]

// [apply]
template <typename PointT>
void
StoreyBand<PointT>::applyFilter(pcl::Indices& kept)
{
  this->clearError();
  kept.clear();
  this->removed_indices_->clear();
  if (!validate()) {
    *this->removed_indices_ =
        pcl::sedr::indicesInRange(*this->indices_, this->input_->size());
    return;
  }
  for (const auto i : *this->indices_) {
    const PointT& point = (*this->input_)[static_cast<std::size_t>(i)];
    const bool is_inside = point.z >= floor_ - margin_ && point.z <= ceiling_ + margin_;
    const bool is_kept = pcl::isFinite(point) && is_inside != this->negative_;
    if (is_kept)
      kept.push_back(i);
    else if (this->extract_removed_indices_)
      this->removed_indices_->push_back(i);
  }
}
// [apply]

#define PCL_INSTANTIATE_StoreyBand(T) template class StoreyBand<T>;
