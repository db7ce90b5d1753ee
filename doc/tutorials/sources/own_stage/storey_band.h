// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/filters/filter_indices.h>
#include <pcl/sedr_filters/impl/stage_error.h>

/** @brief Keeps the points of one storey: what lies below its floor, such as the mirror
 * images in polished stone, or above its ceiling goes. Frame: z up, metres.
 *
 * Non-finite points are never kept and always among the removed indices. A band without
 * height, a margin below 0, a value that is not finite or an index beyond the cloud:
 * PCL_ERROR, nothing is kept, and getErrorMessage() says why. O(n).
 * @code
 * StoreyBand<pcl::PointXYZ> band;
 * band.setInputCloud(thinned);
 * band.setHeights(floor.height, ceiling.height);
 * band.filter(*storey);
 * @endcode */
template <typename PointT>
class StoreyBand : public pcl::FilterIndices<PointT>, public pcl::sedr::StageError {
public:
  using Ptr = pcl::shared_ptr<StoreyBand<PointT>>;
  using ConstPtr = pcl::shared_ptr<const StoreyBand<PointT>>;

  /** @param extract_removed_indices whether getRemovedIndices() is filled */
  explicit StoreyBand(bool extract_removed_indices = false)
      : pcl::FilterIndices<PointT>(extract_removed_indices)
  {
    this->filter_name_ = "StoreyBand";
  }

  /** @brief Heights of the lowest floor and the highest ceiling, metres. Needed. */
  void setHeights(double floor, double ceiling)
  {
    floor_ = floor;
    ceiling_ = ceiling;
  }

  double getFloorHeight() const { return floor_; }
  double getCeilingHeight() const { return ceiling_; }

  /** @brief How far below the floor and above the ceiling a point may be, metres, >= 0.
   * Default 0.05. */
  void setMargin(double margin) { margin_ = margin; }
  double getMargin() const { return margin_; }

protected:
  using pcl::FilterIndices<PointT>::applyFilter;

  void applyFilter(pcl::Indices& kept) override;

private:
  bool validate();

  double floor_ = 0;
  double ceiling_ = 0;
  double margin_ = 0.05;
};

#ifdef PCL_NO_PRECOMPILE
#include "impl/storey_band.hpp"
#endif
