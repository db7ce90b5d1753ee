// SPDX-License-Identifier: BSD-3-Clause
#include "slab_creases.h"

#define BOOST_ALLOW_DEPRECATED_HEADERS // Boost.Geometry includes one
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl::sedr {
namespace {

constexpr double margin = 0.01;      ///< metres: beyond bounds, off springing lines
constexpr double max_creases = 2000; ///< of a cylinder, or rays of a dome

/** @brief Returns the angle between two creases of a circle of this radius, radians. */
double
stepOf(double radius, double tolerance)
{
  const double step = 2 * std::acos(std::max(0.0, 1 - tolerance / radius));
  return std::max(step, M_PI / max_creases);
}

/** @brief Returns the bounding box of `bounds` in the frame of a curve. */
Eigen::AlignedBox2d
localBounds(const SlabCurve& curve, const Eigen::AlignedBox2d& bounds)
{
  Eigen::AlignedBox2d local;
  for (const double x : {bounds.min().x(), bounds.max().x()})
    for (const double y : {bounds.min().y(), bounds.max().y()})
      local.extend(Eigen::Rotation2Dd(-curve.direction()) *
                   (Eigen::Vector2d(x, y) - curve.centre));
  local.extend(local.min() - Eigen::Vector2d::Constant(margin));
  local.extend(local.max() + Eigen::Vector2d::Constant(margin));
  return local;
}

std::vector<Crease>
cylinderCreases(const SlabCurve& curve,
                const Eigen::AlignedBox2d& bounds,
                double tolerance)
{
  const Eigen::AlignedBox2d local = localBounds(curve, bounds);
  const double step = stepOf(std::max(curve.across, curve.up), tolerance);
  const auto count = static_cast<int>(std::ceil(M_PI / step));
  std::vector<Crease> creases;
  for (int k = 0; k <= count; ++k) {
    const double offset = curve.across * std::sin(M_PI * k / count - M_PI / 2);
    // A crease on the springing line would form a sliver along the wall.
    const double reach = k == 0 || k == count ? 2 * margin : 0;
    if (offset - reach > local.min().y() && offset + reach < local.max().y())
      creases.emplace_back(Eigen::Vector2d(local.min().x(), offset),
                           Eigen::Vector2d(local.max().x(), offset));
  }
  return creases;
}

/** @brief Returns rings around the top with rays between them, fewer towards the
 * top. */
std::vector<Crease>
domeCreases(const SlabCurve& curve, const Eigen::AlignedBox2d& bounds, double tolerance)
{
  const double radius = std::max({curve.across, curve.along, curve.up});
  const double step = stepOf(radius, tolerance);
  const auto rings = static_cast<int>(std::ceil(M_PI / 2 / step));
  const double most = std::min(2 * M_PI / step, max_creases);
  const auto raysAt = [&](int ring) {
    const double wanted = most * std::sin(M_PI / 2 * ring / rings);
    int rays = 8;
    while (rays < wanted)
      rays *= 2;
    return rays;
  };
  const auto placeOf = [&](int ring, int ray, int rays) -> Eigen::Vector2d {
    const double out = std::sin(M_PI / 2 * ring / rings);
    const double angle = 2 * M_PI * ray / rays;
    return {curve.along * out * std::cos(angle), curve.across * out * std::sin(angle)};
  };
  const Eigen::AlignedBox2d local = localBounds(curve, bounds);
  std::vector<Crease> creases;
  const auto add = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    if (local.intersects(Eigen::AlignedBox2d(from.cwiseMin(to), from.cwiseMax(to))))
      creases.emplace_back(from, to);
  };
  for (int ring = 1; ring <= rings; ++ring) {
    const int rays = raysAt(ring);
    for (int ray = 0; ray < rays; ++ray)
      add(placeOf(ring, ray, rays), placeOf(ring, ray + 1, rays));
    const int inner = raysAt(ring - 1);
    for (int ray = 0; ray < inner; ++ray)
      add(placeOf(ring - 1, ray, inner), placeOf(ring, ray, inner));
  }
  return creases;
}

std::vector<Crease>
reliefCreases(const SlabCurve& curve, const Eigen::AlignedBox2d& bounds)
{
  const Eigen::AlignedBox2d local = localBounds(curve, bounds);
  std::vector<Crease> creases;
  for (std::size_t k = 0; k < std::max(curve.columns, curve.rows()); ++k)
    for (const int axis : {0, 1}) {
      const double at = curve.spacing * static_cast<double>(k);
      if (k >= (axis == 0 ? curve.columns : curve.rows()) || at <= local.min()[axis] ||
          at >= local.max()[axis])
        continue;
      Crease& crease = creases.emplace_back(local.min(), local.max());
      crease.first[axis] = crease.second[axis] = at;
    }
  return creases;
}

} // namespace

std::vector<Crease>
creasesOf(const SlabCurve& curve, const Eigen::AlignedBox2d& bounds, double tolerance)
{
  std::vector<Crease> creases =
      curve.kind == CurveKind::Relief     ? reliefCreases(curve, bounds)
      : curve.kind == CurveKind::Cylinder ? cylinderCreases(curve, bounds, tolerance)
                                          : domeCreases(curve, bounds, tolerance);
  const Eigen::Rotation2Dd turn(curve.direction());
  const Eigen::Vector2d low = bounds.min() - Eigen::Vector2d::Constant(margin);
  const Eigen::Vector2d high = bounds.max() + Eigen::Vector2d::Constant(margin);
  namespace geometry = boost::geometry;
  using Place = geometry::model::d2::point_xy<double>;
  const geometry::model::box<Place> box({low.x(), low.y()}, {high.x(), high.y()});
  std::vector<Crease> inside;
  for (const auto& [from, to] : creases) {
    const Eigen::Vector2d a = curve.centre + turn * from;
    const Eigen::Vector2d b = curve.centre + turn * to;
    std::vector<geometry::model::linestring<Place>> parts;
    geometry::intersection(
        geometry::model::linestring<Place>{{a.x(), a.y()}, {b.x(), b.y()}}, box, parts);
    for (const auto& part : parts)
      inside.emplace_back(Eigen::Vector2d(part.front().x(), part.front().y()),
                          Eigen::Vector2d(part.back().x(), part.back().y()));
  }
  return inside;
}

} // namespace pcl::sedr
