// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contract/contract.h"

#include <pcl/sedr_filters/floor_projection_recovery.h>

#include <algorithm>

namespace contract {

/** Only low points among the indices are floor; the ceiling is that of the sample room.
 */
class FloorProjectionRecoveryAdaptor : public AdaptorDefaults {
public:
  static constexpr bool works_in_place = true;
  static constexpr int spoils = 6;

  FloorProjectionRecoveryAdaptor() { mend(); }

  void setInput(const Cloud::ConstPtr& cloud)
  {
    recovery_.setInputCloud(cloud);
    recovery_.setCeilingIndices(between(*cloud, 2.4f, 2.6f));
  }

  void setIndices(const pcl::IndicesPtr& indices)
  {
    recovery_.setIndices(indices);
    recovery_.setCeilingIndices(ceilingAmong(*indices));
  }

  void mend()
  {
    recovery_.setGridSize(0.05);
    recovery_.setFloorCoefficients(nullptr);
  }

  void spoil(int which)
  {
    const double sizes[] = {0, -1, std::numeric_limits<double>::quiet_NaN(),
                            std::numeric_limits<double>::infinity()};
    if (which < 4) {
      recovery_.setGridSize(sizes[which]);
      return;
    }
    auto plane = std::make_shared<pcl::ModelCoefficients>();
    if (which == 4)
      plane->values = {1, 0, 0, 0};
    else
      plane->values = {0, 0, 1};
    recovery_.setFloorCoefficients(plane);
  }

  Outcome run()
  {
    Cloud output;
    output.emplace_back(7.f, 7.f, 7.f);
    recovery_.filter(output);
    return outcomeOf(output);
  }

  Outcome runInPlace(const Cloud::Ptr& cloud)
  {
    setInput(cloud);
    recovery_.filter(*cloud);
    return outcomeOf(*cloud);
  }

private:
  pcl::IndicesPtr ceilingAmong(const pcl::Indices& indices) const
  {
    const auto& cloud = *recovery_.getInputCloud();
    auto ceiling = std::make_shared<pcl::Indices>();
    for (const auto i : indices)
      if (i >= 0 && static_cast<std::size_t>(i) < cloud.size() &&
          cloud[static_cast<std::size_t>(i)].z > 2.4f)
        ceiling->push_back(i);
    return ceiling;
  }

  Outcome outcomeOf(const Cloud& output) const
  {
    Outcome outcome;
    outcome.size = output.size();
    outcome.error = recovery_.getErrorMessage();
    outcome.removed = *recovery_.getRemovedIndices();
    append(outcome.geometry, output);
    append(outcome.geometry, recovery_.getNumberOfProjected());
    outcome.all = outcome.geometry;
    append(outcome.all, *outcome.removed);
    append(outcome.all, recovery_.getProjectedIndices());
    outcome.kept = recovery_.getProjectedIndices();
    outcome.kept->resize(outcome.kept->size() - recovery_.getNumberOfProjected());
    return outcome;
  }

  pcl::FloorProjectionRecovery<pcl::PointXYZ> recovery_{true};
};

} // namespace contract
