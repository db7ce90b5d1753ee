// SPDX-License-Identifier: BSD-3-Clause
#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr::sim {

namespace {

using Polygon = std::vector<Vec2>;

/** @brief Returns the part of a convex polygon where p.dot(normal) is at most @p
 * limit. */
Polygon
clipped(const Polygon& polygon, const Vec2& normal, double limit)
{
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[(i + 1) % polygon.size()];
    const double over_a = a.dot(normal) - limit;
    const double over_b = b.dot(normal) - limit;
    if (over_a <= kSamePoint)
      kept.push_back(a);
    if ((over_a < -kSamePoint && over_b > kSamePoint) ||
        (over_a > kSamePoint && over_b < -kSamePoint))
      kept.push_back(a + over_a / (over_a - over_b) * (b - a));
  }
  return kept;
}

PlanDetail
facetOver(const Polygon& corners, const Slab& slab)
{
  return {loopOf(corners), {}, slab, true};
}

} // namespace

FacetSteps
facetStepsOf(double radius)
{
  constexpr double mean_share = 2.0 / 3.0; // mean deviation of a chord over its maximum
  return {std::sqrt(8.0 * kCurveTolerance / radius),
          radius + mean_share * kCurveTolerance};
}

std::vector<PlanDetail>
facetsOf(const Vault& vault, const Loop& loop)
{
  const Vec2 across = rotated({0.0, 1.0}, vault.direction);
  Polygon polygon;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Element& side : loop.elements) {
    if (side.isArc())
      fail("A vault needs straight sides");
    polygon.push_back(side.start - vault.at);
    low = std::min(low, polygon.back().dot(across));
    high = std::max(high, polygon.back().dot(across));
  }
  if (std::max(high, -low) > vault.radius + kSamePoint)
    fail("A vault does not reach the sides of its loop");
  const FacetSteps steps = facetStepsOf(vault.radius);
  const double first = std::asin(std::max(-1.0, low / steps.radius));
  const double last = std::asin(std::min(1.0, high / steps.radius));
  const auto count = static_cast<int>(std::ceil((last - first) / steps.angle));
  const auto edgeAt = [&](int k) {
    const double angle = first + (last - first) * k / count;
    return Vec2(k == 0       ? low
                : k == count ? high
                             : steps.radius * std::sin(angle),
                vault.height + steps.radius * std::cos(angle));
  };
  std::vector<PlanDetail> facets;
  for (int k = 0; k < count; ++k) {
    const Vec2 from = edgeAt(k); // across, up
    const Vec2 to = edgeAt(k + 1);
    const double slope = (to.y() - from.y()) / (to.x() - from.x());
    Polygon band = clipped(clipped(polygon, across, to.x()), -across, -from.x());
    for (Vec2& corner : band)
      corner += vault.at;
    facets.push_back(
        facetOver(band, planeThrough(lifted(vault.at + from.x() * across, from.y()),
                                     slope * across)));
  }
  return facets;
}

std::vector<PlanDetail>
facetsOf(const Dome& dome)
{
  const FacetSteps steps = facetStepsOf(dome.radius);
  const double out = std::asin(std::min(1.0, dome.rim / steps.radius));
  const auto rings = static_cast<int>(std::ceil(out / steps.angle));
  const auto rays = static_cast<int>(
      std::ceil(2.0 * pi * std::sqrt(dome.rim / dome.radius) / steps.angle));
  const auto placeAt = [&](int ring, int ray) {
    const double radius = steps.radius * std::sin(out * ring / rings);
    const double angle = 2.0 * pi * (ray % rays) / rays;
    const Vec2 place{dome.along * std::cos(angle), dome.across * std::sin(angle)};
    return Vec2(dome.at + radius * rotated(place, dome.direction));
  };
  const auto heightAt = [&](int ring) {
    return dome.height + dome.up * steps.radius * std::cos(out * ring / rings);
  };
  std::vector<PlanDetail> facets;
  std::vector<Vec2> top;
  for (int ray = 0; ray < rays; ++ray)
    top.push_back(placeAt(1, ray));
  facets.push_back(facetOver(top, horizontalSlab(heightAt(1))));
  for (int ring = 1; ring < rings; ++ring)
    for (int ray = 0; ray < rays; ++ray) {
      const std::vector<Vec2> corners{placeAt(ring + 1, ray),
                                      placeAt(ring + 1, ray + 1),
                                      placeAt(ring, ray + 1), placeAt(ring, ray)};
      // The two level edges are parallel.
      const Vec2 outer = 0.5 * (corners[0] + corners[1]);
      const Vec2 inner = 0.5 * (corners[2] + corners[3]);
      const Vec2 uphill = leftOf((corners[1] - corners[0]).normalized());
      const double rise = heightAt(ring + 1) - heightAt(ring);
      const double slope = rise / (outer - inner).dot(uphill);
      facets.push_back(facetOver(
          corners, planeThrough(lifted(inner, heightAt(ring)), slope * uphill)));
    }
  return facets;
}

std::vector<PlanDetail>
ribsOf(const Room& room, const RibFamily& family)
{
  const Vec2 along(std::cos(family.direction), std::sin(family.direction));
  const Vec2 across = leftOf(along);
  Box2 bounds; // along and across
  for (const Element& wall : room.boundary.elements)
    bounds.extend(Vec2(wall.start.dot(along), wall.start.dot(across)));
  const auto at = [&](double s, double t) { return Vec2(s * along + t * across); };
  const double start = bounds.min().x();
  const double end = bounds.max().x();
  const Slab underside = raised(room.ceiling, -family.depth);
  std::vector<PlanDetail> ribs;
  double low = bounds.min().y() + family.first.value_or(0.5 * family.spacing) -
               0.5 * family.width;
  for (; low + family.width <= bounds.max().y() + kSamePoint; low += family.spacing) {
    if (low < bounds.min().y() - kSamePoint)
      continue;
    const double high = low + family.width;
    ribs.push_back(
        {loopOf({at(start, low), at(end, low), at(end, high), at(start, high)}),
         {},
         underside});
  }
  return ribs;
}

} // namespace pcl::sedr::sim
