// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contract/contract.h"

#include <pcl/sedr_segmentation/horizontal_plane_detection.h>

namespace contract {

/** The size is the number of inliers of all planes. Not applicable: it writes no cloud
 * and removes no points. */
class HorizontalPlaneDetectionAdaptor : public AdaptorDefaults {
public:
  static constexpr bool finds_in_one_point = false;
  static constexpr int spoils = 10;

  void setInput(const Cloud::ConstPtr& cloud) { detection_.setInputCloud(cloud); }

  void setIndices(const pcl::IndicesPtr& indices) { detection_.setIndices(indices); }

  void setThreads(unsigned threads) { detection_.setNumberOfThreads(threads); }

  void mend()
  {
    detection_.setDistanceThreshold(0.07);
    detection_.setGridSize(0.05);
    detection_.setMaximumTilt(0.0524);
    detection_.setMinimumArea(1);
    detection_.setMinimumRoomHeight(1.8);
  }

  void spoil(int which)
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double inf = std::numeric_limits<double>::infinity();
    const double values[] = {0, nan, -0.05, inf, -0.1, 1.6, 0, inf, 0, nan};
    switch (which / 2) {
    case 0:
      return detection_.setDistanceThreshold(values[which]);
    case 1:
      return detection_.setGridSize(values[which]);
    case 2:
      return detection_.setMaximumTilt(values[which]);
    case 3:
      return detection_.setMinimumArea(values[which]);
    default:
      return detection_.setMinimumRoomHeight(values[which]);
    }
  }

  Outcome run()
  {
    std::vector<pcl::HorizontalPlane> planes(3);
    detection_.segment(planes);
    Outcome outcome;
    outcome.error = detection_.getErrorMessage();
    for (const auto& plane : planes) {
      outcome.size += plane.inliers.indices.size();
      append(outcome.geometry, plane.coefficients.values);
      append(outcome.geometry, static_cast<int>(plane.kind));
      append(outcome.geometry, plane.cells);
      append(outcome.geometry, plane.area);
      append(outcome.geometry, plane.residual);
      append(outcome.all, plane.inliers.indices);
      if (detection_.getInputCloud())
        append(outcome.geometry,
               Cloud(*detection_.getInputCloud(), plane.inliers.indices));
    }
    outcome.all += outcome.geometry;
    return outcome;
  }

private:
  pcl::HorizontalPlaneDetection<pcl::PointXYZ> detection_;
};

} // namespace contract
