// SPDX-License-Identifier: BSD-3-Clause
#include "triangulation.h"

#include <boost/polygon/voronoi.hpp>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <map>
#include <set>

namespace pcl::sedr {
namespace {

/** @brief Cuts a polygon of cocircular points, counter-clockwise, into triangles of
 * non-zero area. */
bool
cutPolygon(const std::vector<GridPoint>& points,
           std::vector<std::uint32_t> polygon,
           PlanTriangles& triangles)
{
  while (polygon.size() >= 3) {
    const std::size_t n = polygon.size();
    std::size_t ear = 0;
    while (ear < n && turn(points[polygon[(ear + n - 1) % n]], points[polygon[ear]],
                           points[polygon[(ear + 1) % n]]) <= 0)
      ++ear;
    if (ear == n)
      return false;
    triangles.push_back(
        {polygon[(ear + n - 1) % n], polygon[ear], polygon[(ear + 1) % n]});
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return true;
}

} // namespace

bool
delaunay(const std::vector<GridPoint>& points, PlanTriangles& triangles)
{
  std::vector<boost::polygon::point_data<std::int32_t>> sites;
  sites.reserve(points.size());
  for (const GridPoint& p : points)
    sites.emplace_back(p.x, p.y);
  boost::polygon::voronoi_diagram<double> diagram;
  boost::polygon::construct_voronoi(sites.begin(), sites.end(), &diagram);
  // A polygon around each vertex of the Voronoi diagram, from the points of its cells.
  for (const auto& vertex : diagram.vertices()) {
    std::vector<std::uint32_t> polygon;
    const auto* edge = vertex.incident_edge();
    do {
      polygon.push_back(static_cast<std::uint32_t>(edge->cell()->source_index()));
      edge = edge->rot_next();
    } while (edge != vertex.incident_edge());
    if (!cutPolygon(points, std::move(polygon), triangles))
      return false;
  }
  return true;
}

namespace {

constexpr std::uint32_t none = PlanTriangulation::none;

/** @brief A triangulation whose inner sides can be swapped for the other diagonal of
 * their two triangles. */
class SwappableTriangulation {
public:
  /** @param triangles counter-clockwise, covering the points' convex hull */
  SwappableTriangulation(const std::vector<GridPoint>& points,
                         std::vector<std::array<std::uint32_t, 3>> triangles)
      : points_(points)
      , triangles_(std::move(triangles))
  {
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      enter(t);
  }

  /** @brief Swaps sides until one joins a and b, and fixes that side.
   * @return false if a point or a fixed side is in the way */
  bool insertEdge(std::uint32_t a, std::uint32_t b)
  {
    if (leftOf({a, b}) == none && leftOf({b, a}) == none) {
      std::vector<Side> crossed;
      if (!crossedBy(a, b, crossed))
        return false;
      for (const Side& side : crossed)
        if (fixed_.count(side) > 0)
          return false;
      // A side of a concave pair waits until others are swapped. Some pair is always
      // convex, so the loop terminates.
      std::deque<Side> waiting(crossed.begin(), crossed.end());
      while (!waiting.empty()) {
        const Side side = waiting.front();
        waiting.pop_front();
        if (!isConvex(side)) {
          waiting.push_back(side);
          continue;
        }
        const Side diagonal = swap(side);
        if (crosses(diagonal, a, b))
          waiting.push_back(diagonal);
      }
    }
    fixed_.insert(std::minmax(a, b));
    return true;
  }

  /** @brief Swaps sides that are not fixed until all are Delaunay. */
  void improve()
  {
    struct Waiting {
      std::uint32_t triangle;
      std::size_t number;
      Side side; ///< when it was queued
    };
    std::vector<Waiting> waiting;
    const auto add = [&](std::uint32_t t) {
      for (std::size_t i = 0; i < 3; ++i)
        if (leftOf(reverse(sideOf(t, i))) != none)
          waiting.push_back({t, i, sideOf(t, i)});
    };
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      add(t);
    // Swaps towards the Delaunay triangulation cannot cycle.
    while (!waiting.empty()) {
      const auto [t, number, side] = waiting.back();
      waiting.pop_back();
      // The new sides of a triangle swapped since are already queued.
      if (sideOf(t, number) != side ||
          fixed_.count(std::minmax(side.first, side.second)) > 0 || !isConvex(side) ||
          !isWorse(side))
        continue;
      const std::uint32_t other = leftOf(reverse(side));
      swap(side);
      add(t);
      add(other);
    }
  }

