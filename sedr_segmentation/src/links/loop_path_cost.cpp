// SPDX-License-Identifier: BSD-3-Clause
#include "loop_path_cost.h"

#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/middle_value.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr {

namespace {

PlanPoints
placesOf(const std::vector<ContourSample>& samples, bool are_supported)
{
  std::vector<Eigen::Vector2d> places;
  for (const auto& s : samples)
    if (s.isSupported() == are_supported)
      places.push_back(s.place);
  return {std::move(places), 0.1};
}

/** @brief An element prepared for many distance queries. */
class Reach {
public:
  Reach(const PlanElement& e)
      : element_(&e)
      , length_(e.isArc() ? 0 : (e.end - e.start).norm())
      , along_(length_ > 0 ? Eigen::Vector2d((e.end - e.start) / length_)
                           : Eigen::Vector2d::Zero())
  {}

  double squaredDistance(const Eigen::Vector2d& p) const
  {
    if (element_->isArc()) {
      const double d = element_->distance(p);
      return d * d;
    }
    const Eigen::Vector2d way = p - element_->start;
    const double s = std::clamp(way.dot(along_), 0.0, length_);
    return (way - s * along_).squaredNorm();
  }

private:
  const PlanElement* element_;
  double length_;
  Eigen::Vector2d along_;
};

/** @brief Returns the distance of a point from the nearest element; infinite if none.
 */
double
distanceFrom(const std::vector<PlanElement>& elements, const Eigen::Vector2d& p)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& e : elements)
    nearest = std::min(nearest, e.distance(p));
  return nearest;
}

/** @brief Returns the squared distance from the nearest element; infinite if none. */
double
nearestOf(const std::vector<Reach>& reaches, const Eigen::Vector2d& p)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& reach : reaches)
    nearest = std::min(nearest, reach.squaredDistance(p));
  return nearest;
}

/** @brief Returns the median number of points per metre of wall. */
double
densityAlong(const std::vector<ContourSample>& samples, double evidence_span)
{
  std::vector<double> counts;
  for (const ContourSample& s : samples)
    if (s.isSupported())
      counts.push_back(static_cast<double>(s.points));
  if (counts.empty())
    return 0;
  return middleValue(std::move(counts)) / (2 * evidence_span);
}

} // namespace

PathCost::PathCost(const std::vector<ContourSample>& samples,
                   const PlanPoints& evidence,
                   const std::vector<Eigen::Vector2d>& directions,
                   const std::vector<PlanElement>& others,
                   double noise,
                   const LoopParameters& parameters)
    : evidence_(evidence)
    , priors_(parameters.priors)
    , directions_(directions)
    , others_(others)
    , tolerance_(std::clamp(parameters.priors.sigmas * noise,
                            parameters.tolerance / 2,
                            parameters.tolerance))
    , reach_(std::abs(parameters.expected_offset) + parameters.reach + 0.02)
    , density_(densityAlong(samples, parameters.evidence_span))
    , shown_(placesOf(samples, true))
    , hidden_(placesOf(samples, false))
{}

void
PathCost::appendNear(const std::vector<PlanElement>& all,
                     const Eigen::Vector2d& middle,
                     double radius,
                     std::vector<PlanElement>& near) const
{
  for (const auto& e : all)
    if (e.distance(middle) < radius + tolerance_)
      near.push_back(e);
}

PathCost::Zone
PathCost::zoneAround(const Eigen::Vector2d& middle,
                     double radius,
                     const std::vector<PlanElement>& rest) const
{
  constexpr std::size_t max_points = 600;
  std::vector<Eigen::Vector2d> all;
  evidence_.forEachWithin(middle, radius,
                          [&](const Eigen::Vector2d& p) { all.push_back(p); });
  std::vector<PlanElement> near;
  appendNear(others_, middle, radius, near);
  appendNear(rest, middle, radius, near);
  const std::size_t step = all.size() / max_points + 1;
  Zone zone;
  zone.density = density_ / static_cast<double>(step);
  for (std::size_t i = 0; i < all.size(); i += step) {
    zone.points.push_back(all[i]);
    zone.from_rest.push_back(distanceFrom(near, all[i]));
  }
  return zone;
}

