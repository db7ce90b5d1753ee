// SPDX-License-Identifier: BSD-3-Clause
#include "plan_edits.h"

#include "../base/number_text.h"
#include "../plan/plan_geometry.h"

#include "../walls/plan_walls.h"
#include <pcl/sedr_filters/plan_editor.h>

#define BOOST_ALLOW_DEPRECATED_HEADERS // Boost.Geometry includes one
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/polygon/polygon.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace pcl::sedr {
namespace {

namespace bp = boost::polygon;
using namespace bp::operators;
using GridPoint = bp::point_data<int>;
using GridArea = bp::polygon_set_data<int>;

constexpr double chord = 0.005; // metres
constexpr double unit = 1e-4;   // of the grid, metres

GridPoint
toGrid(const Eigen::Vector2d& p, const Eigen::Vector2d& origin)
{
  const Eigen::Vector2d at = (p - origin) / unit;
  return {static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y()))};
}

bp::polygon_data<int>
polygonOf(const PlanLoop& loop, const Eigen::Vector2d& origin)
{
  std::vector<GridPoint> corners;
  for (const Eigen::Vector2d& p : loop.polygon(chord))
    corners.push_back(toGrid(p, origin));
  bp::polygon_data<int> polygon;
  polygon.set(corners.begin(), corners.end());
  return polygon;
}

/** @brief Finds the elements that the sides of polygons are of. */
class SideElements {
public:
  SideElements(const std::vector<PlanLoop>& loops, const Eigen::Vector2d& origin)
      : origin_(origin)
  {
    for (const PlanLoop& loop : loops)
      for (const PlanElement& e : loop.elements) {
        elements_.push_back(&e);
        for (const Eigen::Vector2d& p : {e.start, e.end}) {
          const GridPoint at = toGrid(p, origin);
          exact_.emplace(std::make_pair(at.x(), at.y()), p);
        }
      }
  }

  /** @brief Returns the loop of a polygon. */
  PlanLoop loopOf(const std::vector<GridPoint>& corners) const
  {
    const std::size_t n = corners.size();
    std::vector<const PlanElement*> of;
    for (std::size_t k = 0; k < n; ++k)
      of.push_back(elementAt(placeOf(corners[k]), placeOf(corners[(k + 1) % n])));
    const auto begin = std::adjacent_find(of.begin(), of.end(), std::not_equal_to<>());
    PlanLoop loop;
    if (begin == of.end() && of.front()) {
      loop.elements = {*of.front()}; // a whole circle
      return loop;
    }
    const auto first = static_cast<std::size_t>(begin - of.begin()) + 1;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t k = (first + i) % n;
      const Eigen::Vector2d end = placeOf(corners[(k + 1) % n]);
      if (i > 0 && of[k] && of[k] == of[(k + n - 1) % n]) {
        loop.elements.back().end = end; // of an arc
        continue;
      }
      loop.elements.push_back(of[k] ? *of[k] : PlanElement());
      loop.elements.back().start = placeOf(corners[k]);
      loop.elements.back().end = end;
    }
    simplify(loop);
    return loop;
  }

private:
  Eigen::Vector2d placeOf(const GridPoint& p) const
  {
    const auto exact = exact_.find({p.x(), p.y()});
    return exact != exact_.end()
               ? exact->second
               : Eigen::Vector2d(origin_ + unit * Eigen::Vector2d(p.x(), p.y()));
  }

  /** @brief Returns the element that a side runs along, null if there is none. */
  const PlanElement* elementAt(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const
  {
    const PlanElement* nearest = nullptr;
    double least = chord;
    for (const PlanElement* e : elements_) {
      const double off = std::max(e->distance(a), e->distance(b));
      if (off < least && (e->isArc() || off < 2 * unit)) {
        nearest = e;
        least = off;
      }
    }
    return nearest;
  }

  Eigen::Vector2d origin_;
  std::vector<const PlanElement*> elements_;
  std::map<std::pair<int, int>, Eigen::Vector2d> exact_; ///< ends of elements
};

/** @brief Returns a loop whose elements end where places touch it. */
PlanLoop
cutAt(const PlanLoop& loop, const std::vector<Eigen::Vector2d>& places)
{
  PlanLoop cut;
  for (const PlanElement& e : loop.elements) {
    std::vector<double> ends{0, e.length()};
    for (const Eigen::Vector2d& p : places)
      if (const double s = e.project(p);
          e.distance(p) < touching && s > touching && s < e.length() - touching)
        ends.push_back(s);
    std::sort(ends.begin(), ends.end());
    for (std::size_t k = 0; k + 1 < ends.size(); ++k)
      if (ends[k + 1] - ends[k] > touching)
        cut.elements.push_back(ends.size() > 2 ? e.part(ends[k], ends[k + 1]) : e);
  }
  return cut;
}

} // namespace

void
setByHand(const Floorplan& plan, PlanElement& wall)
{
  const auto isKnown = [](const PlanElement& e) { return e.evidence.isKnown(); };
  const bool is_measured =
      std::any_of(plan.rooms.begin(), plan.rooms.end(), [&](const PlanRoom& room) {
        const std::vector<PlanElement>& walls = room.boundary.elements;
        return std::any_of(walls.begin(), walls.end(), isKnown);
      });
  wall.inliers = 0;
  wall.residual = 0;
  wall.accuracy = {};
  wall.evidence = {0, is_measured ? 1.0 : 0.0, 0};
  wall.is_confirmed = false;
}

