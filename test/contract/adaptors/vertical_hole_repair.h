// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contract/sample_structure.h"

#include <pcl/sedr_filters/vertical_hole_repair.h>

#include <algorithm>

namespace contract {

/** The size is the number of retained scan points. Points that fill holes depend only
 * on the plan, and exist even without scan points. It has no threads. */
class VerticalHoleRepairAdaptor : public AdaptorDefaults {
public:
  static constexpr bool works_in_place = true;
  static constexpr int spoils = 7;

  void setInput(const Cloud::ConstPtr& cloud)
  {
    repair_.setInputCloud(cloud);
    setStructure(*between(*cloud, -10.f, 10.f));
  }

  void setIndices(const pcl::IndicesPtr& indices)
  {
    repair_.setIndices(indices);
    setStructure(*indices);
  }

  void mend()
  {
    repair_.setGridSize(0.05);
    repair_.setLabels(structure_.labels);
    repair_.setRooms(structure_.rooms);
  }

  void spoil(int which)
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double inf = std::numeric_limits<double>::infinity();
    const double sizes[] = {0, -0.05, nan, inf};
    if (which < 4)
      repair_.setGridSize(sizes[which]);
    else if (which == 4)
      repair_.setLabels({1, 2, 3});
    else if (which == 5)
      repair_.setRooms({1, 1});
    else
      repair_.setRooms({}); // the point type has none
  }

  Outcome run()
  {
    Cloud output;
    output.emplace_back(7.f, 7.f, 7.f);
    repair_.filter(output);
    return outcomeOf(output);
  }

  Outcome runInPlace(const Cloud::Ptr& cloud)
  {
    setInput(cloud);
    repair_.filter(*cloud);
    return outcomeOf(*cloud);
  }

private:
  void setStructure(const pcl::Indices& indices)
  {
    structure_ = SampleStructure(*repair_.getInputCloud(), indices);
    repair_.setFloorplan(structure_.plan);
    mend();
  }

  Outcome outcomeOf(const Cloud& output) const
  {
    Outcome outcome;
    outcome.error = repair_.getErrorMessage();
    outcome.kept = pcl::Indices();
    for (const auto i : repair_.getSourceIndices())
      if (i >= 0)
        outcome.kept->push_back(i);
    outcome.size = outcome.error.empty() ? outcome.kept->size() : output.size();
    outcome.removed = *repair_.getRemovedIndices();
    append(outcome.geometry, output);
    append(outcome.geometry, repair_.getSurfacePoints());
    append(outcome.geometry, repair_.getRepairedIndices());
    outcome.all = outcome.geometry;
    append(outcome.all, repair_.getSourceIndices());
    append(outcome.all, *outcome.removed);
    return outcome;
  }

  pcl::VerticalHoleRepair<pcl::PointXYZ> repair_{true};
  SampleStructure structure_;
};

} // namespace contract
