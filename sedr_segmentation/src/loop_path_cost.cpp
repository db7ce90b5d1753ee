// SPDX-License-Identifier: BSD-3-Clause
#include "loop_path_cost.h"

#include <pcl/sedr_filters/middle_value.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace sedr {

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

/** @brief Whether any of the points is within `radius` of `p`. */
bool
isNear(const PlanPoints& points, const Eigen::Vector2d& p, double radius)
{
  bool is_near = false;
  points.forEachWithin(p, radius, [&](const Eigen::Vector2d&) { is_near = true; });
  return is_near;
}

/** @brief An element made ready for many distances. */
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

/** @brief Median number of points that show a metre of wall. */
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
    , directions_(directions)
    , others_(others)
    , tolerance_(std::clamp(3 * noise, parameters.tolerance / 2, parameters.tolerance))
    , reach_(std::abs(parameters.expected_offset) + parameters.reach + 0.02)
    , density_(densityAlong(samples, parameters.evidence_span))
    , shown_(placesOf(samples, true))
    , hidden_(placesOf(samples, false))
{}

PathCost::Zone
PathCost::zoneOf(const std::vector<Eigen::Vector2d>& all, std::size_t most_points) const
{
  const std::size_t step = all.size() / most_points + 1;
  Zone zone;
  for (std::size_t i = 0; i < all.size(); i += step) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& e : others_)
      nearest = std::min(nearest, e.distance(all[i]));
    zone.points.push_back(all[i]);
    zone.from_rest.push_back(nearest);
  }
  zone.density = density_ / static_cast<double>(step);
  return zone;
}

PathCost::Zone
PathCost::zoneAround(const Eigen::Vector2d& middle,
                     double radius,
                     const std::vector<PlanElement>& rest) const
{
  std::vector<Eigen::Vector2d> all;
  evidence_.forEachWithin(middle, radius,
                          [&](const Eigen::Vector2d& p) { all.push_back(p); });
  Zone zone = zoneOf(all, 600);
  for (const auto& e : rest)
    if (e.distance(middle) < radius + tolerance_)
      for (std::size_t i = 0; i < zone.points.size(); ++i)
        zone.from_rest[i] = std::min(zone.from_rest[i], e.distance(zone.points[i]));
  return zone;
}

double
PathCost::ofLoop(const PlanLoop& loop) const
{
  return of(loop.elements, zoneOf(evidence_.all(), 20000));
}

double
PathCost::missed(double squared_distance) const
{
  return std::min(1.0, squared_distance / (tolerance_ * tolerance_));
}

double
PathCost::least(const std::vector<PlanCurve>& curves, const Zone& zone) const
{
  double sum = 0;
  for (std::size_t i = 0; i < zone.points.size(); ++i) {
    double nearest = zone.from_rest[i];
    for (const auto& curve : curves)
      nearest = std::min(nearest, curve.distance(zone.points[i]));
    sum += missed(nearest * nearest);
  }
  return sum / zone.density;
}

double
PathCost::simplicity(const PlanElement& e) const
{
  constexpr double same = 0.01; // radians
  if (e.isArc())
    return per_arc;
  const Eigen::Vector2d way = e.end - e.start;
  const bool is_aligned =
      std::any_of(directions_.begin(), directions_.end(), [&](const auto& d) {
        return std::abs(leftOf(d).dot(way)) <= same * way.norm();
      });
  return is_aligned ? per_element : per_element + per_direction;
}

double
PathCost::unseen(const PlanElement& e, const Zone& zone) const
{
  constexpr double bin = 0.025;
  constexpr double least_share = 0.2;
  const Reach reach(e);
  const double length = e.length();
  if (length <= 0)
    return 0;
  std::vector<double> bins(static_cast<std::size_t>(std::ceil(length / bin)) + 2, 0);
  for (const auto& p : zone.points) {
    // The tail of a wall beside it shows none here.
    const double found = 1 - missed(reach.squaredDistance(p));
    if (found > 0)
      bins[1 + static_cast<std::size_t>(e.project(p) / bin)] += found;
  }
  const double least = 4 * least_share * bin * zone.density;
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
  constexpr double hidden_reach = 0.6;
  const double length = e.length();
  const auto parts = std::max<std::size_t>(1, static_cast<std::size_t>(length / step));
  std::size_t count = 0;
  for (std::size_t k = 0; k < parts; ++k) {
    const Eigen::Vector2d p =
        e.pointAt(length * (static_cast<double>(k) + 0.5) / static_cast<double>(parts));
    if (!isNear(shown_, p, reach_) && !isNear(hidden_, p, hidden_reach))
      ++count;
  }
  return length * static_cast<double>(count) / static_cast<double>(parts);
}

double
PathCost::ofElement(const PlanElement& e, const Zone& zone) const
{
  return unseen(e, zone) + astray(e) + simplicity(e);
}

std::vector<double>
PathCost::pointCosts(const std::vector<PlanElement>& path, const Zone& zone) const
{
  const std::vector<Reach> reaches(path.begin(), path.end());
  std::vector<double> costs;
  for (std::size_t i = 0; i < zone.points.size(); ++i) {
    double nearest = zone.from_rest[i] * zone.from_rest[i];
    for (const auto& reach : reaches)
      nearest = std::min(nearest, reach.squaredDistance(zone.points[i]));
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
    double nearest = zone.from_rest[i] * zone.from_rest[i];
    for (const auto& reach : reaches)
      nearest = std::min(nearest, reach.squaredDistance(zone.points[i]));
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

} // namespace sedr
} // namespace pcl
