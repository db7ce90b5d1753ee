// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace pcl::sedr {

/** @brief A point in plan in integer grid units, within +-2^29 on either axis. The side
 * of a line on which it lies is computed without rounding. */
struct GridPoint {
  std::int32_t x = 0;
  std::int32_t y = 0;

  bool operator==(const GridPoint& o) const { return x == o.x && y == o.y; }
  bool operator!=(const GridPoint& o) const { return !(*this == o); }
  bool operator<(const GridPoint& o) const { return x != o.x ? x < o.x : y < o.y; }
};

/** @brief Returns twice the signed area of a, b, c in square grid units: positive if c
 * is left of the line from a to b. Exact. */
inline std::int64_t
turn(const GridPoint& a, const GridPoint& b, const GridPoint& c)
{
  const auto difference = [](std::int32_t p, std::int32_t q) {
    return static_cast<std::int64_t>(p) - q;
  };
  return difference(b.x, a.x) * difference(c.y, a.y) -
         difference(b.y, a.y) * difference(c.x, a.x);
}

/** @brief Returns the vector between two grid points, grid units. */
inline Eigen::Vector2d
way(const GridPoint& from, const GridPoint& to)
{
  return Eigen::Vector2d(to.x, to.y) - Eigen::Vector2d(from.x, from.y);
}

/** @brief Returns the distance of two grid points, grid units. */
inline double
distance(const GridPoint& a, const GridPoint& b)
{
  return std::hypot(static_cast<double>(a.x) - b.x, static_cast<double>(a.y) - b.y);
}

/** @brief The grid to which a room's plan is rounded. Its unit is a power of two: at
 * most a micrometre for rooms up to 500 m across, coarser for larger ones. */
class PlanGrid {
public:
  PlanGrid() = default;

  /** @param bounds of all points on the grid, metres; not empty */
  explicit PlanGrid(const Eigen::AlignedBox2d& bounds)
  {
    origin_ = bounds.center().array().round();
    const double reach =
        1 + (bounds.max() - origin_).cwiseMax(origin_ - bounds.min()).maxCoeff();
    constexpr int finest = 24; // 60 nm; finer digits are meaningless
    const int bits =
        std::min(finest, 29 - static_cast<int>(std::ceil(std::log2(reach))));
    unit_ = std::ldexp(1.0, -bits);
  }

  /** @brief Returns the length of one grid unit, metres. */
  double unit() const { return unit_; }

  /** @brief Returns the grid point nearest to a place within the bounds, metres. */
  GridPoint toGrid(const Eigen::Vector2d& p) const
  {
    return {static_cast<std::int32_t>(std::lround((p.x() - origin_.x()) / unit_)),
            static_cast<std::int32_t>(std::lround((p.y() - origin_.y()) / unit_))};
  }

  /** @brief Returns the place of a grid point, metres. */
  Eigen::Vector2d toPlan(const GridPoint& p) const
  {
    return origin_ + unit_ * Eigen::Vector2d(p.x, p.y);
  }

private:
  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
  double unit_ = std::ldexp(1.0, -20);
};

/** @brief A straight piece of a loop from `from` to `to`. */
struct GridSegment {
  GridPoint from;
  GridPoint to;
};

/** @brief States that an edge of an arrangement is part of a segment. */
struct SegmentUse {
  std::size_t segment = 0; ///< index of the segment
  bool forward = true;     ///< whether the segment runs from the edge's a to b
};

/** @brief Segments split where they meet: edges share only their ends. */
struct Arrangement {
  struct Edge {
    std::uint32_t a = 0; ///< index of a vertex, the lower of the two
    std::uint32_t b = 0;
    std::vector<SegmentUse> uses; ///< at least one, in the order of the segments
  };

  std::vector<GridPoint> vertices; ///< sorted, all distinct
  std::vector<Edge> edges;         ///< sorted by a and b, all distinct
};

