// SPDX-License-Identifier: BSD-3-Clause
#include "shape_fit.h"

#include "sedr_filters/src/base/symmetric_eigen.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace pcl::sedr {

namespace {

PlanSlab
slabFrom(SlabCurve curve, const PlanSlab& plane)
{
  PlanSlab slab = plane;
  slab.curve = std::make_shared<const SlabCurve>(std::move(curve));
  return slab;
}

/** @brief The circle of least squares through places (v, z), by its algebraic equation:
 * centre and radius.
 * @return whether there is one, seen from within */
bool
fitCircle(const std::vector<Eigen::Vector2d>& places,
          Eigen::Vector2d& centre,
          double& radius)
{
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& p : places)
    mean += p / static_cast<double>(places.size());
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Eigen::Vector2d& place : places) {
    const Eigen::Vector2d p = place - mean;
    const Eigen::Vector3d row(p.x(), p.y(), 1);
    normal += row * row.transpose();
    right += row * p.squaredNorm();
  }
  const Eigen::Vector3d solution = normal.ldlt().solve(right);
  const Eigen::Vector2d middle = solution.head<2>() / 2;
  const double square = solution[2] + middle.squaredNorm();
  if (!solution.allFinite() || !(square > 0))
    return false;
  centre = mean + middle;
  radius = std::sqrt(square);
  return middle.y() < 0; // the centre lies below the points
}

/** @brief The direction in which points curve least, by a parabola of two directions.
 */
double
directionOfAxis(const std::vector<Eigen::Vector3d>& points)
{
  const Eigen::Vector3d mean = meanOf(points);
  using Terms = Eigen::Matrix<double, 6, 1>;
  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
  Terms right = Terms::Zero();
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3d p = point - mean;
    Terms row;
    row << 1, p.x(), p.y(), p.x() * p.x(), p.x() * p.y(), p.y() * p.y();
    normal.noalias() += row * row.transpose();
    right += p.z() * row;
  }
  const Terms c = normal.ldlt().solve(right);
  Eigen::Matrix2d bend;
  bend << 2 * c[3], c[4], c[4], 2 * c[5];
  const SymmetricEigen<2> eigen = symmetricEigen(bend);
  const int flat = std::abs(eigen.values[0]) < std::abs(eigen.values[1]) ? 0 : 1;
  const Eigen::Vector2d axis = eigen.vectors.col(flat);
  return std::atan2(axis.y(), axis.x());
}

/** @brief The round cylinder along a direction; false where there is none. */
bool
cylinderAlong(const std::vector<Eigen::Vector3d>& points,
              double direction,
              SlabCurve& curve)
{
  const Eigen::Rotation2Dd turn(-direction);
  std::vector<Eigen::Vector2d> places;
  places.reserve(points.size());
  double along = 0;
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector2d local = turn * p.head<2>();
    along += local.x() / static_cast<double>(points.size());
    places.emplace_back(local.y(), p.z());
  }
  Eigen::Vector2d centre;
  curve = SlabCurve();
  if (!fitCircle(places, centre, curve.across))
    return false;
  curve.up = curve.across;
  curve.setDirection(direction);
  curve.centre = turn.inverse() * Eigen::Vector2d(along, centre.x());
  curve.base = centre.y();
  return true;
}

bool
sphereThrough(const std::vector<Eigen::Vector3d>& points, SlabCurve& curve)
{
  const Eigen::Vector3d mean = meanOf(points);
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3d p = point - mean;
    const Eigen::Vector4d row(p.x(), p.y(), p.z(), 1);
    normal += row * row.transpose();
    right += row * p.squaredNorm();
  }
  const Eigen::Vector4d solution = normal.ldlt().solve(right);
  const Eigen::Vector3d middle = solution.head<3>() / 2;
  const double square = solution[3] + middle.squaredNorm();
  if (!solution.allFinite() || !(square > 0) || middle.z() >= 0)
    return false;
  curve = SlabCurve();
  curve.kind = CurveKind::Ellipsoid;
  curve.centre = mean.head<2>() + middle.head<2>();
  curve.base = mean.z() + middle.z();
  curve.along = curve.across = curve.up = std::sqrt(square);
  return true;
}

} // namespace

Eigen::Vector3d
meanOf(const std::vector<Eigen::Vector3d>& points)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points)
    sum += p;
  return sum / static_cast<double>(points.size());
}

PlanSlab
planeThrough(const Eigen::Vector3d& place, const Eigen::Vector2d& slope)
{
  PlanSlab slab;
  const Eigen::Vector3d normal =
      Eigen::Vector3d(-slope.x(), -slope.y(), 1).normalized();
  slab.plane << normal, -normal.dot(place);
  return slab;
}

PlanSlab
fitPlane(const std::vector<Eigen::Vector3d>& points)
{
  const Eigen::Vector3d mean = meanOf(points);
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3d p = point - mean;
    normal += p.head<2>() * p.head<2>().transpose();
    right += p.head<2>() * p.z();
  }
  const Eigen::Vector2d slope = normal.ldlt().solve(right);
  return planeThrough(mean, slope.allFinite() ? slope : Eigen::Vector2d(0, 0));
}

PlanSlab
startShape(ShapeKind kind,
           const std::vector<Eigen::Vector3d>& points,
           const std::vector<double>& directions)
{
  if (kind == ShapeKind::Level)
    return planeThrough(meanOf(points), Eigen::Vector2d::Zero());
  const PlanSlab plane = fitPlane(points);
  if (kind == ShapeKind::Plane)
    return plane;
  SlabCurve curve;
  if (kind == ShapeKind::Sphere || kind == ShapeKind::Ellipsoid)
    return sphereThrough(points, curve) ? slabFrom(curve, plane) : plane;
  std::vector<double> tried = directions;
  tried.push_back(directionOfAxis(points));
  PlanSlab best = plane;
  double least = std::numeric_limits<double>::infinity();
  for (const double direction : tried) {
    if (!cylinderAlong(points, direction, curve))
      continue;
    const PlanSlab slab = slabFrom(curve, plane);
    double sum = 0;
    for (const Eigen::Vector3d& p : points)
      sum += std::abs(distanceOf(slab, p));
    if (sum < least) {
      least = sum;
      best = slab;
    }
  }
  return best;
}

} // namespace pcl::sedr
