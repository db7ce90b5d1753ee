// SPDX-License-Identifier: BSD-3-Clause
#include "shape_fit.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace sedr {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/** @brief The numbers of a shape, seven at most. */
using Parameters = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 7, 1>;
using Normal = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 7, 7>;

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
        planeThrough(about + Eigen::Vector3d(0, 0, numbers[2]), numbers.head<2>())
            .plane;
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

/** @brief Distances from a shape, and how they grow with its numbers. */
class ShapeDistance {
public:
  ShapeDistance(ShapeKind kind, const PlanSlab& slab, const Eigen::Vector3d& about)
      : kind_(kind)
      , about_(about)
      , plane_(slab.plane)
  {
    if (kind == ShapeKind::Plane)
      return;
    const SlabCurve& c = *slab.curve;
    axis_ = c.axis;
    aside_ = Eigen::Vector2d(-c.axis.y(), c.axis.x());
    centre_ = Eigen::Vector3d(c.centre.x(), c.centre.y(), c.base);
    const double along = c.kind == CurveKind::Ellipsoid ? 1 / c.along : 0;
    inverse_ = Eigen::Vector3d(along, 1 / c.across, 1 / c.up);
  }

  /** @brief As distanceOf(). */
  double operator()(const Eigen::Vector3d& p) const
  {
    if (kind_ == ShapeKind::Plane)
      return plane_.head<3>().dot(p) + plane_[3];
    return at(p).distance;
  }

  /** @brief The distance, and its derivative by each number. */
  double operator()(const Eigen::Vector3d& p, Parameters& growth) const
  {
    if (kind_ == ShapeKind::Plane) {
      const double distance = plane_.head<3>().dot(p) + plane_[3];
      growth = -plane_[2] * Eigen::Vector3d(p.x() - about_.x(), p.y() - about_.y(), 1);
      growth.head<2>() += distance * plane_[2] * plane_.head<2>();
      return distance;
    }
    const Place place = at(p);
    // The distance is (out^2 - out) / |slope|, all of the unit sphere. How it grows
    // with x, y and z of the place, and with the three inverse extents.
    const double outwards = (2 * place.out - 1) / (place.out * place.slope.norm());
    const double turning = place.distance / place.slope.squaredNorm();
    const Eigen::Vector3d by_place =
        outwards * place.slope -
        turning * place.slope.cwiseProduct(inverse_).cwiseProduct(inverse_);
    Eigen::Vector3d by_extent = outwards * place.unit.cwiseProduct(place.local) -
                                2 * turning * place.slope.cwiseProduct(place.unit);
    // The crown stays where it is.
    by_extent.z() -= by_place.z() / (inverse_.z() * inverse_.z());
    switch (kind_) {
    case ShapeKind::Cylinder:
    case ShapeKind::EllipticCylinder:
      growth.head<3>() << -by_place.y() * axis_.dot(p.head<2>() - about_.head<2>()),
          -by_place.y(), -by_place.z();
      if (kind_ == ShapeKind::Cylinder)
        growth[3] = by_extent.y() + by_extent.z();
      else
        growth.tail<2>() = by_extent.tail<2>();
      break;
    case ShapeKind::Sphere:
    default:
      growth.head<2>() = -by_place.x() * axis_ - by_place.y() * aside_;
      growth[2] = -by_place.z();
      if (kind_ == ShapeKind::Sphere) {
        growth[3] = by_extent.sum();
        break;
      }
      growth[3] = by_place.x() * place.local.y() - by_place.y() * place.local.x();
      growth.tail<3>() = by_extent;
    }
    return place.distance;
  }

private:
  /** @brief A point in the frame of a curve. */
  struct Place {
    Eigen::Vector3d local; ///< metres: along the axis, to its left, up
    Eigen::Vector3d unit;  ///< where the curve is the unit sphere, or cylinder
    double out = 1;        ///< of there from the middle
    Eigen::Vector3d slope; ///< how the square of `out` grows with `local`, halved
    double distance = 0;
  };

  Place at(const Eigen::Vector3d& p) const
  {
    constexpr double at_axis = 1e-9;
    Place place;
    const Eigen::Vector3d off = p - centre_;
    place.local << axis_.dot(off.head<2>()), aside_.dot(off.head<2>()), off.z();
    place.unit = place.local.cwiseProduct(inverse_);
    place.slope = place.unit.cwiseProduct(inverse_);
    place.out = std::max(at_axis, place.unit.norm());
    place.distance =
        (place.out - 1) * place.out / std::max(at_axis, place.slope.norm());
    return place;
  }

  ShapeKind kind_;
  Eigen::Vector3d about_;
  Eigen::Vector4d plane_;
  Eigen::Vector2d axis_ = Eigen::Vector2d::UnitX();
  Eigen::Vector2d aside_ = Eigen::Vector2d::UnitY();
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d inverse_ = Eigen::Vector3d::Zero(); ///< of the extents; 0: endless
};

/** @brief Tukey's cost of all distances. */
double
costOf(const std::vector<Eigen::Vector3d>& points,
       const ShapeDistance& distance,
       double band)
{
  double cost = 0;
  for (const Eigen::Vector3d& p : points) {
    const double share = distance(p) / band;
    const double rest = 1 - share * share;
    cost += std::abs(share) < 1 ? 1 - rest * rest * rest : 1;
  }
  return cost;
}

/** @brief The normal equations of a step towards less. */
struct StepSums {
  Normal normal; ///< its lower half
  Parameters right;
};

StepSums
sumsOf(const std::vector<Eigen::Vector3d>& points,
       const ShapeDistance& distance,
       double band,
       Eigen::Index count)
{
  StepSums sums{Normal::Zero(count, count), Parameters::Zero(count)};
  Parameters row(count);
  for (const Eigen::Vector3d& p : points) {
    const double off = distance(p, row);
    const double weight = biweight(off / band);
    if (weight <= 0)
      continue;
    for (Eigen::Index column = 0; column < count; ++column)
      for (Eigen::Index line = column; line < count; ++line)
        sums.normal(line, column) += weight * row[line] * row[column];
    sums.right -= weight * off * row;
  }
  return sums;
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

double
refineShape(ShapeKind kind,
            const std::vector<Eigen::Vector3d>& points,
            double deviation,
            PlanSlab& slab,
            double settled)
{
  constexpr int max_steps = 30;
  constexpr double cut = 4.7; // of Tukey's biweight, standard deviations
  const double band = cut * deviation;
  if (points.empty() || (kind != ShapeKind::Plane && !slab.curve))
    return infinity;
  const Eigen::Vector3d about = meanOf(points);
  Parameters numbers = numbersOf(kind, slab, about);
  double cost = costOf(points, {kind, slab, about}, band);
  double damping = 1e-6;
  for (int step = 0; step < max_steps; ++step) {
    const StepSums sums = sumsOf(points, {kind, slab, about}, band, numbers.size());
    bool is_better = false;
    double gain = 0;
    for (int tries = 0; tries < 8 && !is_better; ++tries) {
      Normal damped = sums.normal;
      damped.diagonal() *= 1 + damping;
      damped.diagonal().array() += 1e-12 * sums.normal.diagonal().maxCoeff();
      const Parameters next = numbers + damped.ldlt().solve(sums.right);
      PlanSlab there = slab;
      is_better = takeNumbers(kind, next, about, there);
      const double cost_there =
          is_better ? costOf(points, {kind, there, about}, band) : infinity;
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
