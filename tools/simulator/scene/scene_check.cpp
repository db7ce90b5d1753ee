// SPDX-License-Identifier: BSD-3-Clause
#include "queries.h"
#include "scenes.h"
#include "simulator/mesh/scene_mesh.h"

#include <algorithm>
#include <optional>

namespace pcl::sedr::sim {

namespace {

constexpr double kContact = 1e-6; ///< metres of overlap that count as contact
constexpr double kInside = 1e-3;  ///< metres inside a loop, clear of its edge

/** @brief Returns sample points along the outline and all details of a room. */
std::vector<Vec2>
placesOf(const Room& room)
{
  std::vector<Vec2> places = samplesAlong(room.boundary, kInside);
  for (const Layer layer : {Layer::Floor, Layer::Ceiling})
    for (const PlanDetail& detail : detailsOf(room, layer))
      for (const double side : {kInside, -kInside}) {
        const auto more = samplesAlong(detail.boundary, side);
        places.insert(places.end(), more.begin(), more.end());
      }
  return places;
}

/** @brief Returns a point in both rooms, if the sampled loops contain one. */
std::optional<Vec2>
overlapOf(const Room& a, const Room& b)
{
  if (!boundsOf(a.boundary).intersects(boundsOf(b.boundary)))
    return std::nullopt;
  for (const Room* room : {&a, &b})
    for (const Vec2& place : placesOf(*room)) {
      if (!a.boundary.contains(place) || !b.boundary.contains(place))
        continue;
      const double low = std::max(a.floorAt(place), b.floorAt(place));
      const double high =
          std::min(a.ceilingAt(place) + a.plenum, b.ceilingAt(place) + b.plenum);
      if (low < high - kContact)
        return place;
    }
  return std::nullopt;
}

void
checkOverlaps(const std::vector<Room>& rooms)
{
  for (std::size_t i = 0; i < rooms.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (const auto point = overlapOf(rooms[i], rooms[k]))
        fail(placeOf("rooms", i), " overlaps room '", rooms[k].name, "'",
             placeText(*point));
}

/** @brief Checks that the far side of a gap is in no room. */
void
checkGap(const Scene& scene,
         const Room& room,
         const WallGap& gap,
         const std::string& place)
{
  const Element far = offsetRight(faceOf(room, gap), gap.depth);
  for (const double s : stepsAlong(far)) {
    const Vec2 point = far.pointAt(s);
    for (const Room& other : scene.rooms)
      if (other.boundary.contains(point) &&
          other.floorAt(point) < gap.head - kContact &&
          other.ceilingAt(point) > gap.sill + kContact)
        fail(place, " reaches into room '", other.name, "' but does not lead to it");
  }
}

/** @brief Checks that a void is within one part of a room's floor or ceiling. */
void
checkHole(const std::string& place, const Loop& loop, const Room& room, Layer layer)
{
  const int first = detailAt(room, pointInside(loop), layer);
  for (const Vec2& sample : samplesAlong(loop, loop.area() > 0.0 ? kInside : -kInside))
    if (!room.contains(sample) || detailAt(room, sample, layer) != first)
      fail(place, " reaches out of room '", room.name, "' or over the edge of a detail",
           placeText(sample));
}

void
checkVoid(const Scene& scene,
          const Room& room,
          const CeilingVoid& hole,
          const std::string& place)
{
  checkHole(place, hole.loop, room, Layer::Ceiling);
  if (!hole.leads_to && !(room.plenum > 0.0))
    fail(place, " leads to no room, and its room has no plenum");
  if (!hole.leads_to)
    return;
  const Room& above = scene.rooms[*hole.leads_to];
  checkHole(place, hole.loop, above, Layer::Floor);
  const Vec2 inside = pointInside(hole.loop);
  if (above.floorAt(inside) < room.ceilingAt(inside) + room.plenum)
    fail(place, " leads to room '", above.name, "', which is not above it",
         placeText(inside));
}

void
checkGaps(const Scene& scene)
{
  for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
    const Room& room = scene.rooms[i];
    const std::string place = placeOf("rooms", i);
    for (std::size_t k = 0; k < room.openings.size(); ++k)
      if (!room.openings[k].leads_to)
        checkGap(scene, room, room.openings[k], placeOf(place + ".openings", k));
    for (std::size_t k = 0; k < room.wall_niches.size(); ++k)
      checkGap(scene, room, room.wall_niches[k], placeOf(place + ".niches", k));
    for (std::size_t k = 0; k < room.voids.size(); ++k)
      checkVoid(scene, room, room.voids[k], placeOf(place + ".voids", k));
  }
}

void
checkStation(const Scene& scene, const Vec3& station, const std::string& name)
{
  const Vec2 place = plan(station);
  const std::uint32_t number = roomAt(scene, station);
  if (number == 0 || !scene.rooms[number - 1].contains(place))
    fail(name, placeText(place), " is in no room");
  const Room& room = scene.rooms[number - 1];
  if (station.z() <= room.floorAt(place) || station.z() >= room.ceilingAt(place))
    fail(name, placeText(place), " is not between floor and ceiling");
  for (const Object& object : scene.furniture)
    for (const Prism& part : object.parts)
      if (station.z() >= part.low && station.z() <= part.high &&
          loopOf(part.corners).contains(place))
        fail(name, placeText(place), " is in the ", object.name);
}

} // namespace

void
checkScene(const Scene& scene)
{
  checkOverlaps(scene.rooms);
  meshOf(scene);
  checkGaps(scene);
  for (std::size_t i = 0; i < scene.scanners.size(); ++i)
    for (std::size_t k = 0; k < scene.scanners[i].stations.size(); ++k)
      checkStation(scene, scene.scanners[i].stations[k],
                   placeOf("scanners", i) + ": station " + std::to_string(k));
}

} // namespace pcl::sedr::sim
