// SPDX-License-Identifier: BSD-3-Clause
#include "plan_subdivision.h"
#include "sedr_filters/src/plan/plan_geometry.h"

#include <Eigen/Geometry>

#define BOOST_ALLOW_DEPRECATED_HEADERS // Boost.Geometry includes one
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace pcl::sedr {
namespace {

/** @brief Bounds of the tolerance from residuals, metres. Plans are accurate to a
 * millimetre at best; what is 5 cm apart is distinct. */
constexpr double min_snap = 0.002;
constexpr double max_snap = 0.05;

/** @brief A corner of a chain while it is being fitted. */
struct Corner {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  std::size_t element = 0;   ///< element of the next facet
  double tolerance = 0;      ///< maximum of the elements that meet here, metres
  double edge_tolerance = 0; ///< of the next facet's element
  bool is_joint = false;     ///< between two elements, not within an arc
};

std::vector<Corner>
cornersOf(const RoomLayers::Loop& loop, double chord_tolerance)
{
  std::vector<Corner> corners;
  const auto& elements = loop.loop->elements;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const double own = snapTolerance(elements[i]);
    const double before =
        snapTolerance(elements[(i + elements.size() - 1) % elements.size()]);
    const auto places = PlanLoop{{elements[i]}}.polygon(chord_tolerance);
    for (std::size_t k = 0; k < places.size(); ++k)
      corners.push_back({places[k], loop.first_element + i,
                         k == 0 ? std::max(own, before) : own, own, k == 0});
  }
  return corners;
}

/** @brief Fits loops one by one to the previous ones. */
class LoopFitter {
public:
  std::vector<Corner> fit(std::vector<Corner> corners)
  {
    for (Corner& corner : corners)
      corner.place = placeOf(corner);
    dropShort(corners);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Eigen::Vector2d& to = corners[(i + 1) % corners.size()].place;
      facets_.push_back({corners[i], to, boxAround(corners[i].place, to)});
    }
    return corners;
  }

private:
  struct Facet {
    Corner from;
    Eigen::Vector2d to;
    Eigen::AlignedBox2d reach;
  };

  Eigen::AlignedBox2d boxAround(const Eigen::Vector2d& a,
                                const Eigen::Vector2d& b) const
  {
    const Eigen::Vector2d margin = Eigen::Vector2d::Constant(max_snap);
    return {a.cwiseMin(b) - margin, a.cwiseMax(b) + margin};
  }

  /** @brief Returns the nearest place on a facet, else that of the corner itself.
   * @param placeOn returns a place on a facet, and how far from it corners may be */
  template <typename PlaceOn>
  Eigen::Vector2d nearestPlace(const Corner& corner, PlaceOn placeOn) const
  {
    Eigen::Vector2d nearest = corner.place;
    double least = std::numeric_limits<double>::infinity();
    for (const Facet& facet : facets_) {
      if (!facet.reach.contains(corner.place))
        continue;
      const auto [place, tolerance] = placeOn(facet);
      const double distance = (place - corner.place).norm();
      if (distance > tolerance || distance >= least)
        continue;
      least = distance;
      nearest = place;
    }
    return nearest;
  }

  /** @brief Returns the place for a corner: a fixed corner, else a point of an edge. A
   * corner already on an edge keeps its place along it. */
  Eigen::Vector2d placeOf(const Corner& corner) const
  {
    const Eigen::Vector2d on_edge = nearestPlace(corner, [&](const Facet& facet) {
      const PlanElement edge = segment(facet.from.place, facet.to);
      return std::make_pair(edge.pointAt(edge.project(corner.place)),
                            std::max(corner.tolerance, facet.from.edge_tolerance));
    });
    if (!corner.is_joint)
      return on_edge;
    const bool is_put = (on_edge - corner.place).norm() < 1e-6;
    const Eigen::Vector2d joint = nearestPlace(corner, [&](const Facet& facet) {
      const double tolerance =
          std::min(is_put ? min_snap : max_snap,
                   std::max(corner.tolerance, facet.from.tolerance));
      return std::make_pair(facet.from.place, facet.from.is_joint ? tolerance : -1);
    });
    return joint != corner.place ? joint : on_edge;
  }

  /** @brief Removes facets of zero length. */
  static void dropShort(std::vector<Corner>& corners)
  {
    std::vector<Corner> kept;
    for (std::size_t i = 0; i < corners.size(); ++i)
      if ((corners[(i + 1) % corners.size()].place - corners[i].place).norm() > 1e-9)
        kept.push_back(corners[i]);
    corners.swap(kept);
    if (corners.size() < 3)
      corners.clear();
  }

  std::vector<Facet> facets_;
};

} // namespace

double
snapTolerance(const PlanElement& element)
{
  return std::clamp(2 * element.residual, min_snap, max_snap);
}

std::vector<FacetChain>
facetLoops(const RoomLayers& layers, double chord_tolerance)
{
  std::vector<FacetChain> chains;
  LoopFitter fitter;
  for (const auto& loop : layers.loops) {
    FacetChain chain;
    for (const Corner& corner : fitter.fit(cornersOf(loop, chord_tolerance))) {
      chain.corners.push_back(corner.place);
      chain.elements.push_back(corner.element);
    }
    chains.push_back(std::move(chain));
  }
  return chains;
}

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
