// SPDX-License-Identifier: BSD-3-Clause
#include "constrained_triangulation.h"

#include "delaunay.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace pcl::sedr {
namespace {

/** @brief A triangulation whose inner sides can be swapped for the other diagonal of
 * their two triangles. */
class SwappableTriangulation {
public:
  static constexpr std::uint32_t none = PlanTriangulation::none;

  /** @param triangles counter-clockwise, covering the points' convex hull */
  SwappableTriangulation(const std::vector<GridPoint>& points,
                         std::vector<std::array<std::uint32_t, 3>> triangles)
      : points_(points)
      , anchor_(points.size(), none)
      , degree_(points.size(), 0)
  {
    mesh_.triangles = std::move(triangles);
    connect();
  }

  /** @brief Swaps sides until one joins a and b, and fixes that side.
   * @return false if a point or a fixed side is in the way */
  bool insertEdge(std::uint32_t a, std::uint32_t b)
  {
    const Ends wanted = std::minmax(a, b);
    if (find(wanted).triangle == none) {
      std::vector<Ends> crossed;
      if (!crossedBy(a, b, crossed))
        return false;
      for (const Ends& side : crossed)
        if (fixed_.count(side) > 0)
          return false;
      // A side of a concave pair waits until others are swapped. Some pair is always
      // convex, so the loop terminates.
      std::deque<Ends> waiting(crossed.begin(), crossed.end());
      while (!waiting.empty()) {
        const Side side = find(waiting.front());
        if (!isConvex(side)) {
          waiting.push_back(waiting.front());
          waiting.pop_front();
          continue;
        }
        waiting.pop_front();
        const Ends diagonal = swap(side);
        if (crosses(diagonal, a, b))
          waiting.push_back(diagonal);
      }
    }
    fixed_.insert(wanted);
    return true;
  }

  /** @brief Swaps sides that are not fixed until all are Delaunay. */
  void improve()
  {
    struct Waiting {
      Side side;
      Ends ends; ///< of the side when it was queued
    };
    std::vector<Waiting> waiting;
    const auto add = [&](std::uint32_t t) {
      for (std::size_t i = 0; i < 3; ++i)
        if (neighbour({t, i}) != none)
          waiting.push_back({{t, i}, std::minmax(corner(t, i), corner(t, i + 1))});
    };
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
      add(t);
    // Swaps towards the Delaunay triangulation cannot cycle.
    while (!waiting.empty()) {
      const Side side = waiting.back().side;
      const Ends ends = waiting.back().ends;
      waiting.pop_back();
      // The new sides of a triangle swapped since are already queued.
      const Ends now = std::minmax(corner(side.triangle, side.number),
                                   corner(side.triangle, side.number + 1));
      if (now != ends || fixed_.count(ends) > 0 || !isConvex(side) || !isWorse(side))
        continue;
      const std::uint32_t other = neighbour(side);
      swap(side);
      add(side.triangle);
      add(other);
    }
  }

  const PlanTriangulation& triangulation() const { return mesh_; }

private:
  /** @brief Side `number` of a triangle: from that corner to the next. */
  struct Side {
    std::uint32_t triangle = none;
    std::size_t number = 0;
  };
  using Ends = std::pair<std::uint32_t, std::uint32_t>; ///< lower index first

  void connect()
  {
    mesh_.neighbours.assign(mesh_.triangles.size(), {none, none, none});
    std::map<std::pair<std::uint32_t, std::uint32_t>, Side> sides;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        anchor_[corner(t, i)] = t;
        ++degree_[corner(t, i)];
        sides[{corner(t, i), corner(t, i + 1)}] = {t, i};
      }
    for (const auto& [way, side] : sides) {
      const auto twin = sides.find({way.second, way.first});
      if (twin != sides.end())
        mesh_.neighbours[side.triangle][side.number] = twin->second.triangle;
    }
  }

  std::uint32_t corner(std::uint32_t t, std::size_t i) const
  {
    return mesh_.triangles[t][i % 3];
  }

  std::uint32_t neighbour(const Side& side) const
  {
    return mesh_.neighbours[side.triangle][side.number % 3];
  }

