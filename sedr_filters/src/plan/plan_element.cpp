// SPDX-License-Identifier: BSD-3-Clause
#include "plan_arcs.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

SurfaceAccuracy
worse(const SurfaceAccuracy& a, const SurfaceAccuracy& b)
{
  if (!a.isKnown() || !b.isKnown())
    return {};
  return {std::max(a.standard_error, b.standard_error),
          std::max(a.deviation_95, b.deviation_95)};
}

namespace {

constexpr double two_pi = 2 * M_PI;

double
angleOf(const Eigen::Vector2d& v)
{
  return std::atan2(v.y(), v.x());
}

/** @brief Returns `angle` normalised to [0, 2 pi). */
double
positiveAngle(double angle)
{
  angle = std::fmod(angle, two_pi);
  return angle < 0 ? angle + two_pi : angle;
}

} // namespace

double
PlanElement::sweep() const
{
  const double from = angleOf(start - centre);
  const double to = angleOf(end - centre);
  if (isWhole(*this))
    return counter_clockwise ? two_pi : -two_pi;
  return counter_clockwise ? positiveAngle(to - from) : -positiveAngle(from - to);
}

double
PlanElement::length() const
{
  return isArc() ? radius * std::abs(sweep()) : (end - start).norm();
}

Eigen::Vector2d
PlanElement::pointAt(double s) const
{
  if (!isArc()) {
    const double total = length();
    return total > 0 ? Eigen::Vector2d(start + (end - start) * (s / total)) : start;
  }
  const double turn = s / radius;
  const double angle = angleOf(start - centre) + (counter_clockwise ? turn : -turn);
  return centre + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

Eigen::Vector2d
PlanElement::normalAt(double s) const
{
  if (isArc()) {
    const Eigen::Vector2d outward = (pointAt(s) - centre) / radius;
    return counter_clockwise ? -outward : outward;
  }
  const Eigen::Vector2d way = (end - start).normalized();
  return {-way.y(), way.x()};
}

double
PlanElement::project(const Eigen::Vector2d& p) const
{
  if (!isArc()) {
    const double total = length();
    const double s = total > 0 ? (p - start).dot(end - start) / total : 0;
    return std::clamp(s, 0.0, total);
  }
  if (isBeside(p)) {
    const double from = angleOf(start - centre);
    const double to = angleOf(p - centre);
    const double s = radius * (counter_clockwise ? positiveAngle(to - from)
                                                 : positiveAngle(from - to));
    // A place before the start only by rounding comes out a whole turn later.
    if (s <= length())
      return s;
  }
  return (p - start).norm() < (p - end).norm() ? 0 : length();
}

bool
PlanElement::isBeside(const Eigen::Vector2d& p) const
{
  if (!isArc()) {
    const Eigen::Vector2d way = end - start;
    const double s = (p - start).dot(way);
    return s >= 0 && s <= way.squaredNorm();
  }
  if (isWhole(*this))
    return true;
  const Eigen::Vector2d from = (counter_clockwise ? start : end) - centre;
  const Eigen::Vector2d to = (counter_clockwise ? end : start) - centre;
  const Eigen::Vector2d way = p - centre;
  return cross(from, to) >= 0 ? cross(from, way) >= 0 && cross(way, to) >= 0
                              : cross(from, way) >= 0 || cross(way, to) >= 0;
}

double
PlanElement::distance(const Eigen::Vector2d& p) const
{
  if (!isArc())
    return (pointAt(project(p)) - p).norm();
  if (isBeside(p))
    return std::abs((p - centre).norm() - radius);
  return std::min((p - start).norm(), (p - end).norm());
}

PlanElement
PlanElement::part(double from, double to) const
{
  PlanElement result = *this;
  result.start = pointAt(from);
  result.end = pointAt(to);
  return result;
}

double
PlanElement::areaUnder() const
{
  double area = cross(start, end) / 2;
  if (isArc()) {
    const double turn = sweep();
    area += radius * radius * (turn - std::sin(turn)) / 2;
  }
  return area;
}

Eigen::AlignedBox2d
boxAround(const PlanElement& element)
{
  Eigen::AlignedBox2d box(element.start.cwiseMin(element.end),
                          element.start.cwiseMax(element.end));
  if (element.isArc()) {
    const Eigen::Vector2d radius = Eigen::Vector2d::Constant(element.radius);
    box.extend(element.centre - radius);
    box.extend(element.centre + radius);
  }
  return box;
}

} // namespace pcl::sedr
