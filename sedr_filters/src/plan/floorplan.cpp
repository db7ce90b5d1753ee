// SPDX-License-Identifier: BSD-3-Clause
#include "plan_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

Eigen::Vector2d
PlanFlight::middle(std::size_t riser) const
{
  return (risers[riser][0] + risers[riser][1]) / 2;
}

double
PlanOpening::width() const
{
  return (end - start).norm();
}

namespace {

/** @brief Returns the number of chords within `tolerance` metres of an arc, 3 to 10000.
 */
std::size_t
chordsOf(const PlanElement& arc, double tolerance)
{
  constexpr double least = 3;
  constexpr double most = 10000;
  // The sagitta r (1 - cos (step / 2)) is 2 r sin^2 (step / 4): this form has no
  // cancellation for large radii.
  const double slack = std::min(1.0, std::max(tolerance, 1e-6) / arc.radius);
  const double step = 4 * std::asin(std::sqrt(slack / 2));
  return static_cast<std::size_t>(
      std::max(least, std::min(most, std::ceil(std::abs(arc.sweep()) / step))));
}

} // namespace

double
PlanLoop::area() const
{
  double area = 0;
  for (const auto& e : elements)
    area += e.areaUnder();
  return area;
}

double
PlanLoop::length() const
{
  double length = 0;
  for (const auto& e : elements)
    length += e.length();
  return length;
}

bool
PlanLoop::contains(const Eigen::Vector2d& p) const
{
  int winding = 0;
  for (const auto& e : elements)
    winding += windingOf(e, p);
  return winding != 0;
}

double
PlanLoop::distance(const Eigen::Vector2d& p) const
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& e : elements)
    nearest = std::min(nearest, e.distance(p));
  return nearest;
}

std::size_t
PlanLoop::nearest(const Eigen::Vector2d& p) const
{
  std::size_t best = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const double d = elements[i].distance(p);
    if (d < nearest) {
      nearest = d;
      best = i;
    }
  }
  return best;
}

std::vector<Eigen::Vector2d>
PlanLoop::polygon(double tolerance) const
{
  std::vector<Eigen::Vector2d> corners;
  for (const auto& e : elements) {
    const std::size_t parts = e.isArc() ? chordsOf(e, tolerance) : 1;
    for (std::size_t k = 0; k < parts; ++k)
      corners.push_back(k == 0 ? e.start : e.pointAt(e.length() * k / parts));
  }
  return corners;
}

PlanLoop
reversed(const PlanLoop& loop)
{
  PlanLoop result;
  for (auto it = loop.elements.rbegin(); it != loop.elements.rend(); ++it) {
    PlanElement e = *it;
    std::swap(e.start, e.end);
    e.counter_clockwise = !e.counter_clockwise;
    result.elements.push_back(e);
  }
  return result;
}

namespace {

/** @brief Checks whether `p` is inside the outer loop and outside the inner ones. */
bool
isBetween(const PlanLoop& outer,
          const std::vector<PlanLoop>& inner,
          const Eigen::Vector2d& p)
{
  return outer.contains(p) &&
         std::none_of(inner.begin(), inner.end(),
                      [&](const auto& loop) { return loop.contains(p); });
}

} // namespace

bool
PlanDetail::contains(const Eigen::Vector2d& p) const
{
  return isBetween(boundary, holes, p);
}

bool
PlanRoom::contains(const Eigen::Vector2d& p) const
{
  return isBetween(boundary, columns, p);
}

namespace {

/** @brief Returns the index of the last detail that contains `p`, or -1. */
int
lastAround(const std::vector<PlanDetail>& details, const Eigen::Vector2d& p)
{
  for (std::size_t i = details.size(); i-- > 0;)
    if (details[i].contains(p))
      return static_cast<int>(i);
  return -1;
}

} // namespace

int
PlanRoom::detailAt(const Eigen::Vector2d& p) const
{
  return lastAround(details, p);
}

int
PlanRoom::floorDetailAt(const Eigen::Vector2d& p) const
{
  return lastAround(floor_details, p);
}

double
PlanRoom::floorAt(const Eigen::Vector2d& p) const
{
  return floorSlab(floorDetailAt(p)).heightAt(p);
}

int
PlanRoom::nicheAt(const Eigen::Vector2d& p) const
{
  for (std::size_t i = 0; i < niches.size(); ++i)
    if (niches[i].boundary.contains(p))
      return static_cast<int>(i);
  return -1;
}

Eigen::Vector3d
PlanSlab::normalAt(const Eigen::Vector2d& p) const
{
  if (!curve)
    return plane.head<3>();
  const Eigen::Vector2d slope = curve->gradientAt(p);
  return Eigen::Vector3d(-slope.x(), -slope.y(), 1).normalized();
}

bool
PlanRoom::hasFacets() const
{
  return !isLevel(ceiling) || (!details.empty() && details.front().is_facet);
}

double
PlanRoom::ceilingAt(const Eigen::Vector2d& p) const
{
  return ceilingSlab(detailAt(p)).heightAt(p);
}

double
PlanRoom::area() const
{
  double area = std::abs(boundary.area());
  for (const auto& column : columns)
    area -= std::abs(column.area());
  return area;
}

double
PlanFlight::going() const
{
  double length = 0;
  for (std::size_t k = 1; k < steps(); ++k)
    length += (middle(k) - middle(k - 1)).norm();
  return steps() < 2 ? 0 : length / static_cast<double>(steps() - 1);
}

std::vector<Eigen::Vector2d>
PlanFlight::outline() const
{
  std::vector<Eigen::Vector2d> corners;
  for (const Riser& riser : risers)
    corners.push_back(riser[1]);
  for (std::size_t k = steps(); k-- > 0;)
    corners.push_back(risers[k][0]);
  return corners;
}

const PlanRoom*
findRoom(const Floorplan& plan, std::uint32_t id)
{
  const auto found = std::find_if(plan.rooms.begin(), plan.rooms.end(),
                                  [id](const PlanRoom& room) { return room.id == id; });
  return found == plan.rooms.end() ? nullptr : &*found;
}

PlanRoom*
findRoom(Floorplan& plan, std::uint32_t id)
{
  return const_cast<PlanRoom*>(findRoom(std::as_const(plan), id));
}

} // namespace pcl::sedr
