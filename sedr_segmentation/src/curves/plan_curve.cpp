// SPDX-License-Identifier: BSD-3-Clause
#include "plan_curve.h"

#include <cmath>

namespace pcl::sedr {

namespace {

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

std::vector<Eigen::Vector2d>
intersections(const PlanCurve& a, const PlanCurve& b)
{
  if (a.isCircle())
    return b.isCircle() ? circleMeetsCircle(a, b) : lineMeetsCircle(b, a);
  return b.isCircle() ? lineMeetsCircle(a, b) : lineMeetsLine(a, b);
}

} // namespace pcl::sedr