/** @brief Splits segments where they cross or touch, and merges overlaps.
 *
 * Crossings are rounded to the grid (snap rounding, by Boost.Polygon). Vertices nearer
 * than `separation` are merged; ends of early segments stay in place. An edge is led
 * through vertices beside it that are nearer than `separation`. So no edge is shorter
 * than `separation`, and no vertex is nearer to an edge whose ends it sees at more than
 * a right angle. Nothing moves much farther than that. After 50 rounds the arrangement
 * is valid, but not everything may be merged.
 *
 * @param segments coordinates within +-2^29; those of zero length are ignored
 * @param separation grid units, 0 or more
 * @param[out] arrangement the result
 *
 * Deterministic. O(n log n) for n pieces that are well apart. */
void arrangeSegments(const std::vector<GridSegment>& segments,
                     double separation,
                     Arrangement& arrangement);

using PlanTriangles = std::vector<std::array<std::uint32_t, 3>>; ///< indices of points
using PlanEdges = std::vector<std::pair<std::uint32_t, std::uint32_t>>; ///< of points

/** @brief A triangulation of points in plan; triangles are counter-clockwise. */
struct PlanTriangulation {
  static constexpr std::uint32_t none = 0xffffffff;

  PlanTriangles triangles;
  /** @brief Triangle across the edge from corner i to corner i + 1, or none. */
  std::vector<std::array<std::uint32_t, 3>> neighbours;
};

/** @brief Finds a state of each triangle from that outside of all, O(n).
 * @param inside returns the state within a side of a triangle, given that beyond it */
template <typename State, typename Inside>
std::vector<State>
spread(const PlanTriangulation& mesh, const State& outside, const Inside& inside)
{
  constexpr std::uint32_t none = PlanTriangulation::none;
  std::vector<State> states(mesh.triangles.size());
  std::vector<bool> is_known(states.size(), false);
  std::vector<std::uint32_t> waiting;
  const auto reach = [&](std::uint32_t t, std::size_t side, const State& beyond) {
    if (is_known[t])
      return;
    is_known[t] = true;
    states[t] = inside(t, side, beyond);
    waiting.push_back(t);
  };
  for (std::uint32_t t = 0; t < states.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      if (mesh.neighbours[t][i] == none)
        reach(t, i, outside);
  while (!waiting.empty()) {
    const std::uint32_t t = waiting.back();
    waiting.pop_back();
    for (const std::uint32_t n : mesh.neighbours[t])
      for (std::size_t back = 0; n != none && back < 3; ++back)
        if (mesh.neighbours[n][back] == t)
          reach(n, back, states[t]);
  }
  return states;
}

/** @brief Computes the Delaunay triangulation of points, all distinct: triangles of
 * non-zero area, counter-clockwise, that fill their convex hull; none of points on a
 * line. O(n log n).
 * @return false if rounding has left gaps */
bool delaunay(const std::vector<GridPoint>& points, PlanTriangles& triangles);

/** @brief Triangulates the convex hull of `points` so that each of `edges` is a side of
 * triangles. Starts with Boost.Polygon's Delaunay triangulation. Sides that cross an
 * edge are swapped until none does; other sides are swapped to improve the triangles.
 *
 * All triangles have a non-zero area, and none contains another point, not even on its
 * sides.
 *
 * @param points all distinct
 * @param edges they may meet only at their ends and pass through no other point
 * @param[out] triangulation the result; empty if all points are collinear
 * @return false if an edge crosses another or passes through a point
 *
 * Deterministic. O(n log n) plus the swaps. */
bool triangulateConstrained(const std::vector<GridPoint>& points,
                            const PlanEdges& edges,
                            PlanTriangulation& triangulation);

/** @brief Triangulates an area: what an odd number of edges of its rim parts from the
 * outside. Points at which no edge ends are left out. O(n log n) plus the swaps.
 * @param rim as the edges of triangulateConstrained(), all distinct
 * @param folds further edges; none counts if one crosses another or passes through a
 * point
 * @return nothing if an edge of the rim does so */
std::optional<PlanTriangles> trianglesWithin(const std::vector<GridPoint>& points,
                                             const PlanEdges& rim,
                                             const PlanEdges& folds = {});

} // namespace pcl::sedr
