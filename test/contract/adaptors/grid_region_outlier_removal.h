// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contract/contract.h"

#include <pcl/sedr_filters/grid_region_outlier_removal.h>

namespace contract {

class GridRegionOutlierRemovalAdaptor : public AdaptorDefaults {
public:
  static constexpr bool has_negative = true;
  static constexpr bool works_in_place = true;
  static constexpr int spoils = 5;

  void setInput(const Cloud::ConstPtr& cloud) { removal_.setInputCloud(cloud); }

  void setIndices(const pcl::IndicesPtr& indices) { removal_.setIndices(indices); }

  void setNegative(bool negative) { removal_.setNegative(negative); }

  void mend()
  {
    removal_.setGridSize(0.05);
    removal_.setOpeningRadius(0);
    removal_.setMinimumSupport(0.5);
  }

  void spoil(int which)
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double sizes[] = {0, -0.05, std::numeric_limits<double>::infinity()};
    if (which < 3)
      removal_.setGridSize(sizes[which]);
    else if (which == 3)
      removal_.setOpeningRadius(-1);
    else
      removal_.setMinimumSupport(which == 4 ? 1.5 : nan);
  }

  Outcome run()
  {
    pcl::Indices kept{7, 7, 7};
    removal_.filter(kept);
    Outcome outcome = outcomeOf(kept.size());
    outcome.kept = kept;
    append(outcome.all, kept);
    if (removal_.getInputCloud())
      append(outcome.geometry, Cloud(*removal_.getInputCloud(), kept));
    return outcome;
  }

  Outcome runInPlace(const Cloud::Ptr& cloud)
  {
    setInput(cloud);
    removal_.filter(*cloud);
    Outcome outcome = outcomeOf(cloud->size());
    append(outcome.geometry, *cloud);
    return outcome;
  }

protected:
  Outcome outcomeOf(std::size_t size) const
  {
    Outcome outcome;
    outcome.size = size;
    outcome.error = removal_.getErrorMessage();
    outcome.removed = *removal_.getRemovedIndices();
    append(outcome.geometry, removal_.getRegionSizes());
    append(outcome.geometry, removal_.getThreshold());
    append(outcome.geometry, removal_.getNumberOfRegions());
    append(outcome.all, *outcome.removed);
    append(outcome.all, removal_.getRegionLabels());
    append(outcome.all, removal_.getRegionSizes());
    return outcome;
  }

  pcl::GridRegionOutlierRemoval<pcl::PointXYZ> removal_{true};
};

/** The same with all extensions of the paper's method enabled. */
class OpenedGridRegionOutlierRemovalAdaptor : public GridRegionOutlierRemovalAdaptor {
public:
  OpenedGridRegionOutlierRemovalAdaptor() { mend(); }

  void setInput(const Cloud::ConstPtr& cloud)
  {
    GridRegionOutlierRemovalAdaptor::setInput(cloud);
    removal_.setSupportIndices(between(*cloud, -0.1f, 0.1f));
  }

  void mend()
  {
    GridRegionOutlierRemovalAdaptor::mend();
    removal_.setOpeningRadius(2);
  }
};

} // namespace contract
