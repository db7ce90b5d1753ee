// SPDX-License-Identifier: BSD-3-Clause
#include "scene_check.h"

#include "simulator/mesh/scene_mesh.h"
#include "simulator/scene/queries.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace pcl::sedr::sim {

namespace {

constexpr double kContact = 1e-6; ///< metres of overlap that count as contact
constexpr double kInside = 1e-3;  ///< metres inside a loop, clear of its edge

/** @brief Throws the sentence that the parts make up. */
template <typename... Parts>
[[noreturn]] void
fail(const Parts&... parts)
{
  std::ostringstream text;
  (text << ... << parts);
  throw std::invalid_argument(text.str());
}

/** @brief Returns a point as " at (x, y)". */
std::string
at(const Vec2& point)
{
  std::ostringstream text;
  text << " at (" << point.x() << ", " << point.y() << ")";
  return text.str();
}

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

void
checkOverlaps(const std::vector<Room>& rooms)
{
  for (std::size_t i = 0; i < rooms.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (const auto point = overlapOf(rooms[i], rooms[k]))
        fail(placeOf("rooms", i), " overlaps room '", rooms[k].name, "'", at(*point));
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
      if (other.outline.contains(point) &&
          floorBelow(other, point) < gap.head - kContact &&
          ceilingAbove(other, point) > gap.sill + kContact)
        fail(place, " reaches into room '", other.name, "' but does not lead to it");
  }
}

/** @brief Checks that a void is within one part of a room's floor or ceiling. */
void
checkHole(const std::string& place, const Loop& loop, const Room& room, Layer layer)
{
  const Region first = regionAt(room, pointInside(loop), layer);
  for (const Vec2& sample : samplesAlong(loop, loop.area() > 0.0 ? kInside : -kInside))
    if (first == kVoid || regionAt(room, sample, layer) != first)
      fail(place, " reaches out of room '", room.name, "' or over the edge of a detail",
           at(sample));
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
  if (floorBelow(above, inside) < ceilingAbove(room, inside) + room.plenum)
    fail(place, " leads to room '", above.name, "', which is not above it", at(inside));
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
    for (std::size_t k = 0; k < room.niches.size(); ++k)
      checkGap(scene, room, room.niches[k], placeOf(place + ".niches", k));
    for (std::size_t k = 0; k < room.voids.size(); ++k)
      checkVoid(scene, room, room.voids[k], placeOf(place + ".voids", k));
  }
}

/** @brief A box or cylinder: an upright prism. */
struct Prism {
  Loop footprint;
  double low = 0.0;
  double high = 0.0;
};

/** @brief Returns the parts of an object. */
std::vector<Prism>
prismsOf(const Object& object)
{
  std::vector<Prism> prisms;
  for (const Box& box : object.boxes) {
    const double rise = 0.5 * box.size.z();
    prisms.push_back(
        {loopOf(cornersOf(box)), box.center.z() - rise, box.center.z() + rise});
  }
  for (const Cylinder& cylinder : object.cylinders)
    prisms.push_back({circleLoop(plan(cylinder.base), cylinder.radius),
                      cylinder.base.z(), cylinder.base.z() + cylinder.height});
  return prisms;
}

void
checkStation(const Scene& scene, const Vec3& station, const std::string& name)
{
  const Vec2 place = plan(station);
  const std::uint32_t number = roomAt(scene, station);
  if (number == 0 || !isInRoom(scene.rooms[number - 1], place))
    fail(name, at(place), " is in no room");
  const Room& room = scene.rooms[number - 1];
  if (station.z() <= floorBelow(room, place) ||
      station.z() >= ceilingAbove(room, place))
    fail(name, at(place), " is not between floor and ceiling");
  for (const Object& object : scene.furniture)
    for (const Prism& prism : prismsOf(object))
      if (station.z() >= prism.low && station.z() <= prism.high &&
          prism.footprint.contains(place))
        fail(name, at(place), " is in the ", object.name);
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
