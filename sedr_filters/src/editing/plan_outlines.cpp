// SPDX-License-Identifier: BSD-3-Clause
#include "plan_outlines.h"

#include "../base/number_text.h"
#include "../plan/plan_bounds.h"

#include "../walls/tilted_walls.h"
#include <pcl/sedr_filters/plan_editor.h>
#include <pcl/sedr_filters/plan_measures.h>

#define BOOST_ALLOW_DEPRECATED_HEADERS // Boost.Geometry includes one
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/polygon/polygon.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace pcl::sedr {
namespace {

/** @brief Returns how large the area is that two outlines have in common, square
 * metres. */
double
commonArea(const PlanLoop& a, const PlanLoop& b)
{
  namespace bp = boost::polygon;
  using namespace bp::operators;
  constexpr double chord = 0.005;
  constexpr double unit = 1e-4; // metres
  const Eigen::AlignedBox2d box = boundsOf(a);
  if (!box.intersects(boundsOf(b)))
    return 0;
  const auto areaOf = [&](const PlanLoop& loop) {
    std::vector<bp::point_data<int>> corners;
    for (const Eigen::Vector2d& p : loop.polygon(chord)) {
      const Eigen::Vector2d at = (p - box.min()) / unit;
      corners.emplace_back(static_cast<int>(std::lround(at.x())),
                           static_cast<int>(std::lround(at.y())));
    }
    bp::polygon_data<int> polygon;
    polygon.set(corners.begin(), corners.end());
    bp::polygon_set_data<int> set;
    set.insert(polygon);
    return set;
  };
  bp::polygon_set_data<int> common = areaOf(a);
  common &= areaOf(b);
  return static_cast<double>(bp::area(common)) * unit * unit;
}

} // namespace

std::optional<Eigen::Vector2d>
crossing(const PlanElement& a, const PlanElement& b)
{
  const Eigen::Vector2d u = a.end - a.start;
  const Eigen::Vector2d v = b.end - b.start;
  const double area = cross(u, v);
  const Eigen::Vector2d off = b.start - a.start;
  if (std::abs(area) <= 1e-12)
    return std::nullopt;
  const double s = cross(off, v) / area;
  const double t = cross(off, u) / area;
  if (s < 0 || s > 1 || t < 0 || t > 1)
    return std::nullopt;
  return a.start + s * u;
}

std::string
outlineProblem(const PlanLoop& loop)
{
  constexpr double chord = 0.005;
  if (loop.elements.empty())
    return "is empty";
  if (loop.area() <= 0)
    return "is clockwise";
  if (loop.area() < touching * loop.length())
    return "encloses " + numberText(loop.area()) + " m2 only";
  const std::vector<Eigen::Vector2d> corners = loop.polygon(chord);
  const std::size_t n = corners.size();
  const auto chordAt = [&](std::size_t k) {
    return segment(corners[k], corners[(k + 1) % n]);
  };
  namespace bg = boost::geometry;
  using Point = bg::model::d2::point_xy<double>;
  using Box = bg::model::box<Point>;
  std::vector<std::pair<Box, std::size_t>> boxes;
  for (std::size_t k = 0; k < n; ++k) {
    const Eigen::Vector2d low = corners[k].cwiseMin(corners[(k + 1) % n]);
    const Eigen::Vector2d high = corners[k].cwiseMax(corners[(k + 1) % n]);
    boxes.emplace_back(Box({low.x(), low.y()}, {high.x(), high.y()}), k);
  }
  const bg::index::rtree<std::pair<Box, std::size_t>, bg::index::quadratic<16>> tree(
      boxes);
  for (const auto& [box, a] : boxes)
    for (auto near = tree.qbegin(bg::index::intersects(box)); near != tree.qend();
         ++near) {
      const std::size_t b = near->second;
      if (b < a + 2 || (a == 0 && b + 1 == n))
        continue;
      if (const auto at = crossing(chordAt(a), chordAt(b)))
        return "crosses itself near (" + numberText(at->x()) + ", " +
               numberText(at->y()) + ")";
    }
  return {};
}

void
simplify(PlanLoop& loop)
{
  auto& e = loop.elements;
  e.erase(
      std::remove_if(e.begin(), e.end(),
                     [](const PlanElement& part) { return part.length() < touching; }),
      e.end());
  for (std::size_t k = 0; e.size() > 3 && k < e.size();) {
    PlanElement& next = e[(k + 1) % e.size()];
    const Eigen::Vector2d way = (e[k].end - e[k].start).normalized();
    if (e[k].isArc() || next.isArc() || e[k].tilt != next.tilt ||
        std::abs(cross(way, next.end - e[k].start)) > touching ||
        way.dot(next.end - next.start) < 0) {
      ++k;
      continue;
    }
    // The evidence of both, weighted by their lengths.
    const double share = e[k].length() / (e[k].length() + next.length());
    const auto mean = [&](double ElementEvidence::*part) {
      next.evidence.*part =
          share * (e[k].evidence.*part) + (1 - share) * (next.evidence.*part);
    };
    mean(&ElementEvidence::seen);
    mean(&ElementEvidence::hidden);
    mean(&ElementEvidence::opening);
    next.inliers += e[k].inliers;
    next.residual = std::max(next.residual, e[k].residual);
    next.start = e[k].start;
    e.erase(e.begin() + static_cast<std::ptrdiff_t>(k));
  }
}

std::string
meetAgain(const std::vector<PlanElement>& lines, PlanLoop& loop)
{
  PlanLoop moved{lines};
  std::vector<bool> is_moved;
  for (std::size_t k = 0; k < lines.size(); ++k)
    is_moved.push_back(lines[k].start != loop.elements[k].start ||
                       lines[k].end != loop.elements[k].end);
  rejoin(moved, is_moved);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const PlanElement& wall = moved.elements[k];
    Eigen::Vector2d way;
    if (std::abs(offLine(lines[k], wall.start, way)) > touching ||
        std::abs(offLine(lines[k], wall.end, way)) > touching)
      return "it would no longer meet the wall beside it";
    if (!wall.isArc() &&
        (wall.end - wall.start).dot(lines[k].end - lines[k].start) <= 0)
      return "wall " + std::to_string(k + 1) + " would vanish";
  }
  loop = std::move(moved);
  return {};
}

std::string
overlapProblem(const Floorplan& plan, const PlanLoop& before, const PlanRoom& after)
{
  constexpr double negligible = 1e-3; // square metres
  for (const PlanRoom& other : plan.rooms) {
    if (other.id == after.id || !shareHeights(other, after))
      continue;
    const double area = commonArea(after.boundary, other.boundary);
    if (area > commonArea(before, other.boundary) + negligible)
      return "room " + std::to_string(after.id) + " would then overlap room " +
             std::to_string(other.id) + " by " +
             numberText(std::round(area * 100) / 100) + " m2";
  }
  return {};
}

} // namespace pcl::sedr
