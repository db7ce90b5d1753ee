// SPDX-License-Identifier: BSD-3-Clause
#include "loop_chain.h"
#include "main_directions.h"

#include <pcl/sedr_segmentation/curve_adjustment.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace sedr {

namespace {

/** @brief Sine of the angle up to which two curves run alike. */
constexpr double alike = 0.25;

double
sineBetween(const PlanCurve& a, const PlanCurve& b, const Eigen::Vector2d& place)
{
  return std::abs(leftOf(a.tangentAt(place)).dot(b.tangentAt(place)));
}

/** @brief The middle between two curves where they pass each other most closely. */
Eigen::Vector2d
nearestPass(const PlanCurve& a, const PlanCurve& b)
{
  const Eigen::Vector2d touch =
      b.isCircle() ? touchingPoint(a, b) : touchingPoint(b, a);
  return (a.project(touch) + b.project(touch)) / 2;
}

/** @brief Whether a corner lies on both curves. */
bool
isExact(const PlanCurve& a, const PlanCurve& b, const Eigen::Vector2d& corner)
{
  return a.distance(corner) < 1e-9 && b.distance(corner) < 1e-9;
}

LoopLink
bridgeBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
  LoopLink bridge;
  bridge.curve = lineThrough(from, to);
  bridge.is_bridge = true;
  return bridge;
}

/** @brief The corners of a chain found anew, near where they were.
 * @return false where two links do not meet */
bool
moveCorners(LoopChain& chain, const LoopParameters& parameters)
{
  std::vector<Eigen::Vector2d> corners(chain.size());
  for (std::size_t i = 0; i < chain.size(); ++i)
    if (!findCorner(chain.links[chain.before(i)].curve, chain.links[i].curve,
                    chain.corners[i], parameters, corners[i]))
      return false;
  chain.corners = std::move(corners);
  return true;
}

/** @brief Bridges lead from where one curve passes the corner to where the next does.
 */
void
layBridges(LoopChain& chain)
{
  for (std::size_t i = 0; i < chain.size(); ++i) {
    LoopLink& link = chain.links[i];
    if (!link.is_bridge)
      continue;
    const Eigen::Vector2d middle =
        (chain.corners[i] + chain.corners[chain.after(i)]) / 2;
    const Eigen::Vector2d from = chain.links[chain.before(i)].curve.project(middle);
    const Eigen::Vector2d to = chain.links[chain.after(i)].curve.project(middle);
    if ((to - from).norm() > 1e-6)
      link.curve = lineThrough(from, to);
  }
}

/** @brief Sine of the angle between a line and the nearest of the directions of the
 * other lines of a chain. */
double
askew(const LoopChain& chain, std::size_t link, const PlanCurve& line)
{
  std::vector<DirectedLine> others;
  for (std::size_t i = 0; i < chain.size(); ++i)
    if (i != link && !chain.links[i].curve.isCircle() && !chain.links[i].is_bridge)
      others.push_back({chain.element(i).length(), chain.links[i].curve.direction});
  double least = 1;
  for (const auto& direction : mainDirections(std::move(others)))
    least = std::min(least, std::abs(leftOf(direction).dot(line.direction)));
  return least;
}

/** @brief Share of an element's length beside which some of the points lie on a curve,
 * counted in parts of 5 cm. */
double
shareCovered(const PlanElement& element,
             const PlanCurve& curve,
             const std::vector<WeightedPoint>& points,
             double tolerance)
{
  constexpr double part = 0.05;
  const auto parts = static_cast<std::size_t>(std::ceil(element.length() / part));
  std::vector<std::uint8_t> is_covered(parts, 0);
  for (const auto& p : points) {
    const double s = element.project(p.position) / part;
    if (s >= 0 && s < static_cast<double>(parts) &&
        curve.distance(p.position) <= tolerance)
      is_covered[static_cast<std::size_t>(s)] = 1;
  }
  return static_cast<double>(std::count(is_covered.begin(), is_covered.end(), 1)) /
         static_cast<double>(std::max<std::size_t>(1, parts));
}

/** @brief Whether a fit to little of a line turns it away from where it was and from
 * all other walls: points in a few places tell little of a direction. */
