// SPDX-License-Identifier: BSD-3-Clause
#include "tracer.h"

#include "scene_surfaces.h"

namespace pcl::sedr::sim {

namespace {

constexpr double kStart = 1e-6; ///< metres skipped behind a surface that is passed
constexpr int kMaxPanes = 16;   ///< maximum number of panes along a ray

/** @brief Returns the leg that starts where @p leg meets a flat pane. */
Ray
mirroredAt(const PlanePatch& pane, const Ray& leg, double distance)
{
  const Vec3 normal = lifted(leftOf(pane.direction), 0.0);
  const Vec3 direction = leg.direction - 2.0 * dot(leg.direction, normal) * normal;
  return {leg.at(distance), direction};
}

} // namespace

Tracer::Tracer(const Scene& scene)
    : scene_(scene)
    , caster_(surfacesOf(scene))
{}

std::optional<ScanPoint>
Tracer::measure(const Ray& ray, const Scanner& scanner, RayRandom& random) const
{
  const auto echo = findEcho(ray, scanner.max_range, random);
  if (!echo)
    return std::nullopt;
  const double range = echo->range + scanner.noise * random.gaussian();
  const Vec3 point = placed(scene_.placement, ray.at(range));
  return ScanPoint{static_cast<float>(point.x), static_cast<float>(point.y),
                   static_cast<float>(point.z), static_cast<std::uint32_t>(echo->label),
                   echo->room};
}

std::optional<Tracer::Echo>
Tracer::findEcho(const Ray& ray, double max_range, RayRandom& random) const
{
  Ray leg = ray;        // changes where a pane mirrors
  double walked = 0.0;  // length of the previous legs
  double from = kStart; // start of the search on the leg
  for (int pane = 0; pane < kMaxPanes; ++pane) {
    const auto hit = caster_.nearest(leg, from, max_range - walked);
    if (!hit)
      return std::nullopt;
    const auto& glazing = hit->surface->glazing;
    const double fate = glazing ? random.uniform() : 0.0;
    if (!glazing || fate < glazing->return_share) {
      const Echo echo = echoOf(leg, *hit);
      return walked > 0.0 ? Echo{walked + echo.range} : echo;
    }
    from = hit->distance + kStart;
    // Curved panes do not mirror: their images would not resemble a room.
    const auto* flat = std::get_if<PlanePatch>(&hit->surface->shape);
    if (flat != nullptr && fate < glazing->return_share + glazing->mirror_share) {
      leg = mirroredAt(*flat, leg, hit->distance);
      walked += hit->distance;
      from = kStart;
    }
  }
  return std::nullopt;
}

Tracer::Echo
Tracer::echoOf(const Ray& leg, const Hit& hit)
{
  const Surface& surface = *hit.surface;
  // The back of a surface is the outside of the building.
  if (surface.front != Side::None &&
      sideSeenFrom(surface.shape, leg, hit.distance) != surface.front)
    return {hit.distance};
  return {hit.distance, surface.label, surface.room};
}

} // namespace pcl::sedr::sim