  PlanTriangulation triangulation() const
  {
    PlanTriangulation result{triangles_, {}};
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      result.neighbours.push_back({leftOf(reverse(sideOf(t, 0))),
                                   leftOf(reverse(sideOf(t, 1))),
                                   leftOf(reverse(sideOf(t, 2)))});
    return result;
  }

private:
  /** @brief A side of a triangle, with its inside on the left. */
  using Side = std::pair<std::uint32_t, std::uint32_t>;

  static Side reverse(const Side& side) { return {side.second, side.first}; }

  Side sideOf(std::uint32_t t, std::size_t number) const
  {
    return {triangles_[t][number], triangles_[t][(number + 1) % 3]};
  }

  void enter(std::uint32_t t)
  {
    for (std::size_t i = 0; i < 3; ++i)
      left_of_[sideOf(t, i)] = t;
  }

  /** @brief Returns the triangle on the left of a side, or none. */
  std::uint32_t leftOf(const Side& side) const
  {
    const auto found = left_of_.find(side);
    return found == left_of_.end() ? none : found->second;
  }

  /** @brief Returns the corner of the triangle on the left that is not on the side. */
  std::uint32_t apexOf(const Side& side) const
  {
    const auto& corners = triangles_[leftOf(side)];
    return corners[0] != side.first && corners[0] != side.second   ? corners[0]
           : corners[1] != side.first && corners[1] != side.second ? corners[1]
                                                                   : corners[2];
  }

  /** @brief Finds the sides that the segment from a to b crosses, in order; the lower
   * index of each first.
   * @return false if a point lies on the segment */
  bool crossedBy(std::uint32_t a, std::uint32_t b, std::vector<Side>& crossed) const
  {
    const GridPoint& pa = points_[a];
    const GridPoint& pb = points_[b];
    Side side(none, none);
    for (auto at = left_of_.lower_bound({a, 0});
         at != left_of_.end() && at->first.first == a; ++at) {
      const Side opposite(at->first.second, apexOf(at->first));
      if (turn(pa, points_[opposite.first], pb) > 0 &&
          turn(pa, points_[opposite.second], pb) < 0)
        side = opposite;
    }
    while (leftOf(reverse(side)) != none) {
      crossed.push_back(std::minmax(side.first, side.second));
      const std::uint32_t apex = apexOf(reverse(side));
      if (apex == b)
        return true;
      const std::int64_t at = turn(pa, pb, points_[apex]);
      if (at == 0)
        return false;
      side = at > 0 ? Side(side.first, apex) : Side(apex, side.second);
    }
    return false;
  }

  bool crosses(const Side& side, std::uint32_t a, std::uint32_t b) const
  {
    if (side.first == a || side.first == b || side.second == a || side.second == b)
      return false;
    const std::int64_t first = turn(points_[a], points_[b], points_[side.first]);
    const std::int64_t second = turn(points_[a], points_[b], points_[side.second]);
    return (first < 0) != (second < 0);
  }

  bool isConvex(const Side& side) const
  {
    const GridPoint& c = points_[apexOf(side)];
    const GridPoint& d = points_[apexOf(reverse(side))];
    return turn(points_[side.first], d, c) > 0 && turn(d, points_[side.second], c) > 0;
  }

  /** @brief Returns whether the opposite corner lies within the triangle's
   * circumcircle. */
  bool isWorse(const Side& side) const
  {
    const GridPoint& d = points_[apexOf(reverse(side))];
    const std::uint32_t corners[3] = {side.first, side.second, apexOf(side)};
    long double x[3];
    long double y[3];
    long double square[3];
    for (std::size_t i = 0; i < 3; ++i) {
      const GridPoint& p = points_[corners[i]];
      x[i] = static_cast<long double>(p.x) - d.x;
      y[i] = static_cast<long double>(p.y) - d.y;
      square[i] = x[i] * x[i] + y[i] * y[i];
    }
    long double sum = 0;
    long double size = 0;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      sum += square[i] * (x[j] * y[k] - x[k] * y[j]);
      size += square[i] * (std::abs(x[j] * y[k]) + std::abs(x[k] * y[j]));
    }
    // Tolerates rounding for cocircular points; otherwise they would be swapped
    // forever.
    return sum > 1e-13L * size;
  }

