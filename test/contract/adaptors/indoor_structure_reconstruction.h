// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contract/sample_structure.h"

#include <pcl/sedr_surface/indoor_structure_reconstruction.h>

namespace contract {

/** The size is the number of points of the structure. The mesh is not made, to save
 * time; StructuralPoisson has a contract of its own.
 *
 * Not applicable: it writes no cloud in place and removes no points. */
class IndoorStructureReconstructionAdaptor : public AdaptorDefaults {
public:
  static constexpr bool finds_in_one_point = false;
  static constexpr int spoils = 8;

  void setInput(const Cloud::ConstPtr& cloud) { reconstruction_.setInputCloud(cloud); }

  void setIndices(const pcl::IndicesPtr& indices)
  {
    reconstruction_.setIndices(indices);
  }

  void setThreads(unsigned threads) { reconstruction_.setNumberOfThreads(threads); }

  void mend()
  {
    reconstruction_.setVoxelSize(0.05f);
    reconstruction_.setPlaneTolerance(0.07);
    reconstruction_.setGridSize(0.05);
    reconstruction_.setBoundaryEstimation(M_PI / 3, 200);
    reconstruction_.setBoundaryTolerance(0.05);
  }

  void spoil(int which)
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    switch (which) {
    case 0:
      return reconstruction_.setVoxelSize(0);
    case 1:
      return reconstruction_.setVoxelSize(-0.05f);
    case 2:
      return reconstruction_.setPlaneTolerance(0);
    case 3:
      return reconstruction_.setGridSize(nan);
    case 4:
      return reconstruction_.setGridSize(-1);
    case 5:
      return reconstruction_.setBoundaryEstimation(-1, 200);
    case 6:
      return reconstruction_.setBoundaryEstimation(M_PI / 3, 2);
    default:
      return reconstruction_.setBoundaryTolerance(0);
    }
  }

  Outcome run()
  {
    reconstruction_.findStructure();
    Outcome outcome;
    outcome.error = reconstruction_.getErrorMessage();
    const auto structure = reconstruction_.getStructure();
    outcome.size = structure->size();
    for (const auto& p : *structure) {
      for (const float value : {p.x, p.y, p.z, p.normal_x, p.normal_y, p.normal_z})
        append(outcome.geometry, value);
      append(outcome.geometry, p.label);
      append(outcome.geometry, p.room);
    }
    for (const auto& room : reconstruction_.getFloorplan()->rooms)
      for (const auto& e : room.boundary.elements) {
        append(outcome.geometry, e.start.x());
        append(outcome.geometry, e.start.y());
      }
    outcome.all = outcome.geometry;
    outcome.all += reconstruction_.getFailedStage();
    return outcome;
  }

private:
  pcl::IndoorStructureReconstruction<pcl::PointXYZ> reconstruction_;
};

} // namespace contract
