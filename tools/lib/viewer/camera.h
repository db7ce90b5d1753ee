// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "viewed_result.h"

#include <Eigen/Core>

namespace pcl::sedr::tools {

/** @brief Position and direction of a camera; metres, z up. */
struct CameraPose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d focus = Eigen::Vector3d::UnitX();
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  double view_angle = 30; ///< vertical, degrees
};

/** @brief Returns the pose of a view point. From above or oblique, the model fills the
 * window. Inside, the camera is at eye height in the largest room of the plan and looks
 * along its longest free line (without a plan, from the centre of the box).
 * @param aspect width of the window over its height
 * @param storey number of the largest room's storey; 0: any */
CameraPose cameraPose(const ViewedResult& result,
                      ViewPoint view_point,
                      double aspect,
                      std::uint32_t storey = 0);

} // namespace pcl::sedr::tools
