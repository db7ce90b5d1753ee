// SPDX-License-Identifier: BSD-3-Clause
#include "queries.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace pcl::sedr::sim {

namespace {

constexpr double kMatch = 1e-3; ///< metres between matching faces of a partition
constexpr double kStoreyStep = 1.5;

/** @brief Checks that an opening or niche lies within its wall. */
void
checkGap(const Room& room, const WallGap& gap, const std::string& place)
{
  const auto& walls = room.outline.elements;
  if (gap.wall >= walls.size())
    throw std::invalid_argument(place + " lies on no wall");
  if (!(gap.from >= 0.0 && gap.from < gap.to && gap.to <= walls[gap.wall].length()))
    throw std::invalid_argument(place + " does not lie within its wall");
  if (!(gap.sill < gap.head && gap.depth > 0.0))
    throw std::invalid_argument(place + " has no height or depth");
}

double
floorOf(const Room& room)
{
  return heightAt(room.floor, pointInside(room.outline));
}

double
heightOf(const Room& room, const Vec2& point, Layer layer)
{
  return heightAt(slabOf(room, regionAt(room, point, layer), layer), point);
}

} // namespace

const std::vector<SlabDetail>&
detailsOf(const Room& room, Layer layer)
{
  return layer == Layer::Floor ? room.floor_details : room.details;
}

Region
regionAt(const Room& room, const Vec2& point, Layer layer)
{
  if (!isInRoom(room, point))
    return kVoid;
  const auto& details = detailsOf(room, layer);
  for (std::size_t i = details.size(); i > 0; --i)
    if (details[i - 1].contains(point))
      return static_cast<Region>(i);
  return kMain;
}

const Slab&
slabOf(const Room& room, Region region, Layer layer)
{
  if (region <= kMain)
    return layer == Layer::Floor ? room.floor : room.ceiling;
  return detailsOf(room, layer)[static_cast<std::size_t>(region - 1)].slab;
}

Label
labelOf(const Room& room, Region region, Layer layer)
{
  const Label whole = layer == Layer::Floor ? Label::Floor : Label::Ceiling;
  if (region == kMain)
    return whole;
  const auto& detail = detailsOf(room, layer)[static_cast<std::size_t>(region - 1)];
  return detail.is_wall ? Label::Wall : detail.is_facet ? whole : Label::Detail;
}

bool
isInRoom(const Room& room, const Vec2& point)
{
  return room.outline.contains(point) &&
         std::none_of(room.columns.begin(), room.columns.end(),
                      [&](const Loop& column) { return column.contains(point); });
}

double
floorBelow(const Room& room, const Vec2& point)
{
  return heightOf(room, point, Layer::Floor);
}

double
ceilingAbove(const Room& room, const Vec2& point)
{
  return heightOf(room, point, Layer::Ceiling);
}

std::uint32_t
roomAt(const Scene& scene, const Vec3& point)
{
  std::uint32_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  const Vec2 place = plan(point);
  for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
    const Room& room = scene.rooms[i];
    if (!room.outline.contains(place))
      continue;
    const double distance = std::max({floorBelow(room, place) - point.z(),
                                      point.z() - ceilingAbove(room, place), 0.0});
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

std::vector<Vec2>
cornersOf(const Box& box)
{
  std::vector<Vec2> corners;
  for (const Vec2& sign :
       {Vec2(-0.5, -0.5), Vec2(0.5, -0.5), Vec2(0.5, 0.5), Vec2(-0.5, 0.5)})
    corners.push_back(plan(box.center) +
                      rotated(sign.cwiseProduct(plan(box.size)), box.yaw));
  return corners;
}

Element
faceOf(const Room& room, const WallGap& gap)
{
  return room.outline.elements[gap.wall].part(gap.from, gap.to);
}

Opening
otherSideOf(const Scene& scene, std::size_t room, std::size_t index)
{
  const Opening& opening = scene.rooms[room].openings[index];
  const Element far = offsetRight(faceOf(scene.rooms[room], opening), opening.depth);
  const Room& target = scene.rooms[*opening.leads_to];
  for (std::size_t i = 0; i < target.outline.elements.size(); ++i) {
    const Element& behind = target.outline.elements[i];
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
  std::ostringstream reason;
  reason << placeOf(placeOf("rooms", room) + ".openings", index) << " leads to room '"
         << target.name << "', which has no wall there, " << opening.depth
         << " m behind this one";
  throw std::invalid_argument(reason.str());
}

std::vector<std::vector<Opening>>
openingsByRoom(const Scene& scene)
{
  std::vector<std::vector<Opening>> openings(scene.rooms.size());
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
    const Room& room = scene.rooms[i];
    const std::string place = placeOf("rooms", i);
    for (std::size_t k = 0; k < room.niches.size(); ++k)
      checkGap(room, room.niches[k], placeOf(place + ".niches", k));
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
  std::vector<std::size_t> order(rooms.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return floorOf(rooms[a]) < floorOf(rooms[b]);
  });
  std::vector<std::size_t> storeys(rooms.size(), 1);
  for (std::size_t i = 1; i < order.size(); ++i) {
    const double step = floorOf(rooms[order[i]]) - floorOf(rooms[order[i - 1]]);
    storeys[order[i]] = storeys[order[i - 1]] + (step >= kStoreyStep ? 1 : 0);
  }
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    const Room* nearest = nullptr; // in height, of those that the scene numbers
    const auto distance = [&](const Room& other) {
      return std::abs(floorOf(other) - floorOf(rooms[i]));
    };
    for (const Room& other : rooms)
      if (other.storey && (nearest == nullptr || distance(other) < distance(*nearest)))
        nearest = &other;
    if (rooms[i].storey || nearest != nullptr)
      storeys[i] = rooms[i].storey ? *rooms[i].storey : *nearest->storey;
  }
  return storeys;
}

} // namespace pcl::sedr::sim