bool
turnsAway(const LoopChain& chain,
          std::size_t link,
          const PlanCurve& line,
          const std::vector<WeightedPoint>& points,
          double tolerance)
{
  constexpr double least_share = 0.4;
  const PlanElement was = chain.element(link);
  if (was.isArc() || line.isCircle() ||
      std::max(line.distance(was.start), line.distance(was.end)) <= tolerance)
    return false;
  return shareCovered(was, line, points, tolerance) < least_share &&
         askew(chain, link, line) > askew(chain, link, chain.links[link].curve);
}

} // namespace

std::vector<WeightedPoint>
pointsAlong(const LoopChain& chain,
            std::size_t i,
            const PlanPoints& evidence,
            double tolerance)
{
  constexpr double step = 0.05;
  constexpr double corner_zone = 0.3;
  const PlanElement e = chain.element(i);
  const PlanCurve& curve = chain.links[i].curve;
  struct Neighbour {
    PlanCurve curve;
    Eigen::Vector2d corner;
    bool leaves_smoothly;
  };
  std::vector<Neighbour> neighbours;
  for (const bool is_next : {false, true}) {
    const LoopLink& link = chain.links[is_next ? chain.after(i) : chain.before(i)];
    const Eigen::Vector2d& corner = is_next ? e.end : e.start;
    neighbours.push_back(
        {link.curve, corner, sineBetween(curve, link.curve, corner) < 0.4});
  }
  const double smooth_zone = std::min(0.1, e.length() / 4);
  const auto isAtCorner = [&](const Eigen::Vector2d& p) {
    return std::any_of(neighbours.begin(), neighbours.end(), [&](const Neighbour& n) {
      const double from_corner = (p - n.corner).norm();
      return n.leaves_smoothly
                 ? from_corner < smooth_zone
                 : from_corner < corner_zone && n.curve.distance(p) < tolerance / 2;
    });
  };
  std::vector<WeightedPoint> points;
  const double length = e.length();
  const auto parts = static_cast<std::size_t>(std::ceil(length / step));
  const double half = length / static_cast<double>(parts) / 2;
  for (std::size_t k = 0; k < parts; ++k) {
    const Eigen::Vector2d middle = e.pointAt((2 * static_cast<double>(k) + 1) * half);
    const Eigen::Vector2d along = curve.tangentAt(middle);
    evidence.forEachWithin(middle, std::hypot(tolerance, half), [&](const auto& p) {
      if (std::abs((p - middle).dot(along)) <= half && !isAtCorner(p))
        points.push_back({p, 1});
    });
  }
  return points;
}

PlanElement
LoopChain::elementBetween(const LoopLink& link,
                          const Eigen::Vector2d& start,
                          const Eigen::Vector2d& end)
{
  PlanElement e;
  e.start = start;
  e.end = end;
  e.inliers = link.curve.inliers;
  e.residual = link.curve.residual;
  if (link.curve.isCircle()) {
    e.centre = link.curve.point;
    e.radius = link.curve.radius;
    e.counter_clockwise = link.counter_clockwise;
  }
  return e;
}

PlanLoop
LoopChain::loop() const
{
  PlanLoop result;
  for (std::size_t i = 0; i < size(); ++i)
    result.elements.push_back(element(i));
  return result;
}

bool
findCorner(const PlanCurve& a,
           const PlanCurve& b,
           const Eigen::Vector2d& place,
           const LoopParameters& parameters,
           Eigen::Vector2d& corner)
{
  const double gap = (a.project(place) - b.project(place)).norm();
  const bool run_alike = sineBetween(a, b, place) < alike;
  if (run_alike && gap > parameters.tolerance)
    return false;
  double nearest = 4 * parameters.corner_reach;
  bool is_found = false;
  for (const auto& p : intersections(a, b))
    if ((p - place).norm() < nearest) {
      nearest = (p - place).norm();
      corner = p;
      is_found = true;
    }
  if (is_found || !run_alike || (!a.isCircle() && !b.isCircle()))
    return is_found;
  corner = nearestPass(a, b);
  return (a.project(corner) - b.project(corner)).norm() < parameters.tolerance / 2 &&
         (corner - place).norm() < nearest;
}

