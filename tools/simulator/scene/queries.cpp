// SPDX-License-Identifier: BSD-3-Clause
#include "queries.h"

#include <algorithm>
#include <limits>

namespace pcl::sedr::sim {

namespace {

constexpr double kMatch = 1e-3; ///< metres between matching faces of a partition
constexpr double kStoreyStep = 1.5;

/** @brief Checks that an opening or niche lies within its wall. */
void
checkGap(const Room& room, const WallGap& gap, const std::string& place)
{
  const auto& walls = room.boundary.elements;
  if (gap.wall >= walls.size())
    fail(place, " lies on no wall");
  if (!(gap.from >= 0.0 && gap.from < gap.to && gap.to <= walls[gap.wall].length()))
    fail(place, " does not lie within its wall");
  if (!(gap.sill < gap.head && gap.depth > 0.0))
    fail(place, " has no height or depth");
}

double
floorOf(const Room& room)
{
  return room.floor.heightAt(pointInside(room.boundary));
}

} // namespace

Label
labelOf(const Room& room, int detail, Layer layer)
{
  const bool is_floor = layer == Layer::Floor;
  const Label whole = is_floor ? Label::Floor : Label::Ceiling;
  if (detail < 0)
    return whole;
  const auto& details = detailsOf(room, layer);
  const auto index = static_cast<std::size_t>(detail);
  const std::size_t walls = is_floor ? room.floor_walls : room.ceiling_walls;
  return index + walls >= details.size() ? Label::Wall
         : details[index].is_facet       ? whole
                                         : Label::Detail;
}

std::uint32_t
roomAt(const Scene& scene, const Vec3& point)
{
  std::uint32_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  const Vec2 place = plan(point);
  for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
    const Room& room = scene.rooms[i];
    if (!room.boundary.contains(place))
      continue;
    const double distance = std::max(
        {room.floorAt(place) - point.z(), point.z() - room.ceilingAt(place), 0.0});
    if (distance < least) {
      least = distance;
      nearest = static_cast<std::uint32_t>(i + 1);
    }
  }
  return nearest;
}

std::string
placeOf(const std::string& list, std::size_t index)
{
  return list + '[' + std::to_string(index) + ']';
}

Element
faceOf(const Room& room, const WallGap& gap)
{
  return room.boundary.elements[gap.wall].part(gap.from, gap.to);
}

Opening
otherSideOf(const Scene& scene, std::size_t room, std::size_t index)
{
  const Opening& opening = scene.rooms[room].openings[index];
  const Element far = offsetRight(faceOf(scene.rooms[room], opening), opening.depth);
  const Room& target = scene.rooms[*opening.leads_to];
  for (std::size_t i = 0; i < target.boundary.elements.size(); ++i) {
    const Element& behind = target.boundary.elements[i];
    const auto from = locate(behind, far.end, kMatch);
    const auto to = locate(behind, far.start, kMatch);
    if (!from || !to || !(*from < *to))
      continue;
    Opening other = opening;
    other.wall = i;
    other.from = *from;
    other.to = *to;
    other.leads_to = room;
    return other;
  }
  fail(placeOf(placeOf("rooms", room) + ".openings", index), " leads to room '",
       target.name, "', which has no wall there, ", opening.depth,
       " m behind this one");
}

std::vector<std::vector<Opening>>
openingsByRoom(const Scene& scene)
{
  std::vector<std::vector<Opening>> openings(scene.rooms.size());
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
    const Room& room = scene.rooms[i];
    const std::string place = placeOf("rooms", i);
    for (std::size_t k = 0; k < room.wall_niches.size(); ++k)
      checkGap(room, room.wall_niches[k], placeOf(place + ".niches", k));
    for (std::size_t k = 0; k < room.openings.size(); ++k) {
      checkGap(room, room.openings[k], placeOf(place + ".openings", k));
      openings[i].push_back(room.openings[k]);
      openings[i].back().number = ++number;
    }
  }
  for (std::size_t i = 0; i < scene.rooms.size(); ++i)
    for (std::size_t k = 0; k < scene.rooms[i].openings.size(); ++k)
      if (scene.rooms[i].openings[k].leads_to) {
        Opening other = otherSideOf(scene, i, k);
        other.number = openings[i][k].number;
        openings[*scene.rooms[i].openings[k].leads_to].push_back(other);
      }
  return openings;
}

std::vector<std::vector<Loop>>
floorVoidsOf(const Scene& scene)
{
  std::vector<std::vector<Loop>> voids(scene.rooms.size());
  for (const Room& room : scene.rooms)
    for (const CeilingVoid& hole : room.voids)
      if (hole.leads_to && *hole.leads_to < scene.rooms.size())
        voids[*hole.leads_to].push_back(hole.loop);
  return voids;
}

std::vector<std::size_t>
storeysOf(const Scene& scene)
{
  const auto& rooms = scene.rooms;
  std::vector<double> floors;
  for (const Room& room : rooms)
    floors.push_back(floorOf(room));
  std::vector<double> ascending = floors;
  std::sort(ascending.begin(), ascending.end());
  std::vector<std::size_t> storeys(rooms.size(), 1);
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    for (std::size_t k = 1; k < floors.size() && ascending[k] <= floors[i]; ++k)
      storeys[i] += ascending[k] - ascending[k - 1] >= kStoreyStep ? 1 : 0;
    double nearest = std::numeric_limits<double>::infinity(); // of numbered rooms
    for (std::size_t k = 0; k < rooms.size(); ++k)
      if (const double apart = std::abs(floors[k] - floors[i]);
          rooms[k].storey && apart < nearest) {
        nearest = apart;
        storeys[i] = *rooms[k].storey;
      }
    storeys[i] = rooms[i].storey.value_or(storeys[i]);
  }
  return storeys;
}

} // namespace pcl::sedr::sim
