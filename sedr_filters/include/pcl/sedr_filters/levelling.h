// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace sedr {

/** @brief The turn that makes a tilted scan level, about a place of it, so that far
 * from the origin nothing moves far; metres. */
struct Levelling {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d about = Eigen::Vector3d::Zero();

  /** @brief The least turn that brings the direction `up` to z. */
  static Levelling of(const Eigen::Vector3d& up, const Eigen::Vector3d& about)
  {
    return {Eigen::Quaterniond::FromTwoVectors(up, Eigen::Vector3d::UnitZ())
                .toRotationMatrix(),
            about};
  }

  /** @brief A place of the scan in the levelled frame. */
  Eigen::Vector3d level(const Eigen::Vector3d& p) const
  {
    return rotation * (p - about) + about;
  }

  /** @brief A place of the levelled frame in that of the scan. */
  Eigen::Vector3d back(const Eigen::Vector3d& p) const
  {
    return rotation.transpose() * (p - about) + about;
  }

  /** @brief Between the scan's up and z, radians. */
  double angle() const { return std::acos(std::clamp(rotation(2, 2), -1.0, 1.0)); }

  /** @brief Direction in plan in which the scan's up is tilted, radians from x. */
  double direction() const { return std::atan2(rotation(2, 1), rotation(2, 0)); }
};

} // namespace sedr
} // namespace pcl
