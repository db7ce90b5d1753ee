// SPDX-License-Identifier: BSD-3-Clause
#include "wall_band.h"

#include "../triangulation/triangulation.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include "sedr_segmentation/src/curves/contour.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <boost/polygon/polygon.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl::sedr {
namespace {

namespace bp = boost::polygon;
using namespace boost::polygon::operators;

using GridPolygons = std::vector<bp::polygon_with_holes_data<int>>;

constexpr double chord = 5e-5;    ///< metres between an arc and its chords
constexpr double off_line = 1e-4; ///< metres

/** @brief Returns a grid that all areas are on. */
PlanGrid
gridAround(const std::vector<PlanArea>& areas, const std::vector<PlanArea>& others)
{
  Eigen::AlignedBox2d box;
  for (const auto* some : {&areas, &others})
    for (const PlanArea& area : *some)
      box.extend(boundsOf(area.boundary));
  return box.isEmpty() ? PlanGrid() : PlanGrid(box);
}

bp::polygon_data<int>
polygonOf(const PlanLoop& loop, const PlanGrid& grid)
{
  std::vector<bp::point_data<int>> corners;
  for (const Eigen::Vector2d& corner : loop.polygon(chord)) {
    const GridPoint p = grid.toGrid(corner);
    corners.emplace_back(p.x, p.y);
  }
  bp::polygon_data<int> polygon;
  polygon.set(corners.begin(), corners.end());
  return polygon;
}

/** @brief Returns what is in any of some areas. */
bp::polygon_set_data<int>
setOf(const std::vector<PlanArea>& areas, const PlanGrid& grid)
{
  bp::polygon_set_data<int> set;
  for (const PlanArea& area : areas) {
    set.insert(polygonOf(area.boundary, grid));
    for (const PlanLoop& hole : area.holes)
      set.insert(polygonOf(hole, grid), true);
  }
  return set;
}

/** @brief A loop of grid points without the corners that are on a line. */
template <typename Points>
PlanLoop
outlineOf(const Points& points, const PlanGrid& grid, bool is_hole)
{
  std::vector<Eigen::Vector2d> corners;
  for (const auto& p : points)
    corners.push_back(grid.toPlan({p.x(), p.y()}));
  const PlanLoop loop = loopOf(simplified(corners, off_line));
  return (loop.area() < 0) == is_hole ? loop : reversed(loop);
}

} // namespace

double
commonArea(const PlanArea& a, const PlanArea& b)
{
  const PlanGrid grid = gridAround({a}, {b});
  bp::polygon_set_data<int> set = setOf({a}, grid);
  set &= setOf({b}, grid);
  return bp::area(set) * grid.unit() * grid.unit();
}

std::vector<PlanArea>
partsOutside(const std::vector<PlanArea>& areas, const std::vector<PlanArea>& others)
{
  const PlanGrid grid = gridAround(areas, others);
  bp::polygon_set_data<int> set = setOf(areas, grid);
  set -= setOf(others, grid);
  GridPolygons found;
  set.get(found);
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return bp::area(a) > bp::area(b);
  });
  std::vector<PlanArea> parts;
  for (const auto& polygon : found) {
    PlanArea& part = parts.emplace_back(PlanArea{outlineOf(polygon, grid, false)});
    for (auto hole = polygon.begin_holes(); hole != polygon.end_holes(); ++hole)
      part.holes.push_back(outlineOf(*hole, grid, true));
  }
  return parts;
}

PlanArea
largestPartOutside(const PlanArea& area, const std::vector<PlanArea>& others)
{
  const std::vector<PlanArea> parts = partsOutside({area}, others);
  return parts.empty() ? PlanArea() : parts.front();
}

TriangleMesh
triangulated(const PlanArea& area,
             const std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>& lines)
{
  std::vector<PlanArea> extent;
  for (const auto& [from, to] : lines)
    extent.push_back({{{segment(from, to)}}});
  const PlanGrid grid = gridAround({area}, extent);
  std::vector<GridSegment> segments;
  const auto addLoop = [&](const PlanLoop& loop) {
    const std::vector<Eigen::Vector2d> corners = loop.polygon(chord);
    for (std::size_t k = 0; k < corners.size(); ++k)
      segments.push_back(
          {grid.toGrid(corners[k]), grid.toGrid(corners[(k + 1) % corners.size()])});
  };
  addLoop(area.boundary);
  std::for_each(area.holes.begin(), area.holes.end(), addLoop);
  const std::size_t outline = segments.size();
  for (const auto& [from, to] : lines)
    segments.push_back({grid.toGrid(from), grid.toGrid(to)});

  constexpr double separation = 1e-5; // metres
  Arrangement arrangement;
  arrangeSegments(segments, separation / grid.unit(), arrangement);
  PlanEdges rim;
  PlanEdges folds;
  for (const Arrangement::Edge& edge : arrangement.edges) {
    const auto uses =
        std::count_if(edge.uses.begin(), edge.uses.end(),
                      [&](const SegmentUse& use) { return use.segment < outline; });
    (uses % 2 == 1 ? rim : folds).emplace_back(edge.a, edge.b);
  }
  TriangleMesh mesh;
  const auto triangles = trianglesWithin(arrangement.vertices, rim, folds);
  if (!triangles)
    return mesh;
  for (const GridPoint& p : arrangement.vertices) {
    const Eigen::Vector2d place = grid.toPlan(p);
    mesh.vertices.emplace_back(place.x(), place.y(), 0);
  }
  mesh.triangles = *triangles;
  return mesh;
}

