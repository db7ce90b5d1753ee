// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contract/sample_structure.h"

#include <pcl/sedr_filters/structure_refinement.h>

namespace contract {

class StructureRefinementAdaptor : public AdaptorDefaults {
public:
  static constexpr bool works_in_place = true;
  static constexpr int spoils = 7;

  void setInput(const Cloud::ConstPtr& cloud)
  {
    refinement_.setInputCloud(cloud);
    setStructure(*between(*cloud, -10.f, 10.f));
  }

  void setIndices(const pcl::IndicesPtr& indices)
  {
    refinement_.setIndices(indices);
    setStructure(*indices);
  }

  void setThreads(unsigned threads) { refinement_.setNumberOfThreads(threads); }

  void mend()
  {
    refinement_.setMaximumDistance(0.15);
    refinement_.setLabels(structure_.labels);
    refinement_.setRooms(structure_.rooms);
  }

  void spoil(int which)
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double inf = std::numeric_limits<double>::infinity();
    const double distances[] = {0, -0.15, nan, inf};
    if (which < 4)
      refinement_.setMaximumDistance(distances[which]);
    else if (which == 4)
      refinement_.setLabels({1, 2, 3});
    else if (which == 5)
      refinement_.setRooms({1, 1});
    else
      refinement_.setLabels({}); // the point type has none
  }

  Outcome run()
  {
    Cloud output;
    output.emplace_back(7.f, 7.f, 7.f);
    refinement_.filter(output);
    return outcomeOf(output);
  }

  Outcome runInPlace(const Cloud::Ptr& cloud)
  {
    setInput(cloud);
    refinement_.filter(*cloud);
    return outcomeOf(*cloud);
  }

private:
  void setStructure(const pcl::Indices& indices)
  {
    structure_ = SampleStructure(*refinement_.getInputCloud(), indices);
    refinement_.setFloorplan(structure_.plan);
    mend();
  }

  Outcome outcomeOf(const Cloud& output) const
  {
    Outcome outcome;
    outcome.size = output.size();
    outcome.error = refinement_.getErrorMessage();
    outcome.kept = refinement_.getSourceIndices();
    outcome.removed = *refinement_.getRemovedIndices();
    append(outcome.geometry, output);
    append(outcome.geometry, refinement_.getSurfacePoints());
    outcome.all = outcome.geometry;
    append(outcome.all, *outcome.kept);
    append(outcome.all, *outcome.removed);
    return outcome;
  }

  pcl::StructureRefinement<pcl::PointXYZ> refinement_{true};
  SampleStructure structure_;
};

} // namespace contract
