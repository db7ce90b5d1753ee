// SPDX-License-Identifier: BSD-3-Clause
#include "ray_caster.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>

namespace pcl::sedr::sim {

namespace {

constexpr std::uint32_t kLeafSize = 2;
constexpr double kMargin = 1e-9; ///< metres that thicken flat boxes

Bounds
merged(const Bounds& a, const Bounds& b)
{
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y),
           std::min(a.min.z, b.min.z)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y),
           std::max(a.max.z, b.max.z)}};
}

Bounds
widened(const Bounds& bounds)
{
  const Vec3 margin{kMargin, kMargin, kMargin};
  return {bounds.min - margin, bounds.max + margin};
}

double
coordinate(Vec3 p, int axis)
{
  return axis == 0 ? p.x : (axis == 1 ? p.y : p.z);
}

int
longestAxis(const Bounds& bounds)
{
  const Vec3 size = bounds.max - bounds.min;
  if (size.x >= size.y && size.x >= size.z)
    return 0;
  return size.y >= size.z ? 1 : 2;
}

/** @brief Returns where a ray enters a box; infinite if it misses or beyond @p to. */
double
entryDistance(const Bounds& bounds, const Ray& ray, Vec3 inverse, double to)
{
  const double tx0 = (bounds.min.x - ray.origin.x) * inverse.x;
  const double tx1 = (bounds.max.x - ray.origin.x) * inverse.x;
  const double ty0 = (bounds.min.y - ray.origin.y) * inverse.y;
  const double ty1 = (bounds.max.y - ray.origin.y) * inverse.y;
  const double tz0 = (bounds.min.z - ray.origin.z) * inverse.z;
  const double tz1 = (bounds.max.z - ray.origin.z) * inverse.z;
  const double enter =
      std::max({std::min(tx0, tx1), std::min(ty0, ty1), std::min(tz0, tz1), 0.0});
  const double leave =
      std::min({std::max(tx0, tx1), std::max(ty0, ty1), std::max(tz0, tz1), to});
  return enter <= leave ? enter : std::numeric_limits<double>::infinity();
}

} // namespace

RayCaster::RayCaster(std::vector<Surface> surfaces)
    : surfaces_(std::move(surfaces))
{
  for (const Surface& surface : surfaces_)
    bounds_.push_back(widened(boundsOf(surface.shape)));
  if (!surfaces_.empty())
    build(0, static_cast<std::uint32_t>(surfaces_.size()));
}

void
RayCaster::build(std::uint32_t first, std::uint32_t count)
{
  Bounds around = bounds_[first];
  for (std::uint32_t i = first; i < first + count; ++i)
    around = merged(around, bounds_[i]);
  const auto self = nodes_.size();
  nodes_.push_back({around, first, count});
  if (count <= kLeafSize)
    return;

  const int axis = longestAxis(around);
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), first);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return coordinate(bounds_[a].min + bounds_[a].max, axis) <
           coordinate(bounds_[b].min + bounds_[b].max, axis);
  });
  std::vector<Surface> surfaces;
  std::vector<Bounds> bounds;
  for (const std::uint32_t i : order) {
    surfaces.push_back(std::move(surfaces_[i]));
    bounds.push_back(bounds_[i]);
  }
  std::move(surfaces.begin(), surfaces.end(), surfaces_.begin() + first);
  std::copy(bounds.begin(), bounds.end(), bounds_.begin() + first);

  build(first, count / 2);
  nodes_[self].first = static_cast<std::uint32_t>(nodes_.size());
  nodes_[self].count = 0;
  build(first + count / 2, count - count / 2);
}

std::optional<Hit>
RayCaster::nearest(const Ray& ray, double from, double to) const
{
  if (nodes_.empty())
    return std::nullopt;
  const Vec3 inverse{1.0 / ray.direction.x, 1.0 / ray.direction.y,
                     1.0 / ray.direction.z};
  Hit hit{to, nullptr};
  std::array<std::uint32_t, 64> stack{};
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t index = stack[--depth];
    const Node& node = nodes_[index];
    if (entryDistance(node.bounds, ray, inverse, hit.distance) > hit.distance)
      continue;
    if (node.count == 0) {
      stack[depth++] = node.first;
      stack[depth++] = index + 1;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (entryDistance(bounds_[i], ray, inverse, hit.distance) > hit.distance)
        continue;
      const auto distance = intersect(surfaces_[i].shape, ray, from);
      if (distance && *distance <= hit.distance)
        hit = {*distance, &surfaces_[i]};
    }
  }
  if (hit.surface == nullptr)
    return std::nullopt;
  return hit;
}

} // namespace pcl::sedr::sim