namespace {

/** @brief Returns the part of a curved wall's face that belongs to the wall. */
PlanElement
nearSideOf(const PlanElement& element, const Stretch& stretch)
{
  const bool is_whole = stretch.from <= 0 && stretch.to >= element.length();
  return is_whole ? element
                  : element.part(std::max(stretch.from, 0.0),
                                 std::min(stretch.to, element.length()));
}

/** @brief Returns the arc with the same centre and another radius. */
PlanElement
withRadius(PlanElement arc, double radius)
{
  for (Eigen::Vector2d* p : {&arc.start, &arc.end})
    *p = arc.centre + (*p - arc.centre) * (radius / arc.radius);
  arc.radius = radius;
  return arc;
}

PlanLoop
counterClockwise(const PlanLoop& loop)
{
  return loop.area() < 0 ? reversed(loop) : loop;
}

} // namespace

PlanElement
farSideOf(const Floorplan& plan, const PlanWall& wall)
{
  const PlanElement& element = elementOf(plan, wall.face);
  if (!element.isArc()) {
    const WallFrame frame = frameOf(plan, wall);
    return segment(frame.toPlan(wall.outline[3]), frame.toPlan(wall.outline[2]));
  }
  constexpr double min_radius = 0.01;
  return withRadius(nearSideOf(element, wall.stretch),
                    element.counter_clockwise
                        ? element.radius + wall.thickness
                        : std::max(element.radius - wall.thickness, min_radius));
}

PlanArea
bandOf(const Floorplan& plan, const PlanWall& wall)
{
  const PlanElement& element = elementOf(plan, wall.face);
  const PlanElement far = farSideOf(plan, wall);
  if (!element.isArc()) {
    const WallFrame frame = frameOf(plan, wall);
    return {loopOf({frame.toPlan(wall.outline[0]), far.start, far.end,
                    frame.toPlan(wall.outline[1])})};
  }
  const PlanElement near = nearSideOf(element, wall.stretch);
  if (std::abs(near.sweep()) > 2 * M_PI - 1e-6) {
    const bool is_outside = far.radius > near.radius;
    return {counterClockwise({{is_outside ? far : near}}),
            {counterClockwise({{is_outside ? near : far}})}};
  }
  return {counterClockwise(
      {{near, segment(near.end, far.end), reversed({{far}}).elements.front(),
        segment(far.start, near.start)}})};
}

bool
isExternal(const Floorplan& plan, const PlanWall& wall)
{
  constexpr double reach = 3; // metres
  constexpr double step = 0.1;
  constexpr int places = 3;
  if (wall.other)
    return false;
  const PlanRoom& own = plan.rooms[wall.face.room];
  const auto isOfWall = [&](const OpeningWall& w) {
    return wall.face.loop == 0 && w.room == own.id && w.element == wall.face.element;
  };
  if (std::any_of(plan.openings.begin(), plan.openings.end(),
                  [&](const PlanOpening& o) {
                    return o.kind == OpeningKind::Window && o.leadsOutside() &&
                           std::any_of(o.walls.begin(), o.walls.end(), isOfWall);
                  }))
    return true;
  int free = 0;
  for (int k = 0; k < places; ++k) {
    const auto [place, inward] =
        faceAt(elementOf(plan, wall.face),
               wall.stretch.from + wall.stretch.length() * (k + 0.5) / places);
    Eigen::AlignedBox2d way(place);
    way.extend(place - reach * inward);
    free += std::none_of(plan.rooms.begin(), plan.rooms.end(),
                         [&, at = place, in = inward](const PlanRoom& room) {
                           if (!way.intersects(boundsOf(room.boundary)) ||
                               !shareHeights(room, own))
                             return false;
                           for (double off = wall.thickness; off < reach; off += step)
                             if (room.contains(at - off * in))
                               return true;
                           return false;
                         })
                ? 1
                : 0;
  }
  return free > places / 2;
}

} // namespace pcl::sedr
