// SPDX-License-Identifier: BSD-3-Clause
#include "vaults.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace pcl::sedr::sim {

namespace {

constexpr double kSameHeight = 1e-9; ///< metres

/** @brief Returns the part of a convex polygon where dot(p, across) is in a band. */
std::vector<Vec2>
bandOf(const std::vector<Vec2>& polygon, Vec2 across, double low, double high)
{
  std::vector<Vec2> part = polygon;
  for (const double side : {1.0, -1.0}) {
    const double limit = side > 0 ? high : -low;
    std::vector<Vec2> kept;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Vec2 a = part[i];
      const Vec2 b = part[(i + 1) % part.size()];
      const double over_a = side * dot(a, across) - limit;
      const double over_b = side * dot(b, across) - limit;
      if (over_a <= kSameHeight)
        kept.push_back(a);
      if ((over_a < -kSameHeight && over_b > kSameHeight) ||
          (over_a > kSameHeight && over_b < -kSameHeight))
        kept.push_back(a + (over_a / (over_a - over_b)) * (b - a));
    }
    part = kept;
  }
  return part;
}

SlabDetail
facetOver(const std::vector<Vec2>& corners, const Slab& slab)
{
  SlabDetail facet;
  for (const Vec2 corner : corners)
    facet.loop.push_back({corner});
  facet.slab = slab;
  facet.is_facet = true;
  return facet;
}

/** @brief Angle between the facets of a circle, radians, and radius of their edges, for
 * equal deviation inwards and outwards. */
struct Steps {
  double angle = 0.0;
  double radius = 0.0;
};

Steps
stepsOf(double radius)
{
  constexpr double mean_share = 2.0 / 3.0; // mean deviation of a chord over its maximum
  return {std::sqrt(8.0 * kFacetTolerance / radius),
          radius + mean_share * kFacetTolerance};
}

} // namespace

std::vector<SlabDetail>
facetsOf(const Vault& vault, const Loop& loop)
{
  const Vec2 across = leftOf({std::cos(vault.direction), std::sin(vault.direction)});
  std::vector<Vec2> polygon;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const LoopVertex& vertex : loop) {
    if (vertex.bulge != 0.0)
      throw std::invalid_argument("A vault needs straight sides");
    polygon.push_back(vertex.position - vault.at);
    low = std::min(low, dot(polygon.back(), across));
    high = std::max(high, dot(polygon.back(), across));
  }
  if (std::max(high, -low) > vault.radius + kSameHeight)
    throw std::invalid_argument("A vault does not reach the sides of its loop");
  const Steps steps = stepsOf(vault.radius);
  const double first = std::asin(std::max(-1.0, low / steps.radius));
  const double last = std::asin(std::min(1.0, high / steps.radius));
  const auto count = static_cast<int>(std::ceil((last - first) / steps.angle));
  const auto edgeAt = [&](int k) {
    const double angle = first + (last - first) * k / count;
    return Vec2{k == 0       ? low
                : k == count ? high
                             : steps.radius * std::sin(angle),
                vault.height + steps.radius * std::cos(angle)};
  };
  std::vector<SlabDetail> facets;
  for (int k = 0; k < count; ++k) {
    const Vec2 from = edgeAt(k); // across, up
    const Vec2 to = edgeAt(k + 1);
    std::vector<Vec2> corners = bandOf(polygon, across, from.x, to.x);
    for (Vec2& corner : corners)
      corner = corner + vault.at;
    const double slope = (to.y - from.y) / (to.x - from.x);
    facets.push_back(
        facetOver(corners, {from.y, slope * across, vault.at + from.x * across}));
  }
  return facets;
}

std::vector<SlabDetail>
facetsOf(const Dome& dome)
{
  const Steps steps = stepsOf(dome.radius);
  const double out = std::asin(std::min(1.0, dome.rim / steps.radius));
  const auto rings = static_cast<int>(std::ceil(out / steps.angle));
  const auto rays = static_cast<int>(
      std::ceil(2.0 * pi * std::sqrt(dome.rim / dome.radius) / steps.angle));
  const auto placeAt = [&](int ring, int ray) {
    const double radius = steps.radius * std::sin(out * ring / rings);
    const double angle = 2.0 * pi * (ray % rays) / rays;
    const Vec2 place{dome.along * std::cos(angle), dome.across * std::sin(angle)};
    return dome.at + radius * rotated(place, dome.direction);
  };
  const auto heightAt = [&](int ring) {
    return dome.height + dome.up * steps.radius * std::cos(out * ring / rings);
  };
  std::vector<SlabDetail> facets;
  std::vector<Vec2> top;
  for (int ray = 0; ray < rays; ++ray)
    top.push_back(placeAt(1, ray));
  facets.push_back(facetOver(top, {heightAt(1)}));
  for (int ring = 1; ring < rings; ++ring)
    for (int ray = 0; ray < rays; ++ray) {
      const std::vector<Vec2> corners{placeAt(ring + 1, ray),
                                      placeAt(ring + 1, ray + 1),
                                      placeAt(ring, ray + 1), placeAt(ring, ray)};
      // The two level edges are parallel.
      const Vec2 outer = 0.5 * (corners[0] + corners[1]);
      const Vec2 inner = 0.5 * (corners[2] + corners[3]);
      const Vec2 uphill = leftOf(normalized(corners[1] - corners[0]));
      const double rise = heightAt(ring + 1) - heightAt(ring);
      const double slope = rise / dot(outer - inner, uphill);
      facets.push_back(facetOver(corners, {heightAt(ring), slope * uphill, inner}));
    }
  return facets;
}

} // namespace pcl::sedr::sim
