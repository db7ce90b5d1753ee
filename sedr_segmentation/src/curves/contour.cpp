// SPDX-License-Identifier: BSD-3-Clause
#include "contour.h"

#include "sedr_filters/src/plan/plan_geometry.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace pcl::sedr {

namespace {

/** @brief The four directions of cell edges: east, north, west, south. */
constexpr std::array<Cell, 4> ways{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/** @brief Returns the cell on the left of the edge from `corner` in direction `way`. A
 * corner has the index of the cell to its north-east. */
Cell
cellLeftOf(Cell corner, int way)
{
  switch (way) {
  case 0:
    return corner;
  case 1:
    return {corner.x - 1, corner.y};
  case 2:
    return {corner.x - 1, corner.y - 1};
  default:
    return {corner.x, corner.y - 1};
  }
}

/** @brief Returns whether a contour runs from `corner` in direction `way`, i.e. only
 * the cell on its left is set. */
bool
isEdge(const CellMask& mask, Cell corner, int way)
{
  return mask.at(cellLeftOf(corner, way)) &&
         !mask.at(cellLeftOf(corner, (way + 3) % 4));
}

Contour
follow(const CellMask& mask,
       Cell corner,
       double cell_size,
       std::vector<std::uint8_t>& seen)
{
  Contour contour;
  int way = 0;
  while (mask.isInside(corner) && !(seen[mask.indexOf(corner)] & (1 << way))) {
    seen[mask.indexOf(corner)] |= static_cast<std::uint8_t>(1 << way);
    contour.emplace_back(corner.x * cell_size, corner.y * cell_size);
    corner = {corner.x + ways[static_cast<std::size_t>(way)].x,
              corner.y + ways[static_cast<std::size_t>(way)].y};
    for (const int turn :
         {1, 0, 3}) // left first: cells that share only a corner stay separate
      if (isEdge(mask, corner, (way + turn) % 4)) {
        way = (way + turn) % 4;
        break;
      }
  }
  return contour;
}

bool
edgesMeet(const Eigen::Vector2d& a,
          const Eigen::Vector2d& b,
          const Eigen::Vector2d& c,
          const Eigen::Vector2d& d)
{
  const double abc = cross(b - a, c - a);
  const double abd = cross(b - a, d - a);
  const double cda = cross(d - c, a - c);
  const double cdb = cross(d - c, b - c);
  if (abc == 0 && abd == 0) {
    const auto overlap = [](double p, double q, double r, double s) {
      return std::max(std::min(p, q), std::min(r, s)) <=
             std::min(std::max(p, q), std::max(r, s));
    };
    return overlap(a.x(), b.x(), c.x(), d.x()) && overlap(a.y(), b.y(), c.y(), d.y());
  }
  return abc * abd <= 0 && cda * cdb <= 0;
}

/** @brief Marks the corners to keep between the kept corners `first` and `last`. */
void
simplify(const std::vector<Eigen::Vector2d>& p,
         std::size_t first,
         std::size_t last,
         double tolerance,
         std::vector<std::uint8_t>& kept)
{
  std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    const Eigen::Vector2d a = p[from % p.size()];
    const Eigen::Vector2d way = p[to % p.size()] - a;
    constexpr double rounding = 1e-9; // of corners as far away the first one counts
    double farthest = tolerance;
    std::size_t split = 0;
    for (std::size_t i = from + 1; i < to; ++i) {
      const Eigen::Vector2d q = p[i % p.size()] - a;
      const double t = way.squaredNorm() > 0
                           ? std::clamp(q.dot(way) / way.squaredNorm(), 0.0, 1.0)
                           : 0;
      const double d = (q - t * way).norm();
      if (d > farthest + rounding) {
        farthest = d;
        split = i;
      }
    }
    if (split == 0)
      continue;
    kept[split % p.size()] = 1;
    open.emplace_back(from, split);
    open.emplace_back(split, to);
  }
}

std::vector<Eigen::Vector2d>
only(const std::vector<Eigen::Vector2d>& places, const std::vector<std::uint8_t>& kept)
{
  std::vector<Eigen::Vector2d> result;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (kept[i])
      result.push_back(places[i]);
  return result;
}

} // namespace

std::vector<Contour>
traceContours(const CellMask& mask, double cell_size)
{
  // One more row and column, so that every corner of a set cell has an index.
  const CellMask wide(mask.toSet(), grown(mask.box(), 1));
  std::vector<std::uint8_t> seen(wide.values().size(), 0);
  std::vector<Contour> contours;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const Cell corner = wide.cellAt(i);
    if (isEdge(wide, corner, 0) && !(seen[i] & 1))
      contours.push_back(follow(wide, corner, cell_size, seen));
  }
  return contours;
}

double
signedArea(const std::vector<Eigen::Vector2d>& polygon)
{
  double area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    area +=
        cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]) /
        2;
  return area;
}

bool
crossesItself(const std::vector<Eigen::Vector2d>& polygon)
{
  const std::size_t n = polygon.size();
  struct Edge {
    std::size_t index;
    Eigen::Vector2d low;
    Eigen::Vector2d high;
  };
  std::vector<Edge> edges(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % n];
    edges[i] = {i, a.cwiseMin(b), a.cwiseMax(b)};
  }
  // Sweep from left to right: only edges that begin before another ends can meet it.
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.low.x() < b.low.x(); });
  for (auto a = edges.begin(); a != edges.end(); ++a)
    for (auto b = a + 1; b != edges.end() && b->low.x() <= a->high.x(); ++b) {
      const auto [i, j] = std::minmax(a->index, b->index);
      if (j < i + 2 || (i == 0 && j + 1 == n) || b->low.y() > a->high.y() ||
          a->low.y() > b->high.y())
        continue;
      if (edgesMeet(polygon[i], polygon[i + 1], polygon[j], polygon[(j + 1) % n]))
        return true;
    }
  return false;
}

std::vector<Eigen::Vector2d>
simplified(const std::vector<Eigen::Vector2d>& polygon, double tolerance)
{
  if (polygon.size() < 4)
    return polygon;
  // Two corners that always stay: the one with minimum x + y, and the one farthest from
  // it.
  std::size_t first = 0;
  for (std::size_t i = 1; i < polygon.size(); ++i)
    if (polygon[i].x() + polygon[i].y() < polygon[first].x() + polygon[first].y())
      first = i;
  std::size_t far = first;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if ((polygon[i] - polygon[first]).norm() > (polygon[far] - polygon[first]).norm())
      far = i;
  if (far < first)
    far += polygon.size();
  std::vector<std::uint8_t> kept(polygon.size(), 0);
  kept[first] = kept[far % polygon.size()] = 1;
  simplify(polygon, first, far, tolerance, kept);
  simplify(polygon, far, first + polygon.size(), tolerance, kept);
  return only(polygon, kept);
}

std::vector<Eigen::Vector2d>
simplifiedLine(const std::vector<Eigen::Vector2d>& line, double tolerance)
{
  if (line.size() < 3)
    return line;
  std::vector<std::uint8_t> kept(line.size(), 0);
  kept.front() = kept.back() = 1;
  simplify(line, 0, line.size() - 1, tolerance, kept);
  return only(line, kept);
}

} // namespace pcl::sedr
