// SPDX-License-Identifier: BSD-3-Clause
#include "plan_facets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
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
cornersOf(const RoomLayers::Loop& loop, double chord_tolerance, double snap_tolerance)
{
  std::vector<Corner> corners;
  const auto& elements = loop.loop->elements;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const double own = snapTolerance(elements[i], snap_tolerance);
    const double before = snapTolerance(
        elements[(i + elements.size() - 1) % elements.size()], snap_tolerance);
    const auto places = PlanLoop{{elements[i]}}.polygon(chord_tolerance);
    for (std::size_t k = 0; k < places.size(); ++k)
      corners.push_back({places[k], loop.first_element + i,
                         k == 0 ? std::max(own, before) : own, own, k == 0});
  }
  return corners;
}

/** @brief Returns the point of the segment from a to b nearest to p. */
Eigen::Vector2d
nearestOn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p)
{
  const Eigen::Vector2d way = b - a;
  const double square = way.squaredNorm();
  const double share = square > 0 ? (p - a).dot(way) / square : 0;
  return a + std::clamp(share, 0.0, 1.0) * way;
}

/** @brief Fits loops one by one to the previous ones. */
class LoopFitter {
public:
  std::vector<Corner> fit(std::vector<Corner> corners)
  {
    for (Corner& corner : corners)
      corner.place = placeOf(corner);
    dropShort(corners);
    corners = ledThroughCorners(corners);
    dropShort(corners);
    for (std::size_t i = 0; i < corners.size(); ++i)
      stand(corners[i], corners[(i + 1) % corners.size()].place);
    return corners;
  }

private:
  struct Facet {
    Corner from;
    Eigen::Vector2d to;
    Eigen::AlignedBox2d reach;
  };

  void stand(const Corner& from, const Eigen::Vector2d& to)
  {
    const Eigen::Vector2d margin =
        Eigen::Vector2d::Constant(std::max(from.tolerance, from.edge_tolerance));
    facets_.push_back(
        {from,
         to,
         {from.place.cwiseMin(to) - margin, from.place.cwiseMax(to) + margin}});
  }

  /** @brief Calls `visit` for the facets that may be near a box. */
  template <typename Visit>
  void visitNear(const Eigen::AlignedBox2d& box, Visit visit) const
  {
    for (const Facet& facet : facets_)
      if (facet.reach.intersects(box))
        visit(facet);
  }

  static Eigen::AlignedBox2d reachOf(const Corner& corner)
  {
    const Eigen::Vector2d margin = Eigen::Vector2d::Constant(corner.tolerance);
    return {corner.place - margin, corner.place + margin};
  }

  /** @brief The nearest of several places within reach of a corner. */
  struct Nearest {
    explicit Nearest(const Corner& corner)
        : from(corner.place)
        , place(corner.place)
        , tolerance(corner.tolerance)
    {}

    void consider(const Eigen::Vector2d& there, double its_tolerance)
    {
      const double d = (there - from).norm();
      if (d > std::max(tolerance, its_tolerance) || d >= least)
        return;
      least = d;
      place = there;
    }

    Eigen::Vector2d from;
    Eigen::Vector2d place;
    double tolerance;
    double least = std::numeric_limits<double>::infinity();
  };

  /** @brief Returns the place for a corner: a fixed corner, else a point of an edge. A
   * corner already on an edge keeps its place along it. */
  Eigen::Vector2d placeOf(const Corner& corner) const
  {
    const Eigen::Vector2d on_edge = nearestOnEdges(corner);
    const bool is_put = (on_edge - corner.place).norm() < 1e-6;
    if (!corner.is_joint)
      return on_edge;
    const Eigen::Vector2d joint = nearestJoint(corner, is_put ? min_snap : max_snap);
    return joint != corner.place ? joint : on_edge;
  }

  /** @brief Returns the nearest fixed joint within reach, else the corner itself. */
  Eigen::Vector2d nearestJoint(const Corner& corner, double most) const
  {
    Nearest nearest(corner);
    nearest.tolerance = std::min(most, corner.tolerance);
    visitNear(reachOf(corner), [&](const Facet& facet) {
      if (facet.from.is_joint)
        nearest.consider(facet.from.place, std::min(most, facet.from.tolerance));
    });
    return nearest.place;
  }

  Eigen::Vector2d nearestOnEdges(const Corner& corner) const
  {
    Nearest nearest(corner);
    visitNear(reachOf(corner), [&](const Facet& facet) {
      nearest.consider(nearestOn(facet.from.place, facet.to, corner.place),
                       facet.from.edge_tolerance);
    });
    return nearest.place;
  }

  std::vector<Corner> ledThroughCorners(const std::vector<Corner>& corners) const
  {
    std::vector<Corner> led;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      led.push_back(corners[i]);
      const Eigen::Vector2d& end = corners[(i + 1) % corners.size()].place;
      for (const Eigen::Vector2d& place : cornersBeside(corners[i], end)) {
        led.push_back(corners[i]);
        led.back().place = place;
        led.back().is_joint = false;
      }
    }
    return led;
  }

  /** @brief Returns the fixed corners beside the facet from `from` to `end`, in order,
   * except those near its ends. */
  std::vector<Eigen::Vector2d> cornersBeside(const Corner& from,
                                             const Eigen::Vector2d& end) const
  {
    const double length = (end - from.place).norm();
    const Eigen::Vector2d way = (end - from.place) / length;
    std::vector<std::pair<double, Eigen::Vector2d>> beside;
    Eigen::AlignedBox2d box = reachOf(from);
    box.extend(end + Eigen::Vector2d::Constant(from.tolerance));
    box.extend(end - Eigen::Vector2d::Constant(from.tolerance));
    visitNear(box, [&](const Facet& facet) {
      const double tolerance = std::max(from.edge_tolerance, facet.from.tolerance);
      const Eigen::Vector2d offset = facet.from.place - from.place;
      const double along = offset.dot(way);
      if (along > tolerance && along < length - tolerance &&
          (offset - along * way).norm() <= tolerance)
        beside.emplace_back(along, facet.from.place);
    });
    std::sort(beside.begin(), beside.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Eigen::Vector2d> places;
    for (const auto& b : beside)
      places.push_back(b.second);
    return places;
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
snapTolerance(const PlanElement& element, double fixed)
{
  return fixed > 0 ? fixed : std::clamp(2 * element.residual, min_snap, max_snap);
}

std::vector<FacetChain>
facetLoops(const RoomLayers& layers, double chord_tolerance, double snap_tolerance)
{
  std::vector<FacetChain> chains;
  LoopFitter fitter;
  for (const auto& loop : layers.loops) {
    FacetChain chain;
    for (const Corner& corner :
         fitter.fit(cornersOf(loop, chord_tolerance, snap_tolerance))) {
      chain.corners.push_back(corner.place);
      chain.elements.push_back(corner.element);
    }
    chains.push_back(std::move(chain));
  }
  return chains;
}

} // namespace pcl::sedr
