// SPDX-License-Identifier: BSD-3-Clause
#include "patch_normals.h"

#include "scan_inclination.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief Returns the number of normals parallel to a direction. */
double
countAlong(const Eigen::Vector3d& direction,
           const std::vector<Eigen::Vector3d>& normals,
           const Priors& priors)
{
  const double least = std::cos(priors.same_axis);
  return static_cast<double>(
      std::count_if(normals.begin(), normals.end(), [&](const Eigen::Vector3d& n) {
        return std::abs(n.dot(direction)) > least;
      }));
}

/** @brief Returns the number of normals perpendicular to a direction but not to
 * `other`. */
double
countSquareTo(const Eigen::Vector3d& direction,
              const Eigen::Vector3d& other,
              const std::vector<Eigen::Vector3d>& normals,
              const Priors& priors)
{
  const double most = std::sin(priors.same_axis);
  return static_cast<double>(
      std::count_if(normals.begin(), normals.end(), [&](const Eigen::Vector3d& n) {
        return std::abs(n.dot(direction)) < most && std::abs(n.dot(other)) >= most;
      }));
}

/** @brief Returns the direction within 45 degrees of z with the most parallel normals.
 */
Eigen::Vector3d
commonUp(const std::vector<Eigen::Vector3d>& normals, const Priors& priors)
{
  constexpr std::size_t max_tried = 400;
  std::vector<Eigen::Vector3d> level;
  for (const auto& n : normals)
    if (n.z() > 0.7071)
      level.push_back(n);
  Eigen::Vector3d best = Eigen::Vector3d::UnitZ();
  double most = 0;
  const std::size_t step = level.size() / max_tried + 1;
  for (std::size_t k = 0; k < level.size(); k += step)
    if (const double along = countAlong(level[k], level, priors); along > most) {
      most = along;
      best = level[k];
    }
  for (int round = 0; round < 3; ++round) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto& n : level)
      if (n.dot(best) > std::cos(priors.same_axis))
        sum += n;
    if (sum.norm() > 0)
      best = sum.normalized();
  }
  return best;
}

} // namespace

ScanInclination
inclinationOf(const PointView& points,
              const std::vector<int>& indices,
              unsigned threads,
              const Priors& priors)
{
  // Doubled after the scan is levelled, as thinning makes tilted planes uneven over
  // half a metre.
  const double patch_size = priors.patch;
  constexpr double times_more_level = 3;
  constexpr double times_more_vertical = 2;
  constexpr double least_level = 0.1; // of all patches: less is no floor of a room
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  std::vector<Eigen::Vector3d> normals;
  const auto turnUp = [&](double patch) {
    normals = normalsOf(points, indices, turn, patch, threads);
    turn = Eigen::Quaterniond::FromTwoVectors(commonUp(normals, priors), z) * turn;
  };
  const auto isVertical = [&] {
    return std::acos(std::clamp(turn(2, 2), -1.0, 1.0)) < 2 * priors.same_axis;
  };
  ScanInclination inclination;
  turnUp(patch_size);
  if (isVertical())
    return inclination; // the common direction agrees with z
  turnUp(patch_size);
  const double level = countAlong(z, normals, priors);
  const Eigen::Vector3d was_z = turn * z;
  if (level * patch_size * patch_size < 4 * priors.min_slab_area ||
      level < least_level * static_cast<double>(normals.size()) ||
      level < times_more_level * countAlong(was_z, normals, priors) ||
      countSquareTo(z, was_z, normals, priors) <
          times_more_vertical * countSquareTo(was_z, z, normals, priors))
    return inclination;
  turnUp(2 * patch_size);
  if (isVertical())
    return inclination;
  inclination.up = turn.transpose() * z;
  inclination.angle = std::acos(std::clamp(inclination.up.z(), -1.0, 1.0));
  inclination.area = level * patch_size * patch_size;
  return inclination;
}

} // namespace pcl::sedr
