// SPDX-License-Identifier: BSD-3-Clause
#include "patch_normals.h"

#include "scan_tilt.h"
#include "sedr_filters/src/base/symmetric_eigen.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

constexpr double degree = M_PI / 180;

/** @brief Maximum deviations from a direction, one per round of the fit; the first
 * allows for the maximum tilt and uneven patches. */
constexpr double limits[] = {5 * degree, 2.5 * degree, 1.5 * degree, 1 * degree,
                             1 * degree};

/** @brief Returns the minimum number of patches for a direction: 4 square metres. */
std::size_t
fewestPatches(const Priors& priors)
{
  return static_cast<std::size_t>(4 * priors.min_slab_area /
                                  (priors.patch * priors.patch));
}

/** @brief Returns the direction perpendicular to the normals of vertical patches.
 * Returns z if they are too few or all have one direction in plan. */
Eigen::Vector3d
upOfWalls(const std::vector<Eigen::Vector3d>& normals, const Priors& priors)
{
  // Of the squared normals, perpendicular to the main direction.
  const double min_share = priors.share_unseen;
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  for (const double limit : limits) {
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    std::size_t count = 0;
    for (const auto& n : normals)
      if (std::abs(n.dot(up)) < std::sin(limit)) {
        squares.noalias() += n * n.transpose();
        ++count;
      }
    const SymmetricEigen<3> eigen = symmetricEigen(squares);
    if (count < fewestPatches(priors) ||
        eigen.values[1] < min_share * static_cast<double>(count))
      return Eigen::Vector3d::UnitZ();
    up = eigen.vectors.col(0);
    up *= up.z() < 0 ? -1 : 1;
  }
  return up;
}

/** @brief Returns the mean normal of level patches; z if there are too few. */
Eigen::Vector3d
upOfSlabs(const std::vector<Eigen::Vector3d>& normals, const Priors& priors)
{
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  for (const double limit : limits) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    std::size_t count = 0;
    for (const auto& n : normals)
      if (n.dot(up) > std::cos(limit)) {
        sum += n;
        ++count;
      }
    if (count < fewestPatches(priors))
      return Eigen::Vector3d::UnitZ();
    up = sum.normalized();
  }
  return up;
}

double
angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/** @brief Up directions from the patches of a rotated scan. */
struct PatchView {
  Eigen::Vector3d up_of_walls = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d up_of_slabs = Eigen::Vector3d::UnitZ();
};

/** @brief Returns the up directions from the patches of a rotated scan. A patch
 * boundary within the noise of a plane splits it obliquely into twice as many patches,
 * so the one of two grid offsets with fewer patches is used. */
PatchView
look(const PointView& points,
     const std::vector<int>& indices,
     const Eigen::Matrix3d& turn,
     double patch,
     unsigned threads,
     const Priors& priors)
{
  const std::vector<Eigen::Vector3d> here =
      normalsOf(points, indices, turn, patch, threads);
  const std::vector<Eigen::Vector3d> beside =
      normalsOf(points, indices, turn, patch, threads, 0.5);
  const auto& normals = beside.size() < here.size() ? beside : here;
  return {upOfWalls(normals, priors), upOfSlabs(normals, priors)};
}

} // namespace

ScanTilt
tiltOf(const PointView& points,
       const std::vector<int>& indices,
       unsigned threads,
       const Priors& priors)
{
  const double patch = priors.patch;
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  const PatchView scan =
      look(points, indices, Eigen::Matrix3d::Identity(), patch, threads, priors);
  const double angle = angleBetween(scan.up_of_walls, z);
  // The walls must agree better with the slabs than with z.
  if (angle < radians(priors.min_tilt) ||
      2 * angleBetween(scan.up_of_walls, scan.up_of_slabs) > angle)
    return {};
  // After levelling, larger patches give the remaining tilt, as thinning makes smaller
  // ones uneven.
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond::FromTwoVectors(scan.up_of_walls, z).toRotationMatrix();
  ScanTilt tilt;
  tilt.up = turn.transpose() *
            look(points, indices, turn, 2 * patch, threads, priors).up_of_walls;
  tilt.angle = angleBetween(tilt.up, z);
  return tilt;
}

} // namespace pcl::sedr
