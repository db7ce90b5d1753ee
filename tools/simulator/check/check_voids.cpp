// SPDX-License-Identifier: BSD-3-Clause
#include "problems.h"
#include "simulator/scene/loop.h"
#include "simulator/truth/room_regions.h"

#include <algorithm>

namespace pcl::sedr::sim {

namespace {

/** @brief Returns points just inside a loop, regardless of its direction. */
std::vector<Vec2>
samplesWithin(const Loop& loop)
{
  return samplesAlong(loop, areaOf(loop) > 0.0 ? kInside : -kInside);
}

/** @brief Checks a single void. */
class VoidChecker {
public:
  VoidChecker(const Scene& scene,
              const Room& room,
              std::string place,
              Problems& problems)
      : scene_(scene)
      , room_(room)
      , place_(std::move(place))
      , problems_(problems)
  {}

  void run(const CeilingVoid& hole)
  {
    if (!(std::abs(areaOf(hole.loop)) > 0.0))
      return problems_.report(place_, ".loop encloses no area");
    if (!checkLayer(hole.loop, room_, Layer::Ceiling))
      return;
    if (!hole.leads_to) {
      if (!(room_.plenum > 0.0))
        problems_.report(place_, " leads to no room, and its room has no plenum");
      return;
    }
    if (*hole.leads_to >= scene_.rooms.size())
      return problems_.report(place_, " leads to a room that does not exist");
    const Room& above = scene_.rooms[*hole.leads_to];
    if (checkLayer(hole.loop, above, Layer::Floor))
      checkHeights(hole.loop, above);
  }

private:
  /** @brief Checks that the loop is within one part of a room's floor or ceiling. */
  bool checkLayer(const Loop& loop, const Room& room, Layer layer)
  {
    const Region first = regionAt(room, pointInside(loop), layer);
    for (const Vec2 sample : samplesWithin(loop)) {
      const Region region = regionAt(room, sample, layer);
      if (region == kVoid)
        return fail(sample, " reaches out of room '", room.name, "'");
      if (region != first)
        return fail(sample, " reaches over a detail's edge of room '", room.name, "'");
    }
    for (const Loop& column : room.columns)
      if (contains(loop, column.front().position))
        return fail(column.front().position, " holds a column of room '", room.name,
                    "'");
    return true;
  }

  void checkHeights(const Loop& loop, const Room& above)
  {
    for (const Vec2 sample : samplesWithin(loop))
      if (floorBelow(above, sample) < ceilingAbove(room_, sample) + room_.plenum) {
        fail(sample, " leads to room '", above.name, "', which is not above it");
        return;
      }
  }

  template <typename... Parts>
  bool fail(Vec2 point, const Parts&... parts)
  {
    problems_.report(place_, parts..., " at (", point.x, ", ", point.y, ")");
    return false;
  }

  const Scene& scene_;
  const Room& room_;
  const std::string place_;
  Problems& problems_;
};

bool
overlap(const Loop& a, const Loop& b)
{
  for (const auto& [loop, other] : {std::make_pair(a, b), std::make_pair(b, a)})
    for (const Vec2 sample : samplesWithin(loop))
      if (contains(other, sample))
        return true;
  return false;
}

/** @brief A void and its place in the scene. */
struct PlacedVoid {
  std::string place;
  std::size_t room = 0;
  const CeilingVoid* hole = nullptr;
};

/** @brief Returns true if two holes are in the same ceiling or floor. */
bool
shareSlab(const PlacedVoid& a, const PlacedVoid& b)
{
  return a.room == b.room || (a.hole->leads_to && a.hole->leads_to == b.hole->leads_to);
}

} // namespace

void
checkVoids(const Scene& scene, Problems& problems)
{
  std::vector<PlacedVoid> holes;
  for (std::size_t i = 0; i < scene.rooms.size(); ++i)
    for (std::size_t k = 0; k < scene.rooms[i].voids.size(); ++k)
      holes.push_back(
          {placeOf(placeOf("rooms", i) + ".voids", k), i, &scene.rooms[i].voids[k]});
  for (const PlacedVoid& hole : holes)
    VoidChecker(scene, scene.rooms[hole.room], hole.place, problems).run(*hole.hole);
  for (std::size_t i = 0; i < holes.size() && problems.empty(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (shareSlab(holes[i], holes[k]) &&
          overlap(holes[i].hole->loop, holes[k].hole->loop))
        problems.report(holes[i].place, " overlaps ", holes[k].place);
}

} // namespace pcl::sedr::sim
