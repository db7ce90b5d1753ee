// SPDX-License-Identifier: BSD-3-Clause
#include "plan_curve.h"

#include "sedr_filters/src/base/middle_value.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Sets the number of inliers and their residual. */
PlanCurve
judged(PlanCurve curve, const std::vector<WeightedPoint>& points)
{
  double sum = 0;
  double weight = 0;
  for (const auto& p : points) {
    sum += p.weight * std::pow(curve.distance(p.position), 2);
    weight += p.weight;
  }
  curve.inliers = points.size();
  curve.residual = weight > 0 ? std::sqrt(sum / weight) : 0;
  return curve;
}

double
robustDeviation(const std::vector<WeightedPoint>& points, const PlanCurve& curve)
{
  std::vector<double> distances;
  distances.reserve(points.size());
  for (const auto& p : points)
    distances.push_back(curve.distance(p.position));
  return 1.4826 * middleValue(std::move(distances));
}

std::vector<Eigen::Vector2d>
lineMeetsLine(const PlanCurve& a, const PlanCurve& b)
{
  const double sine = a.direction.dot(leftOf(b.direction));
  if (std::abs(sine) < 1e-9)
    return {};
  const double t = (b.point - a.point).dot(leftOf(b.direction)) / sine;
  return {a.point + t * a.direction};
}

std::vector<Eigen::Vector2d>
lineMeetsCircle(const PlanCurve& line, const PlanCurve& circle)
{
  const Eigen::Vector2d foot = line.project(circle.point);
  const double height = (foot - circle.point).norm();
  const double half = circle.radius * circle.radius - height * height;
  if (half < 0)
    return {};
  const Eigen::Vector2d along = std::sqrt(half) * line.direction;
  return {foot - along, foot + along};
}

std::vector<Eigen::Vector2d>
circleMeetsCircle(const PlanCurve& a, const PlanCurve& b)
{
  const Eigen::Vector2d way = b.point - a.point;
  const double d = way.norm();
  if (d < 1e-9)
    return {};
  const double x = (d * d + a.radius * a.radius - b.radius * b.radius) / (2 * d);
  const double half = a.radius * a.radius - x * x;
  if (half < 0)
    return {};
  const Eigen::Vector2d foot = a.point + way * (x / d);
  const Eigen::Vector2d along = leftOf(way / d) * std::sqrt(half);
  return {foot - along, foot + along};
}

} // namespace

Eigen::Vector2d
PlanCurve::project(const Eigen::Vector2d& p) const
{
  if (!isCircle())
    return point + (p - point).dot(direction) * direction;
  const Eigen::Vector2d way = p - point;
  const double d = way.norm();
  return d > 0 ? Eigen::Vector2d(point + way * (radius / d))
               : Eigen::Vector2d(point + radius * Eigen::Vector2d::UnitX());
}

Eigen::Vector2d
PlanCurve::tangentAt(const Eigen::Vector2d& p) const
{
  return isCircle() ? leftOf((project(p) - point) / radius) : direction;
}

PlanCurve
lineThrough(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  PlanCurve line;
  line.point = a;
  const double d = (b - a).norm();
  if (d > 0)
    line.direction = (b - a) / d;
  return line;
}

PlanCurve
carrierOf(const PlanElement& element)
{
  PlanCurve curve = lineThrough(element.start, element.end);
  if (element.isArc()) {
    curve.point = element.centre;
    curve.radius = element.radius;
  }
  return curve;
}

PlanCurve
circleThrough(const Eigen::Vector2d& a,
              const Eigen::Vector2d& b,
              const Eigen::Vector2d& c)
{
  const Eigen::Vector2d u = b - a;
  const Eigen::Vector2d v = c - a;
  const double twice_area = u.x() * v.y() - u.y() * v.x();
  if (std::abs(twice_area) < 1e-12)
    return lineThrough(a, c);
  const Eigen::Vector2d w(v.y() * u.squaredNorm() - u.y() * v.squaredNorm(),
                          u.x() * v.squaredNorm() - v.x() * u.squaredNorm());
  PlanCurve circle;
  circle.point = a + w / (2 * twice_area);
  circle.radius = (circle.point - a).norm();
  return circle;
}

PlanCurve
fitLine(const std::vector<WeightedPoint>& points)
{
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  double weight = 0;
  for (const auto& p : points) {
    mean += p.weight * p.position;
    weight += p.weight;
  }
  if (weight > 0)
    mean /= weight;
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const auto& p : points) {
    const Eigen::Vector2d d = p.position - mean;
    scatter.noalias() += p.weight * d * d.transpose();
  }
  PlanCurve line;
  line.point = mean;
  line.direction =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(scatter).eigenvectors().col(1);
  return judged(line, points);
}

