// SPDX-License-Identifier: BSD-3-Clause
#include "tie_equations.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

Eigen::Vector2d
directionOf(const Eigen::Vector3d& line)
{
  return {std::cos(line[0]), std::sin(line[0])};
}

TieSide
tieSideOf(const MeasuredCurve& a, const MeasuredCurve& b, TieKind kind)
{
  TieSide side;
  if (kind != TieKind::Tangent)
    return side;
  if (!a.curve.isCircle()) {
    side.sign = a.curve.signedDistance(b.curve.point) < 0 ? -1 : 1;
    return side;
  }
  const double apart = (a.curve.point - b.curve.point).norm();
  side.is_inside = apart < std::max(a.curve.radius, b.curve.radius);
  side.sign = a.curve.radius < b.curve.radius ? -1 : 1;
  return side;
}

namespace {

/** @brief Returns an angle reduced to [-90, 90) degrees, as lines are undirected. */
double
lineAngle(double angle)
{
  return angle - M_PI * std::floor(angle / M_PI + 0.5);
}

TieEquation
angleEquation(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double between)
{
  return {lineAngle(a[0] - b[0] - between), {1, 0, 0}, {-1, 0, 0}};
}

TieEquation
lineTouchesCircle(const MeasuredCurve& line,
                  const Eigen::Vector3d& a,
                  const Eigen::Vector3d& b,
                  const TieSide& side)
{
  const Eigen::Vector2d along = directionOf(a);
  const Eigen::Vector2d left = leftOf(along);
  const Eigen::Vector2d way = b.head<2>() - line.pivot;
  return {left.dot(way) - a[1] - side.sign * b[2],
          {-along.dot(way), -1, 0},
          {left.x(), left.y(), -side.sign}};
}

TieEquation
circleTouchesCircle(const Eigen::Vector3d& a,
                    const Eigen::Vector3d& b,
                    const TieSide& side)
{
  const Eigen::Vector2d way = b.head<2>() - a.head<2>();
  const double apart = std::max(way.norm(), 1e-12);
  const Eigen::Vector2d u = way / apart;
  if (side.is_inside)
    return {apart - side.sign * (a[2] - b[2]),
            {-u.x(), -u.y(), -side.sign},
            {u.x(), u.y(), side.sign}};
  return {apart - a[2] - b[2], {-u.x(), -u.y(), -1}, {u.x(), u.y(), -1}};
}

/** @brief Returns the equation that the centre of the second line lies on the first. */
TieEquation
onLineEquation(const MeasuredCurve& first,
               const MeasuredCurve& second,
               const Eigen::Vector3d& a,
               const Eigen::Vector3d& b)
{
  const Eigen::Vector2d left = leftOf(directionOf(a));
  const Eigen::Vector2d other_left = leftOf(directionOf(b));
  const Eigen::Vector2d way = second.pivot + b[1] * other_left - first.pivot;
  return {left.dot(way) - a[1],
          {-directionOf(a).dot(way), -1, 0},
          {-b[1] * left.dot(directionOf(b)), left.dot(other_left), 0}};
}

} // namespace

std::vector<TieEquation>
equationsOf(TieKind kind,
            const TieSide& side,
            const MeasuredCurve& first,
            const MeasuredCurve& second,
            const Eigen::Vector3d& a,
            const Eigen::Vector3d& b)
{
  switch (kind) {
  case TieKind::Parallel:
    return {angleEquation(a, b, 0)};
  case TieKind::Perpendicular:
    return {angleEquation(a, b, M_PI / 2)};
  case TieKind::Collinear:
    return {angleEquation(a, b, 0), onLineEquation(first, second, a, b)};
  case TieKind::Tangent:
    return {first.curve.isCircle() ? circleTouchesCircle(a, b, side)
                                   : lineTouchesCircle(first, a, b, side)};
  case TieKind::EqualRadius:
    return {{a[2] - b[2], {0, 0, 1}, {0, 0, -1}}};
  case TieKind::Concentric:
    return {{a[0] - b[0], {1, 0, 0}, {-1, 0, 0}}, {a[1] - b[1], {0, 1, 0}, {0, -1, 0}}};
  }
  return {};
}

} // namespace pcl::sedr
