// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contract/contract.h"

#include <pcl/sedr_segmentation/grid_slice_detail.h>

#include <cmath>

namespace contract {

/** Adds a soffit to the sample room point by point: the ceiling beyond y = 0.9 is
 * lowered by 0.4 m, and the wall above it becomes the riser.
 *
 * Not applicable: two rooms, since it works on one; it writes no cloud and removes no
 * points. */
class GridSliceDetailAdaptor : public AdaptorDefaults {
public:
  static constexpr bool finds_in_one_point = false;
  static constexpr bool takes_one_room = true;
  static constexpr int spoils = 10;

  GridSliceDetailAdaptor() { analysis_.setFloorHeight(0); }

  void setInput(const Cloud::ConstPtr& cloud)
  {
    const auto built = std::make_shared<Cloud>(*cloud);
    for (auto& p : *built)
      buildSoffit(p);
    analysis_.setInputCloud(built);
    analysis_.setCeilingIndices(between(*built, 2.45f, 2.55f));
  }

  void setIndices(const pcl::IndicesPtr& indices)
  {
    analysis_.setIndices(indices);
    const auto& cloud = *analysis_.getInputCloud();
    const auto ceiling = std::make_shared<pcl::Indices>();
    for (const auto i : *indices)
      if (i >= 0 && static_cast<std::size_t>(i) < cloud.size() &&
          std::abs(cloud[static_cast<std::size_t>(i)].z - 2.5f) < 0.05f)
        ceiling->push_back(i);
    analysis_.setCeilingIndices(ceiling);
  }

  void setThreads(unsigned threads) { analysis_.setNumberOfThreads(threads); }

  void mend()
  {
    analysis_.setGridSize(0.05);
    analysis_.setDistanceThreshold(0.07);
    analysis_.setSliceThickness(0.1);
    analysis_.setTrials(3);
    analysis_.setMinimumIslandArea(0.5);
  }

  void spoil(int which)
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double inf = std::numeric_limits<double>::infinity();
    const double values[] = {0, nan, -1, inf, 0, -0.1, 0, 4, -1, nan};
    switch (which / 2) {
    case 0:
      return analysis_.setGridSize(values[which]);
    case 1:
      return analysis_.setDistanceThreshold(values[which]);
    case 2:
      return analysis_.setSliceThickness(values[which]);
    case 3:
      return analysis_.setTrials(static_cast<int>(values[which]));
    default:
      return analysis_.setMinimumIslandArea(values[which]);
    }
  }

  Outcome run()
  {
    pcl::PointIndices details;
    details.indices = {1, 2, 3};
    analysis_.segment(details);
    Outcome outcome;
    outcome.size = details.indices.size();
    outcome.error = analysis_.getErrorMessage();
    append(outcome.geometry, analysis_.getRegionLabels());
    append(outcome.geometry, analysis_.getRegionSizes());
    append(outcome.geometry, analysis_.getTrial());
    if (!details.indices.empty())
      append(outcome.geometry, analysis_.getSliceHeight());
    if (analysis_.getInputCloud())
      append(outcome.geometry, Cloud(*analysis_.getInputCloud(), details.indices));
    outcome.all = outcome.geometry;
    append(outcome.all, details.indices);
    return outcome;
  }

private:
  static void buildSoffit(pcl::PointXYZ& p)
  {
    if (!(p.y > 0.9f) || !(p.z > 2.1f))
      return;
    if (p.y > 1.45f && p.z < 2.45f)
      p.y -= 0.6f;
    else
      p.z -= 0.4f;
  }

  pcl::GridSliceDetail<pcl::PointXYZ> analysis_;
};

} // namespace contract
