// SPDX-License-Identifier: BSD-3-Clause
#include "problems.h"
#include "simulator/scene/loop.h"
#include "simulator/truth/room_regions.h"
#include "simulator/truth/truth_mesh.h"

#include <algorithm>
#include <exception>

namespace pcl::sedr::sim {

namespace {

bool
touchesOutline(const Loop& loop, Vec2 point)
{
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (locate(elementOf(loop, i), point, kContact))
      return true;
  return false;
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

/** @brief Checks a single room. */
class RoomChecker {
public:
  RoomChecker(const Room& room, std::string place, Problems& problems)
      : room_(room)
      , place_(std::move(place))
      , problems_(problems)
  {}

  /** @brief Returns true if the room has no faults. */
  bool run()
  {
    const bool is_sound = checkOutline() &&
                          checkDetails("ceiling_details", room_.details) &&
                          checkDetails("floor_details", room_.floor_details) &&
                          checkColumns() && checkHeights() && checkMesh();
    return is_sound;
  }

private:
  template <typename... Parts>
  bool fail(const Parts&... parts)
  {
    problems_.report(place_, parts...);
    return false;
  }

  bool checkOutline()
  {
    if (room_.outline.size() < 2 || !(areaOf(room_.outline) > 0.0))
      return fail(".outline does not run counter-clockwise");
    return true;
  }

  bool checkDetails(const char* list, const std::vector<SlabDetail>& details)
  {
    for (std::size_t i = 0; i < details.size(); ++i) {
      const std::string place = placeOf(std::string(".") + list, i);
      if (!(std::abs(areaOf(details[i].loop)) > 0.0))
        return fail(place, ".loop encloses no area");
      for (const Vec2 sample : samplesAlong(details[i].loop))
        if (!contains(room_.outline, sample) && !touchesOutline(room_.outline, sample))
          return fail(place, " reaches out of the room at (", sample.x, ", ", sample.y,
                      ")");
    }
    return true;
  }

  bool checkColumns()
  {
    for (std::size_t i = 0; i < room_.columns.size(); ++i)
      for (const Vec2 sample : samplesAlong(room_.columns[i]))
        if (!contains(room_.outline, sample) || touchesOutline(room_.outline, sample))
          return fail(placeOf(".columns", i), " is not within the room");
    return true;
  }

  /** @brief Checks that the ceiling is above the floor along all loops; at the edge of
   * a tilted wall they may meet. */
  bool checkHeights()
  {
    const std::vector<Vec2> samples = placesOf(room_);
    const double clear = room_.tilts.empty() ? kContact : -kContact;
    for (const Vec2 sample : samples)
      if (isInRoom(room_, sample) &&
          !(floorBelow(room_, sample) < ceilingAbove(room_, sample) - clear))
        return fail(" has no height at (", sample.x, ", ", sample.y, ")");
    return true;
  }

  bool checkMesh()
  {
    Scene scene;
    scene.rooms.push_back(room_);
    scene.rooms.front().niches.clear();
    try {
      truthMesh(scene);
      return true;
    }
    catch (const std::exception& error) {
      return fail(" is not closed: ", error.what());
    }
  }

  const Room& room_;
  const std::string place_;
  Problems& problems_;
};

/** @brief Returns true if the height ranges of both rooms overlap at @p point. */
bool
shareHeight(const Room& a, const Room& b, Vec2 point)
{
  const double low = std::max(floorBelow(a, point), floorBelow(b, point));
  const double high =
      std::min(ceilingAbove(a, point) + a.plenum, ceilingAbove(b, point) + b.plenum);
  return low < high - kContact;
}

/** @brief Returns a point in both rooms, if the sampled loops contain one. */
std::optional<Vec2>
overlapOf(const Room& a, const Room& b)
{
  if (!meet(boundsOf(a.outline), boundsOf(b.outline)))
    return std::nullopt;
  for (const Room* room : {&a, &b})
    for (const Vec2 place : placesOf(*room))
      if (contains(a.outline, place) && contains(b.outline, place) &&
          shareHeight(a, b, place))
        return place;
  return std::nullopt;
}

} // namespace

void
checkRooms(const Scene& scene, Problems& problems)
{
  const auto& rooms = scene.rooms;
  for (std::size_t i = 0; i < rooms.size(); ++i)
    RoomChecker(rooms[i], placeOf("rooms", i), problems).run();
  if (!problems.empty())
    return;
  for (std::size_t i = 0; i < rooms.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (const auto point = overlapOf(rooms[i], rooms[k]))
        problems.report(placeOf("rooms", i), " overlaps room '", rooms[k].name,
                        "' at (", point->x, ", ", point->y, ")");
  checkVoids(scene, problems);
}

} // namespace pcl::sedr::sim
