// SPDX-License-Identifier: BSD-3-Clause
#include "patch_normals.h"

#include "scan_tilt.h"
#include "sedr_filters/src/base/plane_fit.h"

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

/** @brief A direction and the number of patches that have it. */
struct Common {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  std::size_t count = 0;                             ///< 0 if they are too few
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero(); ///< of their normals
};

/** @brief Returns the direction near `up` to which vertical patches are parallel. None
 * if they are too few or all have one direction in plan. */
Common
upOfWalls(const std::vector<Eigen::Vector3d>& normals,
          const Eigen::Vector3d& up,
          const Priors& priors)
{
  // Of the squared normals, perpendicular to the main direction.
  const double min_share = priors.share_unseen;
  Common walls{up};
  for (const double limit : limits) {
    walls.squares.setZero();
    walls.count = 0;
    for (const auto& n : normals)
      if (std::abs(n.dot(walls.direction)) < std::sin(limit)) {
        walls.squares.noalias() += n * n.transpose();
        ++walls.count;
      }
    const SymmetricEigen<3> eigen = symmetricEigen(walls.squares);
    if (walls.count < fewestPatches(priors) ||
        eigen.values[1] < min_share * static_cast<double>(walls.count))
      return {};
    walls.direction = eigen.vectors.col(0);
    walls.direction *= walls.direction.z() < 0 ? -1 : 1;
  }
  return walls;
}

/** @brief Returns the mean normal of level patches near `up`; none if there are too
 * few. */
Common
upOfSlabs(const std::vector<Eigen::Vector3d>& normals,
          const Eigen::Vector3d& up,
          const Priors& priors)
{
  Common slabs{up};
  for (const double limit : limits) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    slabs.squares.setZero();
    slabs.count = 0;
    for (const auto& n : normals)
      if (n.dot(slabs.direction) > std::cos(limit)) {
        sum += n;
        slabs.squares.noalias() += n * n.transpose();
        ++slabs.count;
      }
    if (slabs.count < fewestPatches(priors))
      return {};
    slabs.direction = sum.normalized();
  }
  return slabs;
}

/** @brief Returns the commonest of some normals within 45 degrees of z; z if there is
 * none. */
Eigen::Vector3d
commonestUp(const std::vector<Eigen::Vector3d>& normals)
{
  constexpr std::size_t max_tried = 400;
  std::vector<Eigen::Vector3d> level;
  for (const auto& n : normals)
    if (n.z() > std::cos(45 * degree))
      level.push_back(n);
  Eigen::Vector3d best = Eigen::Vector3d::UnitZ();
  std::ptrdiff_t most = 0;
  for (std::size_t k = 0; k < level.size(); k += level.size() / max_tried + 1) {
    const auto along = std::count_if(level.begin(), level.end(), [&](const auto& n) {
      return n.dot(level[k]) > std::cos(limits[2]);
    });
    if (along > most) {
      most = along;
      best = level[k];
    }
  }
  return best;
}

double
angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/** @brief Returns the normals of the patches of a rotated scan. A patch boundary within
 * the noise of a plane splits it obliquely into twice as many patches, so the one of
 * two grid offsets with fewer patches is used. */
std::vector<Eigen::Vector3d>
patchNormals(const PointView& points,
             const std::vector<int>& indices,
             const Eigen::Matrix3d& turn,
             double patch,
             unsigned threads)
{
  const auto here = planesOf(points, indices, turn, patch, threads);
  const auto beside = planesOf(points, indices, turn, patch, threads, 0.5);
  std::vector<Eigen::Vector3d> normals;
  for (const PlanePatch& plane : beside.size() < here.size() ? beside : here)
    normals.push_back(plane.normal);
  return normals;
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
  ScanTilt tilt;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  // After levelling, larger patches give the remaining tilt, as thinning makes smaller
  // ones uneven; small rooms have too few of them.
  for (const double size : {patch, patch, 2 * patch}) {
    const auto normals = patchNormals(points, indices, turn, size, threads);
    Common walls = upOfWalls(normals, z, priors);
    const Common other = upOfWalls(normals, commonestUp(normals), priors);
    // A slope and the gables beside it are no tilted floor and its walls where there is
    // a level floor.
    if (other.count > walls.count && upOfSlabs(normals, other.direction, priors).count >
                                         2 * upOfSlabs(normals, z, priors).count)
      walls = other;
    const Common slabs = upOfSlabs(normals, walls.direction, priors);
    const double angle = angleBetween(walls.direction, turn * z);
    // The walls must agree better with the slabs than with z.
    if (walls.count == 0 || slabs.count == 0 || angle < radians(priors.min_tilt) ||
        2 * angleBetween(walls.direction, slabs.direction) > angle)
      break;
    Eigen::Vector3d up =
        symmetricEigen(Eigen::Matrix3d(walls.squares - slabs.squares)).vectors.col(0);
    up *= up.z() < 0 ? -1 : 1;
    turn = Eigen::Quaterniond::FromTwoVectors(up, z) * turn;
    tilt.up = turn.transpose() * z;
    tilt.angle = angleBetween(tilt.up, z);
    tilt.area = static_cast<double>(slabs.count) * size * size;
  }
  return tilt;
}

} // namespace pcl::sedr
