// SPDX-License-Identifier: BSD-3-Clause
#include "wall_body.h"

#include "sedr_filters/src/plan/plan_bounds.h"
#include "sedr_segmentation/src/curves/plan_segment.h"

#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::sedr::ifc {
namespace {

PlanElement
arcPart(const PlanElement& arc, const Stretch& stretch)
{
  return stretch.from <= 0 && stretch.to >= arc.length()
             ? arc
             : arc.part(std::max(stretch.from, 0.0),
                        std::min(stretch.to, arc.length()));
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

double
farRadius(const PlanElement& arc, double thickness)
{
  constexpr double least = 0.01;
  return arc.counter_clockwise ? arc.radius + thickness
                               : std::max(arc.radius - thickness, least);
}

/** @brief What is between the face of a wall and its far side, in the wall's frame. */
PlanArea
bandOf(const Floorplan& plan, const PlanWall& wall)
{
  const PlanElement& element = elementOf(plan, wall.face);
  if (!element.isArc()) {
    const auto& o = wall.outline; // clockwise
    return {loopOf({o[0], o[3], o[2], o[1]}), {}};
  }
  const WallFrame frame = frameOf(plan, wall);
  const PlanElement near = arcPart(element, wall.stretch);
  const PlanElement far = withRadius(near, farRadius(near, wall.thickness));
  PlanLoop close{{near}};
  PlanLoop behind{{far}};
  if (std::abs(near.sweep()) > 2 * M_PI - 1e-6) {
    if (close.area() < 0) {
      close = reversed(close);
      behind = reversed(behind);
    }
    const bool is_outside = far.radius > near.radius;
    return {inFrame(is_outside ? behind : close, frame),
            {inFrame(is_outside ? close : behind, frame)}};
  }
  PlanLoop loop;
  loop.elements.push_back(near);
  loop.elements.push_back(segment(near.end, far.end));
  loop.elements.push_back(reversed(behind).elements.front());
  loop.elements.push_back(segment(far.start, near.start));
  return {inFrame(loop.area() < 0 ? reversed(loop) : loop, frame), {}};
}

/** @brief Returns what a room takes of the plan, in a frame. */
PlanArea
areaOf(const PlanRoom& room, const WallFrame& frame)
{
  PlanArea area{inFrame(room.boundary, frame)};
  for (const PlanLoop& column : room.columns)
    area.holes.push_back(inFrame(column, frame));
  return area;
}

/** @brief The last place on the way from a face to the far side of its wall before
 * another room. */
Eigen::Vector2d
beforeRooms(const std::vector<const PlanRoom*>& rooms,
            const Eigen::Vector2d& near,
            const Eigen::Vector2d& far)
{
  constexpr double step = 0.01;
  const double length = (far - near).norm();
  for (double s = step; s < length; s += step) {
    const Eigen::Vector2d p = near + s / length * (far - near);
    if (std::any_of(rooms.begin(), rooms.end(),
                    [&](const PlanRoom* room) { return room->contains(p); }))
      return near + (s - step / 2) / length * (far - near);
  }
  return far;
}

/** @brief Returns the tops of a wall, those between two of them every 2 cm. */
std::vector<WallHeights::Top>
refined(const std::vector<WallHeights::Top>& tops, double length)
{
  constexpr double step = 0.02;
  std::vector<WallHeights::Top> fine;
  for (std::size_t i = 0; i + 1 < tops.size(); ++i) {
    const double stretch = (tops[i + 1].along - tops[i].along) * length;
    const auto n = static_cast<std::size_t>(std::max(std::ceil(stretch / step), 1.0));
    for (std::size_t k = 0; k < n; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(n);
      fine.push_back({tops[i].along + share * (tops[i + 1].along - tops[i].along),
                      tops[i].height + share * (tops[i + 1].height - tops[i].height)});
    }
  }
  fine.push_back(tops.back());
  return fine;
}

} // namespace

std::vector<const PlanRoom*>
roomsIn(const Floorplan& plan, const PlanWall& wall)
{
  const PlanArea band = bandOf(plan, wall);
  const Eigen::AlignedBox2d box = boundsOf(band.boundary);
  const PlanRoom& own = plan.rooms[wall.face.room];
  std::vector<const PlanRoom*> rooms;
  for (const PlanRoom& room : plan.rooms) {
    if (!shareHeights(room, own))
      continue;
    const PlanArea area = areaOf(room, frameOf(plan, wall));
    if (boundsOf(area.boundary).intersects(box) && commonArea(band, area) > no_area)
      rooms.push_back(&room);
  }
  return rooms;
}

PlanArea
profileOf(const Floorplan& plan,
          const PlanWall& wall,
          const std::vector<const PlanRoom*>& rooms)
{
  std::vector<PlanArea> areas;
  for (const PlanRoom* room : rooms)
    areas.push_back(areaOf(*room, frameOf(plan, wall)));
  const PlanArea band = bandOf(plan, wall);
  return areas.empty() ? band : largestPartOutside(band, areas);
}

WallRuns
runsOf(const Floorplan& plan, const PlanWall& wall, const WallTilts& tilts)
{
  const auto runOfFace = [&](const WallFace& face) {
    return face.loop > 0 ? 0 : wallRuns(plan.rooms[face.room], tilts)[face.element];
  };
  if (tilts.empty() || elementOf(plan, wall.face).isArc())
    return {};
  const double near = runOfFace(wall.face);
  return {near, wall.other ? -runOfFace(*wall.other) : near};
}

TriangleMesh
meshOf(const Floorplan& plan,
       const PlanWall& wall,
       const WallHeights& heights,
       const WallRuns& runs,
       const std::vector<const PlanRoom*>& rooms)
{
  const std::vector<WallHeights::Top> tops =
      rooms.empty() ? heights.tops : refined(heights.tops, wall.stretch.length());
  const PlanElement& element = elementOf(plan, wall.face);
  const WallFrame frame = frameOf(plan, wall);
  TriangleMesh mesh;
  constexpr double min_height = 0.001;
  for (const WallHeights::Top& top : tops) {
    Eigen::Vector2d near(top.along * wall.outline[1].x(), 0);
    Eigen::Vector2d far =
        (1 - top.along) * wall.outline[3] + top.along * wall.outline[2];
    if (element.isArc()) {
      const Eigen::Vector2d place =
          faceAt(element, wall.stretch.from + top.along * wall.stretch.length()).first;
      near = frame.toLocal(place);
      far = frame.toLocal(element.centre +
                          (place - element.centre) *
                              (farRadius(element, wall.thickness) / element.radius));
    }
    far = frame.toLocal(beforeRooms(rooms, frame.toPlan(near), frame.toPlan(far)));
    const double z = std::max(top.height - heights.bottom, min_height);
    for (const auto& [p, run] : {std::pair(near, runs.near), std::pair(far, runs.far)})
      for (const double height : {0.0, z})
        mesh.vertices.emplace_back(p.x(), p.y() + run * height, height);
  }
  // A section has four corners: near bottom and top, far bottom and top.
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c,
                        std::uint32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  const auto n = static_cast<std::uint32_t>(tops.size());
  for (std::uint32_t k = 0; k + 1 < n; ++k) {
    const std::uint32_t i = 4 * k;
    quad(i, i + 1, i + 5, i + 4);     // the face
    quad(i + 2, i + 6, i + 7, i + 3); // the far side
    quad(i + 1, i + 3, i + 7, i + 5); // the top
    quad(i, i + 4, i + 6, i + 2);     // the bottom
  }
  quad(0, 2, 3, 1);
  const std::uint32_t last = 4 * (n - 1);
  quad(last, last + 1, last + 3, last + 2);
  if (mesh.signedVolume() < 0)
    mesh.flip();
  return mesh;
}

} // namespace pcl::sedr::ifc