PathCost::Zone
PathCost::zoneAlong(const std::vector<PlanElement>& elements) const
{
  constexpr std::size_t max_points = 20000; // per loop
  const double stretch = priors_.patch;     // search length, metres
  const std::size_t step = evidence_.size() / max_points + 1;
  std::vector<std::size_t> indices;
  for (const auto& e : elements) {
    const double length = e.length();
    const double parts = std::ceil(length / stretch) + 1;
    for (double k = 0.5; k < parts; ++k)
      evidence_.forEachIndexWithin(e.pointAt(k / parts * length),
                                   length / parts / 2 + tolerance_, [&](std::size_t i) {
                                     if (i % step == 0)
                                       indices.push_back(i);
                                   });
  }
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  Zone zone;
  zone.density = density_ / static_cast<double>(step);
  for (const std::size_t i : indices)
    zone.points.push_back(evidence_.all()[i]);
  return zone;
}

double
PathCost::ofChange(const std::vector<PlanElement>& before,
                   const std::vector<PlanElement>& after,
                   const std::vector<PlanElement>& rest) const
{
  std::vector<PlanElement> both = before;
  both.insert(both.end(), after.begin(), after.end());
  const Zone zone = zoneAlong(both);
  const std::vector<Reach> reaches_before(before.begin(), before.end());
  const std::vector<Reach> reaches_after(after.begin(), after.end());
  // The rest matters only where old and new elements differ.
  struct Change {
    Eigen::Vector2d point;
    double before;
    double after;
  };
  std::vector<Change> changes;
  for (const auto& p : zone.points) {
    const Change change{p, nearestOf(reaches_before, p), nearestOf(reaches_after, p)};
    if (std::abs(change.before - change.after) > same_place * same_place)
      changes.push_back(change);
  }
  double sum = 0;
  if (!changes.empty()) {
    Eigen::Vector2d low = changes[0].point;
    Eigen::Vector2d high = low;
    for (const auto& change : changes) {
      low = low.cwiseMin(change.point);
      high = high.cwiseMax(change.point);
    }
    std::vector<PlanElement> near;
    appendNear(others_, (low + high) / 2, (high - low).norm() / 2, near);
    appendNear(rest, (low + high) / 2, (high - low).norm() / 2, near);
    const std::vector<Reach> reaches(near.begin(), near.end());
    for (const auto& change : changes) {
      const double least = nearestOf(reaches, change.point);
      sum += missed(std::min(least, change.after)) -
             missed(std::min(least, change.before));
    }
  }
  double cost = sum / zone.density;
  for (const auto& e : after)
    cost += ofElement(e, zone);
  for (const auto& e : before)
    cost -= ofElement(e, zone);
  return cost;
}

double
PathCost::missed(double squared_distance) const
{
  return std::min(1.0, squared_distance / (tolerance_ * tolerance_));
}

std::vector<double>
PathCost::pointCostsOn(const PlanCurve& curve, const Zone& zone) const
{
  std::vector<double> costs;
  costs.reserve(zone.points.size());
  for (const auto& p : zone.points) {
    const double d = curve.distance(p);
    costs.push_back(missed(d * d));
  }
  return costs;
}

double
PathCost::simplicity(const PlanElement& e) const
{
  constexpr double same = 0.01; // radians
  if (e.isArc())
    return 3 * priors_.element_cost;
  const Eigen::Vector2d way = e.end - e.start;
  const bool is_aligned =
      std::any_of(directions_.begin(), directions_.end(), [&](const auto& d) {
        return std::abs(leftOf(d).dot(way)) <= same * way.norm();
      });
  return (is_aligned ? 1 : 2) * priors_.element_cost;
}

