// SPDX-License-Identifier: BSD-3-Clause
#include "shape_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace sedr {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using Parameters = Eigen::VectorXd;

Eigen::Vector3d
meanOf(const std::vector<Eigen::Vector3d>& points)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points)
    sum += p;
  return sum / static_cast<double>(points.size());
}

PlanSlab
planeFrom(const Eigen::Vector2d& slope, const Eigen::Vector3d& through)
{
  PlanSlab slab;
  const Eigen::Vector3d normal =
      Eigen::Vector3d(-slope.x(), -slope.y(), 1).normalized();
  slab.plane << normal, -normal.dot(through);
  return slab;
}

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
  Eigen::MatrixXd rows(points.size(), 6);
  Eigen::VectorXd heights(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d p = points[i] - mean;
    rows.row(static_cast<Eigen::Index>(i)) << 1, p.x(), p.y(), p.x() * p.x(),
        p.x() * p.y(), p.y() * p.y();
    heights[static_cast<Eigen::Index>(i)] = p.z();
  }
  const Eigen::VectorXd c =
      (rows.transpose() * rows).ldlt().solve(rows.transpose() * heights);
  Eigen::Matrix2d bend;
  bend << 2 * c[3], c[4], c[4], 2 * c[5];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(bend);
  const int flat =
      std::abs(solver.eigenvalues()[0]) < std::abs(solver.eigenvalues()[1]) ? 0 : 1;
  const Eigen::Vector2d axis = solver.eigenvectors().col(flat);
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

/** @brief The numbers that say what a slab is, about a place of it, and back. */
Parameters
numbersOf(ShapeKind kind, const PlanSlab& slab, const Eigen::Vector3d& about)
{
  if (kind == ShapeKind::Plane) {
    const Eigen::Vector3d n = slab.plane.head<3>();
    return Eigen::Vector3d(-n.x() / n.z(), -n.y() / n.z(),
                           slab.heightAt(about.head<2>()) - about.z());
  }
  const SlabCurve& c = *slab.curve;
  const Eigen::Vector2d off = c.centre - about.head<2>();
  Parameters numbers(parametersOf(kind));
  switch (kind) {
  case ShapeKind::Cylinder:
  case ShapeKind::EllipticCylinder: {
    const Eigen::Vector2d aside(-c.axis.y(), c.axis.x());
    // By the height of the crown, on which a shallow vault's radius hardly depends.
    numbers.head<4>() << c.direction(), off.dot(aside), c.base + c.up - about.z(),
        1 / c.across;
    if (kind == ShapeKind::EllipticCylinder)
      numbers[4] = 1 / c.up;
    break;
  }
  case ShapeKind::Sphere:
    numbers << off.x(), off.y(), c.base + c.up - about.z(), 1 / c.up;
    break;
  default:
    numbers << off.x(), off.y(), c.base + c.up - about.z(), c.direction(), 1 / c.along,
        1 / c.across, 1 / c.up;
  }
  return numbers;
}

/** @return whether the numbers say a slab */
bool
takeNumbers(ShapeKind kind,
            const Parameters& numbers,
            const Eigen::Vector3d& about,
            PlanSlab& slab)
{
  if (!numbers.allFinite())
    return false;
  if (kind == ShapeKind::Plane) {
    slab.plane =
        planeFrom(numbers.head<2>(), about + Eigen::Vector3d(0, 0, numbers[2])).plane;
    return true;
  }
  SlabCurve c = *slab.curve;
  switch (kind) {
  case ShapeKind::Cylinder:
  case ShapeKind::EllipticCylinder:
    c.setDirection(numbers[0]);
    c.centre = about.head<2>() + numbers[1] * Eigen::Vector2d(-c.axis.y(), c.axis.x());
    c.across = 1 / numbers[3];
    c.up = kind == ShapeKind::Cylinder ? c.across : 1 / numbers[4];
    break;
  case ShapeKind::Sphere:
    c.centre = about.head<2>() + numbers.head<2>();
    c.along = c.across = c.up = 1 / numbers[3];
    break;
  default:
    c.centre = about.head<2>() + numbers.head<2>();
    c.setDirection(numbers[3]);
    c.along = 1 / numbers[4];
    c.across = 1 / numbers[5];
    c.up = 1 / numbers[6];
  }
  c.base = about.z() + numbers[2] - c.up;
  if (!c.isFinite())
    return false;
  slab.curve = std::make_shared<const SlabCurve>(c);
  return true;
}

double
biweight(double share)
{
  const double rest = 1 - share * share;
  return std::abs(share) < 1 ? rest * rest : 0;
}

