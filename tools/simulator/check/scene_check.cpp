// SPDX-License-Identifier: BSD-3-Clause
#include "scene_check.h"

#include "problems.h"
#include "simulator/mesh/scene_mesh.h"

#include <algorithm>
#include <exception>
#include <optional>

namespace pcl::sedr::sim {

namespace {

constexpr double kInside = 1e-3; ///< metres inside a loop, clear of its edge

/** @brief Returns sample points along the outline and all details of a room. */
std::vector<Vec2>
placesOf(const Room& room)
{
  std::vector<Vec2> places = samplesAlong(room.outline, kInside);
  for (const Layer layer : {Layer::Floor, Layer::Ceiling})
    for (const SlabDetail& detail : detailsOf(room, layer))
      for (const double side : {kInside, -kInside}) {
        const auto more = samplesAlong(detail.loop, side);
        places.insert(places.end(), more.begin(), more.end());
      }
  return places;
}

/** @brief Returns a point in both rooms, if the sampled loops contain one. */
std::optional<Vec2>
overlapOf(const Room& a, const Room& b)
{
  if (!boundsOf(a.outline).intersects(boundsOf(b.outline)))
    return std::nullopt;
  for (const Room* room : {&a, &b})
    for (const Vec2& place : placesOf(*room)) {
      if (!a.outline.contains(place) || !b.outline.contains(place))
        continue;
      const double low = std::max(floorBelow(a, place), floorBelow(b, place));
      const double high = std::min(ceilingAbove(a, place) + a.plenum,
                                   ceilingAbove(b, place) + b.plenum);
      if (low < high - kContact)
        return place;
    }
  return std::nullopt;
}

/** @brief Reports a gap whose far side is in a room, unless it leads there. */
void
checkGap(const Scene& scene,
         const Room& room,
         const WallGap& gap,
         const std::string& place,
         Problems& problems)
{
  const Element far = offsetRight(faceOf(room, gap), gap.depth);
  for (const double s : stepsAlong(far)) {
    const Vec2 point = far.pointAt(s);
    for (const Room& other : scene.rooms)
      if (other.outline.contains(point) &&
          floorBelow(other, point) < gap.head - kContact &&
          ceilingAbove(other, point) > gap.sill + kContact) {
        problems.report(place, " reaches into room '", other.name,
                        "' but does not lead to it");
        return;
      }
  }
}

/** @brief Checks that a void is within one part of a room's floor or ceiling. */
bool
checkHole(const std::string& place,
          const Loop& loop,
          const Room& room,
          Layer layer,
          Problems& problems)
{
  const Region first = regionAt(room, pointInside(loop), layer);
  for (const Vec2& sample : samplesAlong(loop, loop.area() > 0.0 ? kInside : -kInside))
    if (first == kVoid || regionAt(room, sample, layer) != first)
      return problems.report(place, " reaches out of room '", room.name,
                             "' or over the edge of a detail", at(sample));
  return true;
}

bool
checkVoid(const Scene& scene,
          const Room& room,
          const CeilingVoid& hole,
          const std::string& place,
          Problems& problems)
{
  if (!checkHole(place, hole.loop, room, Layer::Ceiling, problems))
    return false;
  if (!hole.leads_to)
    return room.plenum > 0.0 ||
           problems.report(place, " leads to no room, and its room has no plenum");
  const Room& above = scene.rooms[*hole.leads_to];
  if (!checkHole(place, hole.loop, above, Layer::Floor, problems))
    return false;
  const Vec2 inside = pointInside(hole.loop);
  return floorBelow(above, inside) >= ceilingAbove(room, inside) + room.plenum ||
         problems.report(place, " leads to room '", above.name,
                         "', which is not above it", at(inside));
}

void
checkOverlaps(const Scene& scene, Problems& problems)
{
  const auto& rooms = scene.rooms;
  for (std::size_t i = 0; i < rooms.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (const auto point = overlapOf(rooms[i], rooms[k]))
        problems.report(placeOf("rooms", i), " overlaps room '", rooms[k].name, "'",
                        at(*point));
}

void
checkGaps(const Scene& scene, Problems& problems)
{
  for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
    const Room& room = scene.rooms[i];
    const std::string place = placeOf("rooms", i);
    for (std::size_t k = 0; k < room.openings.size(); ++k)
      if (!room.openings[k].leads_to)
        checkGap(scene, room, room.openings[k], placeOf(place + ".openings", k),
                 problems);
    for (std::size_t k = 0; k < room.niches.size(); ++k)
      checkGap(scene, room, room.niches[k], placeOf(place + ".niches", k), problems);
    for (std::size_t k = 0; k < room.voids.size(); ++k)
      checkVoid(scene, room, room.voids[k], placeOf(place + ".voids", k), problems);
  }
}

} // namespace

std::vector<std::string>
problemsOf(const Scene& scene)
{
  Problems problems;
  try {
    checkOverlaps(scene, problems);
    if (problems.sentences.empty())
      meshOf(scene);
    for (const auto check : {checkGaps, checkObjects})
      if (problems.sentences.empty())
        check(scene, problems);
  }
  catch (const std::exception& error) {
    problems.report(error.what());
  }
  return problems.sentences;
}

} // namespace pcl::sedr::sim
