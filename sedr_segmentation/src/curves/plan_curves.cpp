// SPDX-License-Identifier: BSD-3-Clause
#include "plan_curves.h"

#include "sedr_filters/src/base/exactness.h"

#include "contour.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

PlanCurve
curveThrough(const PlanElement& e)
{
  PlanCurve curve = lineThrough(e.start, e.end);
  if (e.isArc()) {
    curve.point = e.centre;
    curve.radius = e.radius;
  }
  curve.inliers = e.inliers;
  curve.residual = e.residual;
  return curve;
}

/** @brief Returns the information of an element. Its accuracy is limited by that of
 * scanners and walls and by a share of the noise, whatever the number of points. An
 * unseen element counts as one point with the tolerance of a wall. */
Eigen::Matrix3d
informationOf(const PlanElement& e, double length, const Priors& priors)
{
  const double min_deviation = priors.place_accuracy;
  double count = 1;
  double noise = priors.wall_band;
  if (e.inliers > 0) {
    noise = std::max(e.residual, min_deviation);
    const double best = std::max(min_deviation, priors.share_unseen * noise);
    count = std::min(static_cast<double>(e.inliers), std::pow(noise / best, 2));
  }
  if (!e.isArc())
    return lineInformation(count, noise, std::max(length, 0.01));
  const Eigen::Vector2d outward = e.start - e.centre;
  // Keeps the radius of a short arc weakly determined.
  return circleInformation(count, noise, std::atan2(outward.y(), outward.x()),
                           e.sweep()) +
         Eigen::Matrix3d::Identity() * (1e-4 * count / (noise * noise));
}

} // namespace

std::vector<PlanLoop*>
loopsOf(PlanRoom& room)
{
  std::vector<PlanLoop*> loops{&room.boundary};
  for (auto& column : room.columns)
    loops.push_back(&column);
  for (auto* details : {&room.details, &room.floor_details})
    for (auto& detail : *details) {
      loops.push_back(&detail.boundary);
      for (auto& hole : detail.holes)
        loops.push_back(&hole);
    }
  for (auto& niche : room.niches)
    loops.push_back(&niche.boundary);
  return loops;
}

PlanCurves::PlanCurves(Floorplan& plan, const Priors& priors)
    : priors_(priors)
{
  for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
    const std::size_t first = curves.size();
    for (PlanLoop* loop : loopsOf(plan.rooms[r])) {
      Loop entry;
      entry.loop = loop;
      entry.room = r;
      entry.is_boundary = loop == &plan.rooms[r].boundary;
      for (const auto& e : loop->elements)
        entry.curves.push_back(curveOf(e, first));
      loops.push_back(std::move(entry));
    }
  }
}

std::size_t
PlanCurves::curveOf(const PlanElement& e, std::size_t first)
{
  for (std::size_t c = first; c < curves.size(); ++c)
    if (isAlong(e, curves[c].curve)) {
      measure(c, e);
      return c;
    }
  MeasuredCurve m;
  m.curve = curveThrough(e);
  m.pivot = (e.start + e.end) / 2;
  m.information = informationOf(e, e.length(), priors_);
  curves.push_back(m);
  reach_.push_back(e.length() / 2);
  return curves.size() - 1;
}

bool
PlanCurves::isAlong(const PlanElement& e, const PlanCurve& curve) const
{
  if (e.isArc() != curve.isCircle())
    return false;
  if (e.isArc())
    return (e.centre - curve.point).norm() < same_place &&
           std::abs(e.radius - curve.radius) < same_place;
  return curve.distance(e.start) < same_place && curve.distance(e.end) < same_place;
}

/** @brief Extends the measured part of a curve by a further element. */
void
PlanCurves::measure(std::size_t curve, const PlanElement& e)
{
  MeasuredCurve& m = curves[curve];
  PlanElement best = e;
  best.inliers = std::max(e.inliers, m.curve.inliers);
  best.residual = std::max(e.residual, m.curve.residual);
  m.curve.inliers = best.inliers;
  m.curve.residual = best.residual;
  if (m.curve.isCircle()) {
    const Eigen::Matrix3d other = informationOf(best, e.length(), priors_);
    if (e.length() > 2 * reach_[curve]) {
      m.information = other;
      reach_[curve] = e.length() / 2;
    }
    return;
  }
  const Eigen::Vector2d& along = m.curve.direction;
  double low = -reach_[curve];
  double high = reach_[curve];
  for (const Eigen::Vector2d& p : {e.start, e.end}) {
    low = std::min(low, (p - m.pivot).dot(along));
    high = std::max(high, (p - m.pivot).dot(along));
  }
  m.pivot += (low + high) / 2 * along;
  reach_[curve] = (high - low) / 2;
  m.information = informationOf(best, high - low, priors_);
}

