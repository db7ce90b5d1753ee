// SPDX-License-Identifier: BSD-3-Clause
#include "triangulation.h"

#include "sedr_surface/src/triangulation/constrained_triangulation.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <utility>

namespace pcl::sedr::sim {

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::vector<GridPoint>
onGrid(const std::vector<Vec2>& points, const Ring& used)
{
  Eigen::AlignedBox2d bounds;
  for (const std::size_t i : used)
    bounds.extend(Eigen::Vector2d(points[i].x, points[i].y));
  const PlanGrid grid(bounds);
  std::vector<GridPoint> result;
  for (const std::size_t i : used)
    result.push_back(grid.toGrid({points[i].x, points[i].y}));
  return result;
}

/** @brief Returns which triangles lie to the left of the edges. */
std::vector<bool>
leftOf(const std::set<Edge>& edges, const PlanTriangulation& all)
{
  const auto side = [&all](std::size_t t, std::size_t k) {
    return Edge(all.triangles[t][k], all.triangles[t][(k + 1) % 3]);
  };
  std::vector<bool> is_left(all.triangles.size(), false);
  std::vector<std::size_t> open;
  const auto add = [&](std::size_t t) {
    if (!is_left[t])
      open.push_back(t);
    is_left[t] = true;
  };
  for (std::size_t t = 0; t < is_left.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (edges.count(side(t, k)) > 0)
        add(t);
  while (!open.empty()) {
    const std::size_t t = open.back();
    open.pop_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge edge = side(t, k);
      if (edges.count(edge) > 0)
        continue;
      const std::uint32_t next = all.neighbours[t][k];
      if (next == PlanTriangulation::none || edges.count({edge.second, edge.first}) > 0)
        throw std::invalid_argument("A hole lies outside of every polygon");
      add(next);
    }
  }
  return is_left;
}

} // namespace

std::vector<Triangle>
triangulate(const std::vector<Vec2>& points, const std::vector<Ring>& rings)
{
  Ring used;
  for (const Ring& ring : rings)
    used.insert(used.end(), ring.begin(), ring.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  if (used.empty())
    return {};
  const auto place = [&used](std::size_t point) {
    return static_cast<std::uint32_t>(
        std::lower_bound(used.begin(), used.end(), point) - used.begin());
  };
  std::set<Edge> edges;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      edges.emplace(place(ring[i]), place(ring[(i + 1) % ring.size()]));
  PlanTriangulation all;
  if (!triangulateConstrained(onGrid(points, used), {edges.begin(), edges.end()}, all))
    throw std::invalid_argument("The outline of a polygon crosses or touches itself");
  const std::vector<bool> is_inside = leftOf(edges, all);
  std::vector<Triangle> triangles;
  for (std::size_t t = 0; t < is_inside.size(); ++t)
    if (is_inside[t])
      triangles.push_back({used[all.triangles[t][0]], used[all.triangles[t][1]],
                           used[all.triangles[t][2]]});
  return triangles;
}

} // namespace pcl::sedr::sim