/** @brief Tukey's cost of all distances, and the sums of a step towards less. */
double
costOf(const std::vector<Eigen::Vector3d>& points, const PlanSlab& slab, double band)
{
  double cost = 0;
  for (const Eigen::Vector3d& p : points) {
    const double share = distanceOf(slab, p) / band;
    const double rest = 1 - share * share;
    cost += std::abs(share) < 1 ? 1 - rest * rest * rest : 1;
  }
  return cost;
}

} // namespace

int
parametersOf(ShapeKind kind)
{
  switch (kind) {
  case ShapeKind::Plane:
    return 3;
  case ShapeKind::Cylinder:
  case ShapeKind::Sphere:
    return 4;
  case ShapeKind::EllipticCylinder:
    return 5;
  case ShapeKind::Ellipsoid:
    return 7;
  }
  return 7;
}

double
distanceOf(const PlanSlab& slab, const Eigen::Vector3d& p)
{
  return slab.curve ? slab.curve->distanceAbove(p)
                    : slab.plane.head<3>().dot(p) + slab.plane[3];
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
  return planeFrom(slope.allFinite() ? slope : Eigen::Vector2d(0, 0), mean);
}

PlanSlab
startShape(ShapeKind kind,
           const std::vector<Eigen::Vector3d>& points,
           const std::vector<double>& directions)
{
  const PlanSlab plane = fitPlane(points);
  if (kind == ShapeKind::Plane)
    return plane;
  SlabCurve curve;
  if (kind == ShapeKind::Sphere || kind == ShapeKind::Ellipsoid)
    return sphereThrough(points, curve) ? slabFrom(curve, plane) : plane;
  std::vector<double> tried = directions;
  tried.push_back(directionOfAxis(points));
  PlanSlab best = plane;
  double least = infinity;
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

double
refineShape(ShapeKind kind,
            const std::vector<Eigen::Vector3d>& points,
            double deviation,
            PlanSlab& slab)
{
  constexpr int most_steps = 30;
  constexpr double settled = 1e-6; // of the cost
  constexpr double cut = 4.7;      // of Tukey's biweight, standard deviations
  const double band = cut * deviation;
  if (points.empty() || (kind != ShapeKind::Plane && !slab.curve))
    return infinity;
  const Eigen::Vector3d about = meanOf(points);
  Parameters numbers = numbersOf(kind, slab, about);
  const Eigen::Index count = numbers.size();
  double cost = costOf(points, slab, band);
  double damping = 1e-6;
  for (int step = 0; step < most_steps; ++step) {
    std::vector<PlanSlab> moved(static_cast<std::size_t>(count), slab);
    constexpr double nudge = 1e-6;
    for (Eigen::Index k = 0; k < count; ++k) {
      Parameters near = numbers;
      near[k] += nudge;
      takeNumbers(kind, near, about, moved[static_cast<std::size_t>(k)]);
    }
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
    Eigen::VectorXd row(count);
    for (const Eigen::Vector3d& p : points) {
      const double distance = distanceOf(slab, p);
      const double weight = biweight(distance / band);
      if (weight <= 0)
        continue;
      for (Eigen::Index k = 0; k < count; ++k)
        row[k] = (distanceOf(moved[static_cast<std::size_t>(k)], p) - distance) / nudge;
      normal.noalias() += weight * row * row.transpose();
      right -= weight * distance * row;
    }
    bool is_better = false;
    double gain = 0;
    for (int tries = 0; tries < 8 && !is_better; ++tries) {
      Eigen::MatrixXd damped = normal;
      damped.diagonal() *= 1 + damping;
      damped.diagonal().array() += 1e-12 * normal.diagonal().maxCoeff();
      const Parameters next = numbers + damped.ldlt().solve(right);
      PlanSlab there = slab;
      is_better = takeNumbers(kind, next, about, there);
      const double cost_there = is_better ? costOf(points, there, band) : infinity;
      is_better = cost_there < cost;
      damping = is_better ? damping / 10 : damping * 20 + 1e-9;
      if (!is_better)
        continue;
      gain = cost - cost_there;
      cost = cost_there;
      slab = there;
      numbers = next;
    }
    if (!is_better || gain < settled * cost)
      break;
  }
  double sum = 0;
  double weights = 0;
  for (const Eigen::Vector3d& p : points) {
    const double distance = distanceOf(slab, p);
    const double weight = biweight(distance / band);
    sum += weight * distance * distance;
    weights += weight;
  }
  return weights > 0 ? std::sqrt(sum / weights) : infinity;
}

} // namespace sedr
} // namespace pcl
