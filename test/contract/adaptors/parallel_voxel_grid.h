// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contract/contract.h"

#include <pcl/sedr_filters/parallel_voxel_grid.h>

namespace contract {

/** Voxels of 10 cm, some of which contain several points. */
class ParallelVoxelGridAdaptor : public AdaptorDefaults {
public:
  static constexpr bool works_in_place = true;
  static constexpr int spoils = 5;

  ParallelVoxelGridAdaptor() { mend(); }

  void setInput(const Cloud::ConstPtr& cloud) { grid_.setInputCloud(cloud); }

  void setIndices(const pcl::IndicesPtr& indices) { grid_.setIndices(indices); }

  void setThreads(unsigned threads) { grid_.setNumberOfThreads(threads); }

  void mend()
  {
    grid_.setLeafSize(0.1f, 0.1f, 0.1f);
    grid_.setFilterFieldName("");
    grid_.setSaveLeafLayout(true);
  }

  void spoil(int which)
  {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float leaves[] = {0.f, -1.f, nan, std::numeric_limits<float>::infinity(),
                            1e-45f};
    grid_.setLeafSize(0.1f, leaves[which], 0.1f);
  }

  Outcome run()
  {
    Cloud output;
    output.emplace_back(7.f, 7.f, 7.f);
    grid_.filter(output);
    return outcomeOf(output);
  }

  Outcome runInPlace(const Cloud::Ptr& cloud)
  {
    setInput(cloud);
    grid_.filter(*cloud);
    return outcomeOf(*cloud);
  }

private:
  Outcome outcomeOf(const Cloud& output) const
  {
    Outcome outcome;
    outcome.size = output.size();
    outcome.error = grid_.getErrorMessage();
    outcome.removed = *grid_.getRemovedIndices();
    append(outcome.geometry, output);
    outcome.all = outcome.geometry;
    append(outcome.all, *outcome.removed);
    for (const auto& p : output)
      append(outcome.all, grid_.getCentroidIndex(p));
    return outcome;
  }

  pcl::ParallelVoxelGrid<pcl::PointXYZ> grid_{true};
};

} // namespace contract