LoopChain
joinLinks(const std::vector<LoopLink>& links,
          const std::vector<Eigen::Vector2d>& places,
          const LoopParameters& parameters)
{
  LoopChain chain;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const LoopLink& before = links[(i + links.size() - 1) % links.size()];
    Eigen::Vector2d corner;
    if (links.size() > 1 &&
        findCorner(before.curve, links[i].curve, places[i], parameters, corner)) {
      chain.links.push_back(links[i]);
      chain.corners.push_back(corner);
      continue;
    }
    const Eigen::Vector2d to = links[i].curve.project(places[i]);
    if (links.size() > 1) {
      const Eigen::Vector2d from = before.curve.project(places[i]);
      chain.links.push_back(bridgeBetween(from, to));
      chain.corners.push_back(from);
    }
    chain.links.push_back(links[i]);
    chain.corners.push_back(to);
  }
  return chain;
}

void
refitLinks(LoopChain& chain,
           const PlanPoints& evidence,
           const LoopParameters& parameters)
{
  LoopChain fitted = chain;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const LoopLink& link = chain.links[i];
    if (link.is_known)
      continue;
    const std::vector<WeightedPoint> points =
        pointsAlong(chain, i, evidence, parameters.tolerance);
    if (points.size() < (link.is_bridge ? 10 : 5))
      continue;
    fitted.links[i].is_bridge = false;
    PlanCurve& curve = fitted.links[i].curve;
    curve = link.keeps_direction
                ? fitParallel(points, link.curve, parameters.tolerance)
                : fitRobustly(points, link.curve, parameters.tolerance,
                              parameters.minimum_radius, parameters.maximum_radius);
    if (turnsAway(chain, i, curve, points, parameters.tolerance))
      curve = fitParallel(points, link.curve, parameters.tolerance);
    if (curve.direction.dot(link.curve.direction) < 0)
      curve.direction = -curve.direction;
  }
  layBridges(fitted);
  if (moveCorners(fitted, parameters))
    chain = fitted;
}

void
closeTangents(LoopChain& chain, const LoopParameters& parameters)
{
  std::vector<CurveTie> ties;
  std::vector<MeasuredCurve> curves;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const LoopLink& link = chain.links[i];
    const PlanElement e = chain.element(i);
    MeasuredCurve m;
    m.curve = link.curve;
    m.pivot = (e.start + e.end) / 2;
    const double worth = link.is_known ? 1e9 : link.is_bridge ? 1e-6 : 1.0;
    const Eigen::Vector2d outward = e.start - e.centre;
    m.information =
        e.isArc() ? circleInformation(worth * e.length(), 1,
                                      std::atan2(outward.y(), outward.x()), e.sweep())
                  : lineInformation(worth * std::max(e.length(), 0.01), 1,
                                    std::max(e.length(), 0.01));
    curves.push_back(m);
    const std::size_t before = chain.before(i);
    if (chain.size() > 1 &&
        !isExact(chain.links[before].curve, link.curve, chain.corners[i]))
      ties.push_back({TieKind::Tangent, link.curve.isCircle() ? before : i,
                      link.curve.isCircle() ? i : before});
  }
  if (ties.empty())
    return;
  LoopChain closed = chain;
  if (adjustCurves(curves, ties)) {
    for (std::size_t i = 0; i < chain.size(); ++i)
      closed.links[i].curve = curves[i].curve;
    bool is_closed = true;
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const PlanCurve& a = curves[chain.before(i)].curve;
      const PlanCurve& b = curves[i].curve;
      const bool was_exact = isExact(chain.links[chain.before(i)].curve,
                                     chain.links[i].curve, chain.corners[i]);
      if (was_exact)
        is_closed = findCorner(a, b, chain.corners[i], parameters, closed.corners[i]) &&
                    is_closed;
      else
        closed.corners[i] = nearestPass(a, b);
    }
    if (is_closed) {
      chain = closed;
      return;
    }
  }
  // Bridges in place of what cannot be closed.
  LoopChain bridged;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const PlanCurve& a = chain.links[chain.before(i)].curve;
    const PlanCurve& b = chain.links[i].curve;
    const Eigen::Vector2d from = a.project(chain.corners[i]);
    const Eigen::Vector2d to = b.project(chain.corners[i]);
    if (!isExact(a, b, chain.corners[i])) {
      bridged.links.push_back(bridgeBetween(from, to));
      bridged.corners.push_back(from);
    }
    bridged.links.push_back(chain.links[i]);
    bridged.corners.push_back(to);
  }
  chain = std::move(bridged);
}

} // namespace sedr
} // namespace pcl
