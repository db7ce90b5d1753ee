// SPDX-License-Identifier: BSD-3-Clause
#include "tilted_walls.h"

#include "simulator/truth/room_regions.h"
#include "vaults.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace pcl::sedr::sim {

namespace {

constexpr double kNear = 1e-3; ///< metres inside the room
constexpr double kParallel = 1e-6;

/** @brief A wall of the foot loop as a plane: dot(inwards, p) - run z = offset. */
struct Face {
  LoopVertex start;
  std::size_t wall = 0; ///< of the previous outline
  double run = 0.0;     ///< tangent of the tilt
  Vec2 inwards{};
  double offset = 0.0;
};

/** @brief Returns the starts of the walls that make up an element: the facets of a
 * tilted arc. */
std::vector<Vec2>
startsAlong(const Element& element, double run)
{
  std::vector<Vec2> starts{element.start};
  if (element.bulge == 0.0 || run == 0.0)
    return starts;
  const Arc arc = arcOf(element);
  const double step = std::sqrt(8.0 * kFacetTolerance / arc.radius);
  const auto count = static_cast<int>(std::ceil(std::abs(arc.sweep) / step));
  const double radius = arc.radius + 2.0 / 3.0 * kFacetTolerance;
  for (int k = 1; k < count; ++k)
    starts.push_back(arc.center +
                     radius *
                         rotated({1.0, 0.0}, arc.start_angle + arc.sweep * k / count));
  return starts;
}

[[noreturn]] void
fail(const Room& room, std::size_t wall, const std::string& why)
{
  throw std::invalid_argument("Wall " + std::to_string(wall) + " of room '" +
                              room.name + "' cannot be tilted: " + why);
}

std::vector<Face>
facesOf(const Room& room, const std::vector<double>& runs, double floor)
{
  std::vector<Face> faces;
  for (std::size_t wall = 0; wall < room.outline.size(); ++wall) {
    const Element element = elementOf(room.outline, wall);
    const bool in_facets = runs[wall] != 0.0;
    for (const Vec2 start : startsAlong(element, runs[wall]))
      faces.push_back({{start, in_facets ? 0.0 : element.bulge}, wall, runs[wall]});
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    Face& face = faces[i];
    const Vec2 end = faces[(i + 1) % faces.size()].start.position;
    face.inwards = leftOf(normalized(end - face.start.position));
    face.offset = dot(face.inwards, face.start.position) - face.run * floor;
  }
  return faces;
}

/** @brief Returns the point where the corner between two walls meets the ceiling; at
 * height @p floor it is at @p foot. */
Vec2
headOf(const Face& before, const Face& after, Vec2 foot, double floor, const Slab& top)
{
  if (before.run == 0.0 && after.run == 0.0)
    return foot;
  // The corner runs along foot + way (z - floor).
  Vec2 way = before.run * before.inwards;
  const double turn = cross(before.inwards, after.inwards);
  if (std::abs(turn) > kParallel)
    way = (1.0 / turn) * (before.run * (-1.0 * leftOf(after.inwards)) +
                          after.run * leftOf(before.inwards));
  const double climb = 1.0 - dot(top.gradient, way);
  const double rise = (heightAt(top, foot) - floor) / climb;
  return foot + rise * way;
}

const Slab&
ceilingBeside(const Room& room, const Element& wall, double s)
{
  const Vec2 point = pointAt(wall, s) - kNear * rightNormalAt(wall, s);
  return slabOf(room, std::max(kMain, regionAt(room, point, Layer::Ceiling)),
                Layer::Ceiling);
}

SlabDetail
partOf(const Face& face, const std::vector<Vec2>& corners)
{
  SlabDetail part;
  for (const Vec2 corner : corners)
    part.loop.push_back({corner});
  const double slope = 1.0 / face.run;
  part.slab = {-slope * face.offset, slope * face.inwards, {}};
  // Place the origin at the foot, where the plane meets the floor exactly.
  const Vec2 foot = corners.front();
  part.slab.height = heightAt(part.slab, foot);
  part.slab.origin = foot;
  part.is_wall = true;
  return part;
}

} // namespace

void
tiltWalls(Room& room, const std::vector<TiltedWall>& walls)
{
  if (walls.empty())
    return;
  std::vector<double> runs(room.outline.size(), 0.0);
  for (const TiltedWall& wall : walls)
    runs[wall.wall] = std::tan(wall.tilt);
  const auto is_tilted = [&](const auto& gap) { return runs[gap.wall] != 0.0; };
  for (const TiltedWall& wall : walls)
    if (std::any_of(room.openings.begin(), room.openings.end(), is_tilted) ||
        std::any_of(room.niches.begin(), room.niches.end(), is_tilted))
      fail(room, wall.wall, "it has an opening or a niche");
    else if (dot(room.floor.gradient, room.floor.gradient) > 0.0)
      fail(room, wall.wall, "the floor is not level");
  const double floor = room.floor.height;
  const std::vector<Face> faces = facesOf(room, runs, floor);
  const std::size_t n = faces.size();
  std::vector<Vec2> heads(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Face& before = faces[(i + n - 1) % n];
    const Face& tilted = faces[i].run != 0.0 ? faces[i] : before;
    const Element wall = elementOf(room.outline, tilted.wall);
    const double s = &tilted == &before ? lengthOf(wall) - kNear : kNear;
    heads[i] = headOf(before, faces[i], faces[i].start.position, floor,
                      ceilingBeside(room, wall, s));
  }
  Loop outline;
  std::vector<std::size_t> moved(room.outline.size());
  std::vector<SlabDetail> ceiling_parts;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    const bool tilts_out = faces[i].run < 0.0;
    const Vec2 foot[2] = {faces[i].start.position, faces[next].start.position};
    const Vec2 start = tilts_out ? heads[i] : foot[0];
    const Vec2 end = tilts_out ? heads[next] : foot[1];
    const Vec2 after = faces[next].run < 0.0 ? heads[next] : foot[1];
    if (i == 0 || faces[i].wall != faces[i - 1].wall)
      moved[faces[i].wall] = outline.size();
    outline.push_back({start, faces[i].start.bulge});
    if (length(after - end) > kSameHeight)
      outline.push_back({end});
    if (faces[i].run == 0.0)
      continue;
    const SlabDetail part = partOf(faces[i], {foot[0], foot[1], heads[next], heads[i]});
    if (std::abs(heightAt(part.slab, foot[1]) - floor) > kNear)
      fail(room, faces[i].wall, "its foot is not level");
    (tilts_out ? room.floor_details : ceiling_parts).push_back(part);
  }
  for (std::size_t i = 0; i < n; ++i)
    if (faces[i].run != 0.0 &&
        dot(heads[(i + 1) % n] - heads[i],
            faces[(i + 1) % n].start.position - faces[i].start.position) <= 0.0)
      fail(room, faces[i].wall, "its head has no length");
  for (std::vector<double>::size_type i = 0; i < ceiling_parts.size(); ++i)
    room.details.push_back(ceiling_parts[i]);
  for (Opening& opening : room.openings)
    opening.wall = moved[opening.wall];
  for (Niche& niche : room.niches)
    niche.wall = moved[niche.wall];
  room.foot = room.outline;
  for (const TiltedWall& wall : walls) {
    room.tilts.resize(room.outline.size(), 0.0);
    room.tilts[wall.wall] = wall.tilt;
  }
  room.outline = outline;
}

} // namespace pcl::sedr::sim
