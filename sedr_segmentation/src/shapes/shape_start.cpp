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

/** @brief The circle or sphere of least squares through places, by its algebraic
 * equation: centre and radius.
 * @return whether there is one, seen from within: its centre lies below the places */
template <int N>
bool
roundThrough(const std::vector<Eigen::Matrix<double, N, 1>>& places,
             Eigen::Matrix<double, N, 1>& centre,
             double& radius)
{
  using Row = Eigen::Matrix<double, N + 1, 1>;
  const Eigen::Matrix<double, N, 1> mean = meanOf(places);
  Eigen::Matrix<double, N + 1, N + 1> normal;
  normal.setZero();
  Row right = Row::Zero();
  for (const auto& place : places) {
    const Eigen::Matrix<double, N, 1> p = place - mean;
    Row row;
    row << p, 1;
    normal += row * row.transpose();
    right += row * p.squaredNorm();
  }
  const Row solution = normal.ldlt().solve(right);
  const Eigen::Matrix<double, N, 1> middle = solution.template head<N>() / 2;
  const double square = solution[N] + middle.squaredNorm();
  if (!solution.allFinite() || !(square > 0))
    return false;
  centre = mean + middle;
  radius = std::sqrt(square);
  return middle[N - 1] < 0;
}

/** @brief The direction in which points curve least, by a parabola of two directions.
 */
double
directionOfAxis(const std::vector<Eigen::Vector3d>& points)
{
  const Eigen::Vector3d mean = meanOf(points);
  std::vector<Eigen::Vector3d> centred;
  for (const Eigen::Vector3d& point : points)
    centred.emplace_back(point - mean);
  const QuadraticTerms c = fitQuadratic(centred);
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
  if (!roundThrough(places, centre, curve.across))
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
  Eigen::Vector3d centre;
  curve = SlabCurve();
  if (!roundThrough(points, centre, curve.up))
    return false;
  curve.kind = CurveKind::Ellipsoid;
  curve.centre = centre.head<2>();
  curve.base = centre.z();
  curve.along = curve.across = curve.up;
  return true;
}

} // namespace

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

QuadraticTerms
quadraticTerms(const Eigen::Vector2d& p)
{
  QuadraticTerms terms;
  terms << 1, p.x(), p.y(), p.x() * p.x(), p.x() * p.y(), p.y() * p.y();
  return terms;
}

QuadraticTerms
fitQuadratic(const std::vector<Eigen::Vector3d>& points)
{
  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
  QuadraticTerms right = QuadraticTerms::Zero();
  for (const Eigen::Vector3d& p : points) {
    const QuadraticTerms row = quadraticTerms(p.head<2>());
    normal.noalias() += row * row.transpose();
    right += p.z() * row;
  }
  return normal.ldlt().solve(right);
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
