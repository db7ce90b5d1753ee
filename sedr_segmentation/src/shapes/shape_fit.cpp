// SPDX-License-Identifier: BSD-3-Clause
#include "shape_fit.h"

#include "sedr_filters/src/base/plane_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
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

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/** @brief The numbers of a shape, seven at most. */
using Parameters = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 7, 1>;
using Normal = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 7, 7>;

/** @brief Changes the numbers of a slab by a step, see ShapeDistance.
 * @return whether it is one then */
bool
takeStep(ShapeKind kind,
         const Parameters& step,
         const Eigen::Vector3d& about,
         PlanSlab& slab)
{
  if (!step.allFinite())
    return false;
  std::array<double, 7> by{};
  for (std::size_t k = 0; k < by.size(); ++k)
    if (const int number = numbersOf(kind)[k]; number >= 0)
      by[k] = step[number];
  if (isFlat(kind)) {
    const Eigen::Vector3d n = slab.plane.head<3>();
    const Eigen::Vector2d slope = Eigen::Vector2d(by[0], by[1]) - n.head<2>() / n.z();
    const double height = slab.heightAt(about.head<2>()) + by[2];
    slab.plane = planeThrough({about.x(), about.y(), height}, slope).plane;
    return true;
  }
  SlabCurve c = *slab.curve;
  c.centre += by[0] * c.axis + by[1] * Eigen::Vector2d(-c.axis.y(), c.axis.x());
  const double crown = c.base + c.up + by[2];
  c.setDirection(c.direction() + by[3]);
  c.along /= 1 + by[4] * c.along;
  c.across /= 1 + by[5] * c.across;
  c.up /= 1 + by[6] * c.up;
  c.base = crown - c.up;
  slab.curve = std::make_shared<const SlabCurve>(c);
  return c.isFinite();
}

/** @brief Returns Tukey's cost of all distances. Summing stops when `most` is reached;
 * the sum so far is returned then. */
double
costOf(const std::vector<PointRow>& points,
       const ShapeDistance& shape,
       double band,
       double most)
{
  double cost = 0;
  ShapeValues distance;
  ShapeValues share;
  for (const PointRow& row : points) {
    shape.of(row, distance);
    share = distance / band;
    const ShapeValues rest = 1 - share * share;
    distance = 1 - rest * rest * rest;
    for (Eigen::Index i = 0; i < row.size(); ++i)
      cost += std::abs(share[i]) < 1 ? distance[i] : 1;
    if (cost >= most) // what follows costs 0 or more
      break;
  }
  return cost;
}

/** @brief The normal equations of a step towards less. */
struct StepSums {
  Normal normal; ///< symmetric
  Parameters right;
};

/** @brief Returns them for a shape of `Count` numbers. */
template <int Count>
StepSums
sumsOf(const std::vector<PointRow>& points, const ShapeDistance& shape, double band)
{
  // Even rows, as numbers are added two at once.
  using Numbers = Eigen::Matrix<double, Count + Count % 2, 1>;
  using Columns = Eigen::Matrix<double, Count + Count % 2, Count>;
  Columns normal = Columns::Zero();
  Numbers right = Numbers::Zero();
  Numbers own = Numbers::Zero();
  ShapeValues distance;
  ShapeValues share;
  ShapeValues weights;
  std::array<ShapeValues, 7> growth;
  for (const PointRow& row : points) {
    shape.of(row, distance, growth);
    share = distance / band;
    weights = (1 - share * share).square();
    for (Eigen::Index i = 0; i < row.size(); ++i) {
      const double weight = weights[i];
      if (!(std::abs(share[i]) < 1) || weight <= 0)
        continue;
      for (int k = 0; k < Count; ++k)
        own[k] = growth[static_cast<std::size_t>(k)][i];
      const Numbers weighted = weight * own;
      for (int column = 0; column < Count; ++column)
        normal.col(column) += own[column] * weighted;
      right -= weight * distance[i] * own;
    }
  }
  return {normal.template topRows<Count>(), right.template head<Count>()};
}

StepSums
sumsOf(const std::vector<PointRow>& points,
       const ShapeDistance& shape,
       double band,
       int count)
{
  switch (count) {
  case 1:
    return sumsOf<1>(points, shape, band);
  case 3:
    return sumsOf<3>(points, shape, band);
  case 4:
    return sumsOf<4>(points, shape, band);
  case 5:
    return sumsOf<5>(points, shape, band);
  default:
    return sumsOf<7>(points, shape, band);
  }
}

} // namespace

int
parametersOf(ShapeKind kind)
{
  const std::array<int, 7>& numbers = numbersOf(kind);
  return *std::max_element(numbers.begin(), numbers.end()) + 1;
}

double
distanceOf(const PlanSlab& slab, const Eigen::Vector3d& p)
{
  return slab.curve ? slab.curve->distanceAbove(p)
                    : slab.plane.head<3>().dot(p) + slab.plane[3];
}

void
refineShape(ShapeKind kind,
            const std::vector<Eigen::Vector3d>& points,
            double deviation,
            PlanSlab& slab,
            double settled)
{
  constexpr int max_steps = 30;
  constexpr double cut = 4.7; // of Tukey's biweight, standard deviations
  const double band = cut * deviation;
  if (points.empty() || (!isFlat(kind) && !slab.curve))
    return;
  const Eigen::Vector3d about = meanOf(points);
  if (slab.curve && slab.curve->kind == CurveKind::Cylinder) {
    SlabCurve c = *slab.curve; // has its centre anywhere along its axis
    c.centre += c.axis * c.axis.dot(about.head<2>() - c.centre);
    slab.curve = std::make_shared<const SlabCurve>(c);
  }
  const std::vector<PointRow> rows = rowsOf(points);
  double cost = costOf(rows, {kind, slab, about}, band, infinity);
  double damping = 1e-6;
  for (int step = 0; step < max_steps; ++step) {
    const StepSums sums = sumsOf(rows, {kind, slab, about}, band, parametersOf(kind));
    bool is_better = false;
    double gain = 0;
    for (int tries = 0; tries < 8 && !is_better; ++tries) {
      Normal damped = sums.normal;
      damped.diagonal() *= 1 + damping;
      damped.diagonal().array() += 1e-12 * sums.normal.diagonal().maxCoeff();
      PlanSlab there = slab;
      is_better = takeStep(kind, damped.ldlt().solve(sums.right), about, there);
      const double cost_there =
          is_better ? costOf(rows, {kind, there, about}, band, cost) : infinity;
      is_better = cost_there < cost;
      damping = is_better ? damping / 10 : damping * 20 + 1e-9;
      if (!is_better)
        continue;
      gain = cost - cost_there;
      cost = cost_there;
      slab = there;
    }
    if (!is_better || gain < settled * cost)
      break;
  }
}

} // namespace pcl::sedr
