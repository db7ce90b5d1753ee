// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "viewed_result.h"

#include <Eigen/Core>

namespace pcl {
namespace sedr {
namespace tools {

/** @brief Where a camera stands and looks; metres, z up. */
struct CameraPose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d focus = Eigen::Vector3d::UnitX();
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  double view_angle = 30; ///< from top to bottom, degrees
};

/** @brief The pose of a view point: from the top and from aslant so that the model
 * fills the window; inside at the height of eyes in the largest room of the plan,
 * looking along its longest free way (without a plan from the middle of the box).
 * @param aspect width of the window over its height
 * @param storey number of the one whose largest room that is; 0: of any */
CameraPose cameraPose(const ViewedResult& result,
                      ViewPoint view_point,
                      double aspect,
                      std::uint32_t storey = 0);

} // namespace tools
} // namespace sedr
} // namespace pcl