  /** @brief Swaps a side for the other diagonal and returns that, the lower index
   * first. */
  Side swap(const Side& side)
  {
    const auto [a, b] = side;
    const std::uint32_t c = apexOf(side);
    const std::uint32_t d = apexOf(reverse(side));
    const std::uint32_t t = leftOf(side);
    const std::uint32_t u = leftOf(reverse(side));
    left_of_.erase(side);
    left_of_.erase(reverse(side));
    triangles_[t] = {a, d, c};
    triangles_[u] = {d, b, c};
    enter(t);
    enter(u);
    return std::minmax(c, d);
  }

  const std::vector<GridPoint>& points_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::map<Side, std::uint32_t> left_of_; ///< triangle on the left of each side
  std::set<Side> fixed_;                  ///< the lower index first
};

/** @brief Returns which triangles lie inside the area enclosed by a rim: those that an
 * odd number of its edges parts from the outside. O(n log n).
 * @param rim sides of triangles, sorted, the lower index of each first */
std::vector<bool>
insideOf(const PlanTriangulation& mesh, const PlanEdges& rim)
{
  return spread(mesh, false, [&](std::uint32_t t, std::size_t i, bool beyond) {
    const auto& corners = mesh.triangles[t];
    const std::pair<std::uint32_t, std::uint32_t> ends =
        std::minmax(corners[i], corners[(i + 1) % 3]);
    return beyond != std::binary_search(rim.begin(), rim.end(), ends);
  });
}

} // namespace

bool
triangulateConstrained(const std::vector<GridPoint>& points,
                       const PlanEdges& edges,
                       PlanTriangulation& triangulation)
{
  triangulation = PlanTriangulation();
  PlanTriangles triangles;
  if (!delaunay(points, triangles))
    return false;
  if (triangles.empty())
    return true;
  SwappableTriangulation swappable(points, std::move(triangles));
  for (const auto& [a, b] : edges)
    if (!swappable.insertEdge(a, b))
      return false;
  swappable.improve();
  triangulation = swappable.triangulation();
  return true;
}

std::optional<PlanTriangles>
trianglesWithin(const std::vector<GridPoint>& points,
                const PlanEdges& rim,
                const PlanEdges& folds)
{
  std::vector<std::uint32_t> number(points.size(), none); // of the points at edges
  std::vector<std::uint32_t> used;
  std::vector<GridPoint> places;
  const auto numberOf = [&](std::uint32_t p) {
    if (number[p] == none) {
      number[p] = static_cast<std::uint32_t>(used.size());
      used.push_back(p);
      places.push_back(points[p]);
    }
    return number[p];
  };
  const auto renumbered = [&](const PlanEdges& edges) {
    PlanEdges result;
    for (const auto& [from, to] : edges) {
      const std::uint32_t a = numberOf(from);
      const std::uint32_t b = numberOf(to);
      result.push_back(std::minmax(a, b));
    }
    std::sort(result.begin(), result.end());
    return result;
  };
  const PlanEdges own_rim = renumbered(rim);
  PlanEdges edges = renumbered(folds);
  edges.insert(edges.end(), own_rim.begin(), own_rim.end());
  std::sort(edges.begin(), edges.end());
  PlanTriangulation all;
  if (!triangulateConstrained(places, edges, all) &&
      !triangulateConstrained(places, own_rim, all))
    return std::nullopt;
  const std::vector<bool> is_inside = insideOf(all, own_rim);
  PlanTriangles inside;
  for (std::size_t t = 0; t < is_inside.size(); ++t)
    if (is_inside[t]) {
      const auto& corners = all.triangles[t];
      inside.push_back({used[corners[0]], used[corners[1]], used[corners[2]]});
    }
  return inside;
}

} // namespace pcl::sedr