void
setByHand(PlanSlab& slab)
{
  slab.accuracy = {};
  slab.inferred = 1;
}

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
  if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1)) // they may be NaN
    return std::nullopt;
  return a.start + s * u;
}

std::string
outlineProblem(const PlanLoop& loop)
{
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
simplify(PlanLoop& loop, const std::vector<Eigen::Vector2d>& loose)
{
  constexpr double in_line = 0.01; // metres
  const auto toleranceAt = [&](const Eigen::Vector2d& corner) {
    return std::any_of(
               loose.begin(), loose.end(),
               [&](const Eigen::Vector2d& p) { return (p - corner).norm() < touching; })
               ? in_line
               : touching;
  };
  auto& e = loop.elements;
  e.erase(
      std::remove_if(e.begin(), e.end(),
                     [](const PlanElement& part) { return part.length() < touching; }),
      e.end());
  for (std::size_t k = 0; e.size() > 3 && k < e.size();) {
    PlanElement& next = e[(k + 1) % e.size()];
    const Eigen::Vector2d way = (next.end - e[k].start).normalized();
    const bool is_one_circle = e[k].isArc() && next.isArc() &&
                               e[k].radius == next.radius && e[k].centre == next.centre;
    const bool is_one_line =
        !e[k].isArc() && !next.isArc() &&
        std::abs(cross(way, next.start - e[k].start)) <= toleranceAt(next.start) &&
        (e[k].end - e[k].start).dot(next.end - next.start) >= 0;
    if (e[k].tilt != next.tilt || !(is_one_circle || is_one_line)) {
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
    next.accuracy = worse(next.accuracy, e[k].accuracy);
    next.is_confirmed = next.is_confirmed && e[k].is_confirmed;
    next.start = e[k].start;
    e.erase(e.begin() + static_cast<std::ptrdiff_t>(k));
  }
}

std::string
meetAgain(const std::vector<PlanElement>& lines, PlanLoop& loop)
{
  std::vector<PlanElement> left = lines;
  std::vector<bool> is_moved;
  for (std::size_t k = 0; k < lines.size(); ++k)
    is_moved.push_back(lines[k].start != loop.elements[k].start ||
                       lines[k].end != loop.elements[k].end);
  while (left.size() > 2) {
    PlanLoop met{left};
    rejoin(met, is_moved);
    auto backward = left.end();
    for (std::size_t k = 0; k < left.size(); ++k) {
      const PlanElement& wall = met.elements[k];
      Eigen::Vector2d way;
      if (std::abs(offLine(left[k], wall.start, way)) > touching ||
          std::abs(offLine(left[k], wall.end, way)) > touching)
        return left.size() == lines.size()
                   ? "it would no longer meet the wall beside it"
                   : "walls beside it would vanish, and those behind them do not meet";
      if (!wall.isArc() && backward == left.end() &&
          (wall.end - wall.start).dot(left[k].end - left[k].start) <= 0)
        backward = left.begin() + static_cast<std::ptrdiff_t>(k);
    }
    simplify(met);
    if (outlineProblem(met).empty()) {
      loop = std::move(met);
      return {};
    }
    if (backward == left.end())
      return "the outline then " + outlineProblem(met);
    const auto k = static_cast<std::size_t>(backward - left.begin());
    left.erase(backward);
    is_moved.erase(is_moved.begin() + static_cast<std::ptrdiff_t>(k));
    is_moved[k % left.size()] = true;
  }
  return "nothing of the room would be left";
}

double
commonArea(const PlanRoom& a, const PlanRoom& b)
{
  const Eigen::AlignedBox2d box = boundsOf(a.boundary);
  if (!box.intersects(boundsOf(b.boundary)))
    return 0;
  const auto areaOf = [&](const PlanRoom& room) {
    GridArea area;
    area.insert(polygonOf(room.boundary, box.min()));
    for (const PlanLoop& column : room.columns)
      area.insert(polygonOf(column, box.min()), true);
    return area;
  };
  GridArea common = areaOf(a);
  common &= areaOf(b);
  return static_cast<double>(bp::area(common)) * unit * unit;
}

std::vector<PlanLoop>
unionOf(std::vector<PlanLoop> areas)
{
  std::vector<Eigen::Vector2d> ends;
  for (const PlanLoop& loop : areas)
    for (const PlanElement& e : loop.elements)
      ends.push_back(e.start);
  for (PlanLoop& loop : areas)
    loop = cutAt(loop, ends);
  const Eigen::Vector2d origin = boundsOf(areas.front()).min();
  GridArea area;
  for (const bool is_hole : {false, true})
    for (const PlanLoop& loop : areas)
      if ((loop.area() < 0) == is_hole)
        area.insert(polygonOf(loop, origin), is_hole);
  std::vector<bp::polygon_with_holes_data<int>> polygons;
  area.get(polygons);
  const SideElements sides(areas, origin);
  std::vector<PlanLoop> loops;
  const auto add = [&](const auto& polygon, bool is_hole) {
    std::vector<GridPoint> corners(polygon.begin(), polygon.end());
    if (corners.size() > 1 && corners.front() == corners.back())
      corners.pop_back();
    if ((bp::winding(polygon) == bp::CLOCKWISE) != is_hole)
      std::reverse(corners.begin(), corners.end());
    loops.push_back(sides.loopOf(corners));
  };
  for (const auto& polygon : polygons) {
    add(polygon, false);
    for (auto hole = polygon.begin_holes(); hole != polygon.end_holes(); ++hole)
      add(*hole, true);
  }
  return loops;
}

} // namespace pcl::sedr
