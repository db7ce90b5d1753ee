// SPDX-License-Identifier: BSD-3-Clause
#include "simulator/scan/scene_surfaces.h"
#include "simulator/truth/room_regions.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace pcl::sedr::sim {

namespace {

constexpr double kMatch = 1e-3; ///< metres between matching faces of a partition

[[noreturn]] void
reject(std::size_t room, std::size_t opening, const std::string& reason)
{
  throw std::invalid_argument("rooms[" + std::to_string(room) + "].openings[" +
                              std::to_string(opening) + "] " + reason);
}

void
checkOpening(const Scene& scene, std::size_t room, std::size_t index)
{
  const Opening& opening = scene.rooms[room].openings[index];
  const Loop& outline = scene.rooms[room].outline;
  if (opening.wall >= outline.size())
    reject(room, index, "lies on no wall");
  const double length = lengthOf(elementOf(outline, opening.wall));
  if (!(opening.from >= 0.0 && opening.from < opening.to && opening.to <= length))
    reject(room, index, "does not lie within its wall");
  if (!(opening.sill < opening.head && opening.depth > 0.0))
    reject(room, index, "has no height or depth");
}

} // namespace

Opening
otherSideOf(const Scene& scene, std::size_t room, std::size_t index)
{
  const Opening& opening = scene.rooms[room].openings[index];
  if (*opening.leads_to >= scene.rooms.size())
    reject(room, index, "leads to a room that does not exist");
  const Element wall = elementOf(scene.rooms[room].outline, opening.wall);
  const Element far =
      offsetRight(pieceOf(wall, opening.from, opening.to), opening.depth);
  const Room& target = scene.rooms[*opening.leads_to];
  for (std::size_t i = 0; i < target.outline.size(); ++i) {
    const Element behind = elementOf(target.outline, i);
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
  reason << "leads to room '" << target.name << "', which has no wall there, "
         << opening.depth << " m behind this one";
  reject(room, index, reason.str());
}

std::vector<std::vector<Opening>>
openingsByRoom(const Scene& scene)
{
  std::vector<std::vector<Opening>> openings(scene.rooms.size());
  for (std::size_t i = 0; i < scene.rooms.size(); ++i)
    for (std::size_t k = 0; k < scene.rooms[i].openings.size(); ++k) {
      const Opening& opening = scene.rooms[i].openings[k];
      checkOpening(scene, i, k);
      openings[i].push_back(opening);
      if (opening.leads_to) {
        const Opening other = otherSideOf(scene, i, k);
        openings[*opening.leads_to].push_back(other);
      }
    }
  return openings;
}

Loop
recessFootprint(const Element& near, double depth)
{
  const Element far = offsetRight(near, depth);
  return {{near.start, near.bulge}, {near.end}, {far.end, -far.bulge}, {far.start}};
}

std::uint32_t
roomAt(const Scene& scene, Vec3 point)
{
  std::uint32_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < scene.rooms.size(); ++i) {
    const Room& room = scene.rooms[i];
    if (!contains(room.outline, plan(point)))
      continue;
    const double distance = std::max({floorBelow(room, plan(point)) - point.z,
                                      point.z - ceilingAbove(room, plan(point)), 0.0});
    if (distance < least) {
      least = distance;
      nearest = static_cast<std::uint32_t>(i + 1);
    }
  }
  return nearest;
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

} // namespace pcl::sedr::sim