  /** @brief Returns the same side seen from the triangle across it, starting at the
   * other end; the side must be inner. */
  Side across(const Side& side) const
  {
    const std::uint32_t other = neighbour(side);
    // There the side has the opposite direction: it starts at this side's end.
    return {other, numberOf(other, corner(side.triangle, side.number + 1))};
  }

  /** @brief Returns which corner of t is point p. */
  std::size_t numberOf(std::uint32_t t, std::uint32_t p) const
  {
    return corner(t, 0) == p ? 0 : corner(t, 1) == p ? 1 : 2;
  }

  /** @brief Calls `visit(triangle, corner number)` for the triangles at a point until
   * it returns true. */
  template <typename Visit>
  void visitAround(std::uint32_t point, Visit visit) const
  {
    const std::uint32_t first = anchor_[point];
    if (first == none)
      return;
    std::uint32_t t = first;
    do { // counter-clockwise, to the hull or once around
      const std::size_t i = numberOf(t, point);
      if (visit(t, i))
        return;
      t = neighbour({t, i + 2});
    } while (t != none && t != first);
    if (t == first)
      return;
    for (t = neighbour({first, numberOf(first, point)}); t != none;
         t = neighbour({t, numberOf(t, point)}))
      if (visit(t, numberOf(t, point)))
        return;
  }

  /** @brief Returns the side that joins two points; its triangle is none if there is
   * none. */
  Side find(const Ends& ends) const
  {
    // Around the end with fewer triangles, as the other may have thousands.
    const bool first_is_less = degree_[ends.first] <= degree_[ends.second];
    const std::uint32_t here = first_is_less ? ends.first : ends.second;
    const std::uint32_t there = first_is_less ? ends.second : ends.first;
    Side found;
    visitAround(here, [&](std::uint32_t t, std::size_t i) {
      if (corner(t, i + 1) == there)
        found = {t, i};
      else if (corner(t, i + 2) == there)
        found = {t, (i + 2) % 3};
      return found.triangle != none;
    });
    return found;
  }

  /** @brief Finds the sides that the segment from a to b crosses, in order.
   * @return false if a point lies on the segment */
  bool crossedBy(std::uint32_t a, std::uint32_t b, std::vector<Ends>& crossed) const
  {
    const GridPoint& pa = points_[a];
    const GridPoint& pb = points_[b];
    Side side;
    visitAround(a, [&](std::uint32_t t, std::size_t i) {
      if (turn(pa, points_[corner(t, i + 1)], pb) > 0 &&
          turn(pa, points_[corner(t, i + 2)], pb) < 0)
        side = {t, (i + 1) % 3};
      return side.triangle != none;
    });
    while (side.triangle != none && neighbour(side) != none) {
      crossed.push_back(std::minmax(corner(side.triangle, side.number),
                                    corner(side.triangle, side.number + 1)));
      const Side twin = across(side);
      const std::uint32_t apex = corner(twin.triangle, twin.number + 2);
      if (apex == b)
        return true;
      const std::int64_t at = turn(pa, pb, points_[apex]);
      if (at == 0)
        return false;
      // The twin runs from left to right of the direction.
      side = {twin.triangle, (twin.number + (at > 0 ? 1 : 2)) % 3};
    }
    return false;
  }

  bool crosses(const Ends& side, std::uint32_t a, std::uint32_t b) const
  {
    if (side.first == a || side.first == b || side.second == a || side.second == b)
      return false;
    const std::int64_t first = turn(points_[a], points_[b], points_[side.first]);
    const std::int64_t second = turn(points_[a], points_[b], points_[side.second]);
    return (first < 0) != (second < 0);
  }

  bool isConvex(const Side& side) const
  {
    const Side twin = across(side);
    const GridPoint& a = points_[corner(side.triangle, side.number)];
    const GridPoint& b = points_[corner(side.triangle, side.number + 1)];
    const GridPoint& c = points_[corner(side.triangle, side.number + 2)];
    const GridPoint& d = points_[corner(twin.triangle, twin.number + 2)];
    return turn(a, d, c) > 0 && turn(d, b, c) > 0;
  }