double
PathCost::unseen(const PlanElement& e, const Zone& zone) const
{
  const double bin = priors_.evidence_cell / 4;
  const Reach reach(e);
  const double length = e.length();
  if (length <= 0)
    return 0;
  std::vector<double> bins(static_cast<std::size_t>(std::ceil(length / bin)) + 2, 0);
  for (const auto& p : zone.points) {
    // The tail of an adjacent wall does not count as a wall here.
    const double found = 1 - missed(reach.squaredDistance(p));
    if (found > 0)
      bins[1 + static_cast<std::size_t>(e.project(p) / bin)] += found;
  }
  const double least = 4 * priors_.share_little * bin * zone.density;
  double sum = 0;
  for (std::size_t k = 1; k + 1 < bins.size(); ++k)
    if (bins[k - 1] + 2 * bins[k] + bins[k + 1] < least)
      sum += std::min(bin, length - static_cast<double>(k - 1) * bin);
  return sum;
}

double
PathCost::astray(const PlanElement& e) const
{
  constexpr double step = 0.03;
  const double length = e.length();
  const auto parts = std::max<std::size_t>(1, static_cast<std::size_t>(length / step));
  std::size_t count = 0;
  for (std::size_t k = 0; k < parts; ++k) {
    const Eigen::Vector2d p =
        e.pointAt(length * (static_cast<double>(k) + 0.5) / static_cast<double>(parts));
    if (!shown_.hasWithin(p, reach_) && !hidden_.hasWithin(p, priors_.max_wall))
      ++count;
  }
  return length * static_cast<double>(count) / static_cast<double>(parts);
}

PathCost::Zone
PathCost::zoneOn(const PlanCurve& curve, const Zone& zone) const
{
  // An element may end up to a quarter of the tolerance off its curve, see
  // findCorner().
  Zone on_curve;
  on_curve.density = zone.density;
  for (std::size_t i = 0; i < zone.points.size(); ++i)
    if (curve.distance(zone.points[i]) <= 2 * tolerance_) {
      on_curve.points.push_back(zone.points[i]);
      on_curve.from_rest.push_back(zone.from_rest[i]);
    }
  return on_curve;
}

double
PathCost::ofElement(const PlanElement& e, const Zone& zone, double limit) const
{
  const double least = simplicity(e);
  if (least >= limit)
    return least;
  const double cost = unseen(e, zone);
  return cost + least >= limit ? cost + least : cost + astray(e) + least;
}

std::vector<double>
PathCost::pointCosts(const std::vector<PlanElement>& path, const Zone& zone) const
{
  const std::vector<Reach> reaches(path.begin(), path.end());
  std::vector<double> costs;
  for (std::size_t i = 0; i < zone.points.size(); ++i) {
    const double nearest = std::min(zone.from_rest[i] * zone.from_rest[i],
                                    nearestOf(reaches, zone.points[i]));
    costs.push_back(missed(nearest));
  }
  return costs;
}

double
PathCost::ofPoints(const std::vector<PlanElement>& path,
                   const Zone& zone,
                   double limit) const
{
  std::vector<Reach> reaches(path.begin(), path.end());
  const double most = limit * zone.density;
  double sum = 0;
  for (std::size_t i = 0; i < zone.points.size() && sum <= most; ++i) {
    const double nearest = std::min(zone.from_rest[i] * zone.from_rest[i],
                                    nearestOf(reaches, zone.points[i]));
    sum += missed(nearest);
  }
  return sum / zone.density;
}

double
PathCost::of(const std::vector<PlanElement>& path, const Zone& zone) const
{
  double sum = ofPoints(path, zone, std::numeric_limits<double>::infinity());
  for (const auto& e : path)
    sum += ofElement(e, zone);
  return sum;
}

} // namespace pcl::sedr