void
PlanCurves::remeasure(std::size_t c)
{
  MeasuredCurve& m = curves[c];
  PlanElement shown;
  shown.end = {2 * reach_[c], 0};
  for (const auto& loop : loops)
    for (std::size_t i = 0; i < loop.curves.size() && m.curve.isCircle(); ++i)
      if (const PlanElement& e = loop.loop->elements[i];
          loop.curves[i] == c && (!shown.isArc() || e.length() > shown.length()))
        shown = e;
  shown.inliers = m.curve.inliers;
  shown.residual = m.curve.residual;
  m.information = informationOf(shown, shown.length(), priors_);
}

bool
PlanCurves::meetSmoothly(const PlanElement& e, const PlanElement& next, double angle)
{
  const Eigen::Vector2d a = e.normalAt(e.length());
  const Eigen::Vector2d b = next.normalAt(0);
  return a.dot(b) > 0 && std::abs(a.dot(leftOf(b))) < std::sin(angle);
}

/** @brief Finds the start of element `i` of a loop on the current curves: their nearby
 * point of tangency or intersection. Unseen elements follow their neighbours.
 * @return false if they do not meet within `farthest` metres */
bool
PlanCurves::cornerOf(const Loop& loop,
                     std::size_t i,
                     double farthest,
                     Eigen::Vector2d& corner) const
{
  const auto& elements = loop.loop->elements;
  const Eigen::Vector2d& old = elements[i].start;
  const std::size_t n = elements.size();
  const std::size_t a = loop.curves[(i + n - 1) % n];
  const std::size_t b = loop.curves[i];
  const PlanCurve& before = curves[a].curve;
  const PlanCurve& after = curves[b].curve;
  if (a == b) {
    corner = after.project(old);
    return (corner - old).norm() <= farthest;
  }
  if (tangents.count({std::min(a, b), std::max(a, b)}) > 0) {
    corner =
        after.isCircle() ? touchingPoint(before, after) : touchingPoint(after, before);
    // The position of a smooth joint along the curves is uncertain.
    return curveThrough(elements[i]).distance(corner) <= farthest &&
           (corner - old).norm() <= priors_.patch;
  }
  double nearest = farthest;
  bool is_found = false;
  for (const auto& p : intersections(before, after))
    if ((p - old).norm() <= nearest) {
      nearest = (p - old).norm();
      corner = p;
      is_found = true;
    }
  if (is_found || (before.inliers > 0 && after.inliers > 0))
    return is_found;
  const PlanElement& unseen =
      before.inliers > 0 ? elements[i] : elements[(i + n - 1) % n];
  corner = (before.inliers > 0 ? before : after).project(old);
  return !unseen.isArc() && (corner - old).norm() <= farthest;
}

/** @brief Rebuilds a loop on the current curves; returns false if it would break. */
bool
PlanCurves::moved(const Loop& loop, double farthest, PlanLoop& result) const
{
  result = *loop.loop;
  auto& elements = result.elements;
  const std::size_t n = elements.size();
  for (std::size_t i = 0; i < n; ++i) {
    Eigen::Vector2d corner;
    if (!cornerOf(loop, i, farthest, corner))
      return false;
    elements[i].start = corner;
    elements[(i + n - 1) % n].end = corner;
  }
  for (std::size_t i = 0; i < n; ++i) {
    PlanElement& e = elements[i];
    const PlanElement& old = loop.loop->elements[i];
    const PlanCurve& curve = curves[loop.curves[i]].curve;
    if (e.isArc()) {
      e.centre = curve.point;
      e.radius = curve.radius;
      if (std::abs(e.sweep() - old.sweep()) > 0.5)
        return false;
    }
    else if ((e.end - e.start).dot(old.end - old.start) <= 0)
      return false;
  }
  return !crossesItself(result.polygon(chord)) ||
         crossesItself(loop.loop->polygon(chord));
}

std::vector<std::size_t>
PlanCurves::rebuild(double farthest)
{
  std::vector<std::size_t> broken;
  std::vector<PlanLoop> results(loops.size());
  for (std::size_t l = 0; l < loops.size(); ++l)
    if (!moved(loops[l], farthest, results[l]))
      broken.push_back(l);
  if (broken.empty())
    for (std::size_t l = 0; l < loops.size(); ++l)
      *loops[l].loop = std::move(results[l]);
  return broken;
}

} // namespace pcl::sedr