  /** @brief Returns whether the opposite corner lies within the triangle's
   * circumcircle. */
  bool isWorse(const Side& side) const
  {
    const Side twin = across(side);
    const GridPoint& d = points_[corner(twin.triangle, twin.number + 2)];
    long double x[3];
    long double y[3];
    long double square[3];
    for (std::size_t i = 0; i < 3; ++i) {
      const GridPoint& p = points_[corner(side.triangle, side.number + i)];
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

  /** @brief Swaps a side for the other diagonal and returns the ends of that. */
  Ends swap(const Side& side)
  {
    const std::uint32_t t = side.triangle;
    const Side twin = across(side);
    const std::uint32_t u = twin.triangle;
    const std::uint32_t a = corner(t, side.number);
    const std::uint32_t b = corner(t, side.number + 1);
    const std::uint32_t c = corner(t, side.number + 2);
    const std::uint32_t d = corner(u, twin.number + 2);
    const std::uint32_t beyond_bc = neighbour({t, side.number + 1});
    const std::uint32_t beyond_ca = neighbour({t, side.number + 2});
    const std::uint32_t beyond_ad = neighbour({u, twin.number + 1});
    const std::uint32_t beyond_db = neighbour({u, twin.number + 2});
    mesh_.triangles[t] = {a, d, c};
    mesh_.neighbours[t] = {beyond_ad, u, beyond_ca};
    mesh_.triangles[u] = {d, b, c};
    mesh_.neighbours[u] = {beyond_db, beyond_bc, t};
    relink(beyond_ad, u, t);
    relink(beyond_bc, t, u);
    anchor_[a] = anchor_[c] = anchor_[d] = t;
    anchor_[b] = u;
    --degree_[a];
    --degree_[b];
    ++degree_[c];
    ++degree_[d];
    return std::minmax(c, d);
  }

  void relink(std::uint32_t triangle, std::uint32_t from, std::uint32_t to)
  {
    if (triangle == none)
      return;
    for (auto& n : mesh_.neighbours[triangle])
      if (n == from) {
        n = to;
        return;
      }
  }

  const std::vector<GridPoint>& points_;
  PlanTriangulation mesh_;
  std::vector<std::uint32_t> anchor_; ///< a triangle at each point
  std::vector<std::uint32_t> degree_; ///< triangles at each point
  std::set<Ends> fixed_;
};

} // namespace

bool
triangulateConstrained(
    const std::vector<GridPoint>& points,
    const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges,
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

std::vector<bool>
insideOf(const PlanTriangulation& mesh,
         std::vector<std::pair<std::uint32_t, std::uint32_t>> edges)
{
  for (auto& edge : edges)
    if (edge.first > edge.second)
      std::swap(edge.first, edge.second);
  std::sort(edges.begin(), edges.end());
  const auto isEdge = [&](std::uint32_t t, std::size_t i) {
    const auto& corners = mesh.triangles[t];
    const std::pair<std::uint32_t, std::uint32_t> ends =
        std::minmax(corners[i], corners[(i + 1) % 3]);
    return std::binary_search(edges.begin(), edges.end(), ends);
  };
  std::vector<bool> is_inside(mesh.triangles.size(), false);
  std::vector<bool> is_known(mesh.triangles.size(), false);
  std::vector<std::uint32_t> waiting;
  const auto reach = [&](std::uint32_t t, bool inside) {
    if (is_known[t])
      return;
    is_known[t] = true;
    is_inside[t] = inside;
    waiting.push_back(t);
  };
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      if (mesh.neighbours[t][i] == PlanTriangulation::none)
        reach(t, isEdge(t, i));
  while (!waiting.empty()) {
    const std::uint32_t t = waiting.back();
    waiting.pop_back();
    for (std::size_t i = 0; i < 3; ++i)
      if (mesh.neighbours[t][i] != PlanTriangulation::none)
        reach(mesh.neighbours[t][i], is_inside[t] != isEdge(t, i));
  }
  return is_inside;
}

std::optional<PlanTriangles>
trianglesWithin(const std::vector<GridPoint>& points,
                const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges,
                const std::vector<std::pair<std::uint32_t, std::uint32_t>>& rim)
{
  PlanTriangulation all;
  if (!triangulateConstrained(points, edges, all))
    return std::nullopt;
  const std::vector<bool> is_inside = insideOf(all, rim);
  PlanTriangles inside;
  for (std::size_t t = 0; t < is_inside.size(); ++t)
    if (is_inside[t])
      inside.push_back(all.triangles[t]);
  return inside;
}

} // namespace pcl::sedr
