// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contract/contract.h"

#include <pcl/sedr_segmentation/floorplan_fitting.h>

namespace contract {

/** Ceiling and floor are the slabs of the sample room, restricted to the indices if
 * set; a room far away is room 2. The size is the number of elements of all loops.
 *
 * Not applicable: it writes no cloud and removes no points. */
class FloorplanFittingAdaptor : public AdaptorDefaults {
public:
  static constexpr bool finds_in_one_point = false;
  static constexpr int spoils = 9;

  void setInput(const Cloud::ConstPtr& cloud)
  {
    fitting_.setInputCloud(cloud);
    setSlabs(*between(*cloud, -10.f, 10.f), fitting_);
    rooms_.clear();
    for (const auto& p : *cloud)
      rooms_.push_back(p.x > 4096.f ? 2 : 1);
    mend();
  }

  void setIndices(const pcl::IndicesPtr& indices)
  {
    fitting_.setIndices(indices);
    setSlabs(*indices, fitting_);
  }

  void setThreads(unsigned threads) { fitting_.setNumberOfThreads(threads); }

  void mend()
  {
    fitting_.setDistanceThreshold(0.05);
    fitting_.setGridSize(0.05);
    fitting_.setMinimumLength(0.2);
    fitting_.setRadiusLimits(0.15, 25);
    fitting_.setRooms(rooms_);
  }

  void spoil(int which)
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double inf = std::numeric_limits<double>::infinity();
    const double values[] = {0, nan, -0.05, inf, 0, -1};
    if (which < 2)
      fitting_.setDistanceThreshold(values[which]);
    else if (which < 4)
      fitting_.setGridSize(values[which]);
    else if (which < 6)
      fitting_.setMinimumLength(values[which]);
    else if (which < 8)
      fitting_.setRadiusLimits(which == 6 ? 0 : 2, which == 6 ? 25 : 1);
    else
      fitting_.setRooms({1, 2, 3});
  }

  Outcome run()
  {
    pcl::sedr::Floorplan plan;
    plan.rooms.resize(2);
    fitting_.segment(plan);
    Outcome outcome;
    outcome.error = fitting_.getErrorMessage();
    for (const auto& room : plan.rooms) {
      append(outcome.geometry, room.id);
      for (const auto* slab : {&room.floor, &room.ceiling}) {
        for (int k = 0; k < 4; ++k)
          append(outcome.geometry, slab->plane[k]);
        append(outcome.geometry, slab->inliers);
      }
      for (const auto& e : room.boundary.elements) {
        ++outcome.size;
        for (const double value : {e.start.x(), e.start.y(), e.radius, e.residual})
          append(outcome.geometry, value);
        append(outcome.geometry, e.inliers);
      }
    }
    outcome.all = outcome.geometry;
    return outcome;
  }

private:
  pcl::FloorplanFitting<pcl::PointXYZ> fitting_;
  std::vector<std::uint32_t> rooms_;
};

} // namespace contract
