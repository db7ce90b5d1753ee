// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contract/contract.h"

#include <pcl/sedr_segmentation/ceiling_boundary_wall_growing.h>

#include <utility>

namespace contract {

/** Ceiling and floor are the slabs of the sample room, restricted to the indices if
 * set. */
class CeilingBoundaryWallGrowingAdaptor : public AdaptorDefaults {
public:
  static constexpr bool finds_in_one_point = false;
  static constexpr int spoils = 10;

  CeilingBoundaryWallGrowingAdaptor() { mend(); }

  void setInput(const Cloud::ConstPtr& cloud)
  {
    growing_.setInputCloud(cloud);
    setSlabs(*between(*cloud, -10.f, 10.f), growing_);
  }

  void setIndices(const pcl::IndicesPtr& indices)
  {
    growing_.setIndices(indices);
    setSlabs(*indices, growing_);
  }

  void setThreads(unsigned threads) { growing_.setNumberOfThreads(threads); }

  void mend()
  {
    growing_.setNumberOfNeighbors(200);
    growing_.setAngleThreshold(static_cast<float>(M_PI / 3));
    growing_.setDistanceThreshold(0.1);
    growing_.setMinimumSupport(0);
  }

  void spoil(int which)
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const double distances[] = {0, -1, nan};
    const float angles[] = {0.f, -1.f, 7.f, static_cast<float>(nan)};
    const double shares[] = {-0.1, 1.1};
    if (which < 3)
      growing_.setDistanceThreshold(distances[which]);
    else if (which < 7)
      growing_.setAngleThreshold(angles[which - 3]);
    else if (which < 9)
      growing_.setMinimumSupport(shares[which - 7]);
    else
      growing_.setNumberOfNeighbors(2);
  }

  Outcome run()
  {
    pcl::PointIndices walls;
    walls.indices = {1, 2, 3};
    growing_.segment(walls);

    Outcome outcome;
    outcome.size = walls.indices.size();
    outcome.error = growing_.getErrorMessage();
    outcome.kept = walls.indices;
    for (const pcl::Indices* indices :
         {&std::as_const(walls.indices), &growing_.getBoundaryIndices(),
          &growing_.getScopeBoundaryIndices(), &growing_.getFloorBoundaryIndices()}) {
      append(outcome.all, *indices);
      if (growing_.getInputCloud())
        append(outcome.geometry, Cloud(*growing_.getInputCloud(), *indices));
    }
    return outcome;
  }

protected:
  pcl::CeilingBoundaryWallGrowing<pcl::PointXYZ> growing_;
};

/** With slice height and minimum support. */
class SlicedCeilingBoundaryWallGrowingAdaptor
    : public CeilingBoundaryWallGrowingAdaptor {
public:
  SlicedCeilingBoundaryWallGrowingAdaptor()
  {
    growing_.setSliceHeight(1.25);
    growing_.setMinimumSupport(0.3);
  }
};

} // namespace contract