namespace {

/** @brief Returns the normal matrix, only its lower half filled, and the right-hand
 * side of a Gauss-Newton step of a circle. */
std::pair<Eigen::Matrix3d, Eigen::Vector3d>
normalEquations(const std::vector<WeightedPoint>& points, const PlanCurve& circle)
{
  // In batches, so that roots and quotients are vectorised.
  constexpr Eigen::Index stretch = 64;
  using Values = Eigen::Array<double, Eigen::Dynamic, 1, Eigen::ColMajor, stretch, 1>;
  const auto n = static_cast<Eigen::Index>(points.size());
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (Eigen::Index first = 0; first < n; first += stretch) {
    const WeightedPoint* some = points.data() + first;
    Values x(std::min(stretch, n - first));
    Values y(x.size());
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      x[k] = some[k].position.x() - circle.point.x();
      y[k] = some[k].position.y() - circle.point.y();
    }
    const Values d = (x * x + y * y).sqrt().max(1e-12);
    x = -x / d;
    y = -y / d;
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      const double weight = some[k].weight;
      const Eigen::Vector3d weighted(weight * x[k], weight * y[k], -weight);
      normal(0, 0) += weighted[0] * x[k];
      normal(1, 0) += weighted[1] * x[k];
      normal(1, 1) += weighted[1] * y[k];
      normal(2, 0) += weighted[2] * x[k];
      normal(2, 1) += weighted[2] * y[k];
      normal(2, 2) -= weighted[2];
      right += weight * (circle.radius - d[k]) * Eigen::Vector3d(x[k], y[k], -1);
    }
  }
  return {normal, right};
}

} // namespace

PlanCurve
fitCircle(const std::vector<WeightedPoint>& points, const PlanCurve& start)
{
  PlanCurve circle = start;
  for (int round = 0; round < 20; ++round) {
    const auto [normal, right] = normalEquations(points, circle);
    const Eigen::Vector3d step = normal.ldlt().solve(right);
    if (!step.allFinite())
      return start;
    circle.point += step.head<2>();
    circle.radius += step[2];
    if (circle.radius <= 0 || circle.radius > 1e6)
      return start;
    if (step.norm() < 1e-10)
      break;
  }
  return judged(circle, points);
}

namespace {

bool
areSame(const std::vector<WeightedPoint>& a, const std::vector<WeightedPoint>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const WeightedPoint& p, const WeightedPoint& q) {
                      return p.position == q.position && p.weight == q.weight;
                    });
}

/** @brief Fits by `fit(points, start)` to the points within a shrinking `band`. */
template <typename Fit>
PlanCurve
fitShrinking(const std::vector<WeightedPoint>& points,
             const PlanCurve& start,
             double band,
             std::size_t min_points,
             Fit fit)
{
  constexpr int rounds = 6;
  PlanCurve curve = start;
  const double widest = band;
  std::vector<WeightedPoint> inside;
  std::vector<WeightedPoint> fitted;
  inside.reserve(points.size());
  fitted.reserve(points.size());
  for (int round = 0; round < rounds; ++round) {
    inside.clear();
    for (const auto& p : points)
      if (curve.distance(p.position) <= band)
        inside.push_back(p);
    if (inside.size() < min_points)
      return round == 0 ? start : curve;
    if (areSame(inside, fitted)) // converged
      return curve;
    curve = fit(inside, curve);
    if (round + 1 < rounds)
      band = std::clamp(2.5 * robustDeviation(inside, curve), 2e-4, widest);
    fitted.swap(inside);
  }
  return curve;
}

} // namespace

PlanCurve
fitRobustly(const std::vector<WeightedPoint>& points,
            const PlanCurve& start,
            double band,
            double minimum_radius,
            double maximum_radius)
{
  const PlanCurve curve =
      fitShrinking(points, start, band, start.isCircle() ? 4 : 2,
                   [](const auto& inside, const PlanCurve& from) {
                     return from.isCircle() ? fitCircle(inside, from) : fitLine(inside);
                   });
  const bool is_refused = curve.isCircle() && (curve.radius < minimum_radius ||
                                               curve.radius > maximum_radius);
  return is_refused ? start : curve;
}

PlanCurve
fitParallel(const std::vector<WeightedPoint>& points,
            const PlanCurve& start,
            double band)
{
  return fitShrinking(points, start, band, 1, [](const auto& inside, PlanCurve line) {
    double sum = 0;
    double weight = 0;
    for (const auto& p : inside) {
      sum += p.weight * line.signedDistance(p.position);
      weight += p.weight;
    }
    if (weight > 0)
      line.point += sum / weight * leftOf(line.direction);
    return judged(line, inside);
  });
}

std::vector<Eigen::Vector2d>
intersections(const PlanCurve& a, const PlanCurve& b)
{
  if (a.isCircle())
    return b.isCircle() ? circleMeetsCircle(a, b) : lineMeetsCircle(b, a);
  return b.isCircle() ? lineMeetsCircle(a, b) : lineMeetsLine(a, b);
}

} // namespace pcl::sedr
