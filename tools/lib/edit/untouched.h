// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sedr_filters/src/editing/plan_edits.h"
#include "sedr_surface/src/sheet/text_places.h"

#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::sedr::tools {

/** @brief A wall by the numbers of its room and its own, from 1. */
struct WallNumber {
  std::uint32_t room = 0;
  std::size_t wall = 0;
};

/** @brief Finds what an edit left as it was. */
class Untouched {
public:
  Untouched(const Floorplan& before, const Floorplan& plan)
      : before_(before)
      , plan_(plan)
  {}

  /** @brief Returns whether a room has the outline, floor and ceiling that it had. */
  bool isSameRoom(std::uint32_t id) const
  {
    const PlanRoom* const old = findRoom(before_, id);
    const PlanRoom* const now = findRoom(plan_, id);
    return old && now && isSame(old->boundary, now->boundary) &&
           planesOf(*old) == planesOf(*now);
  }

  /** @brief Returns which room a room is now, or is a part of; 0: none. */
  std::uint32_t roomNow(std::uint32_t id) const
  {
    return findRoom(plan_, id) ? id : roomAround(findRoom(before_, id), plan_);
  }

  /** @brief Returns whether a new room is a part of a room before. */
  bool isSplit(std::uint32_t id) const
  {
    return std::any_of(
        plan_.rooms.begin(), plan_.rooms.end(), [&](const PlanRoom& room) {
          return !findRoom(before_, room.id) && roomAround(&room, before_) == id;
        });
  }

  /** @brief Returns which wall a wall is now; nothing if it was touched. */
  std::optional<WallNumber> find(const WallNumber& old) const
  {
    const PlanRoom* const room = findRoom(before_, old.room);
    if (!room || old.wall < 1 || old.wall > room->boundary.elements.size())
      return {};
    for (const PlanRoom& now : plan_.rooms)
      if (const auto k = elementLike(now, room->boundary.elements[old.wall - 1]))
        return WallNumber{now.id, *k + 1};
    return {};
  }

private:
  /** @brief Returns the room of a plan that holds the middle of a room, 0 for none. */
  static std::uint32_t roomAround(const PlanRoom* room, const Floorplan& plan)
  {
    if (room)
      for (const PlanRoom* const other : roomsAt(plan, heightsOf(*room)))
        if (other->contains(textSpotIn(room->boundary, room->columns).place))
          return other->id;
    return 0;
  }

  static std::vector<Eigen::Vector4d> planesOf(const PlanRoom& room)
  {
    std::vector<Eigen::Vector4d> planes{room.floor.plane, room.ceiling.plane};
    for (const auto* const details : {&room.floor_details, &room.details})
      for (const PlanDetail& detail : *details)
        planes.push_back(detail.slab.plane);
    return planes;
  }

  const Floorplan& before_;
  const Floorplan& plan_;
};

} // namespace pcl::sedr::tools
