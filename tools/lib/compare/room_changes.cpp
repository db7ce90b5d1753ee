// SPDX-License-Identifier: BSD-3-Clause
#include "element_changes.h"

#include "plan_slabs.h"

namespace pcl::sedr::tools {

namespace {

/** @brief Returns the rooms of a plan with less than half their area in rooms of the
 * other. */
std::vector<Change>
lostRooms(const Floorplan& plan,
          const Floorplan& other,
          ChangeKind kind,
          std::vector<std::uint32_t>& ids)
{
  std::vector<Change> changes;
  const Slabs slabs = slabsOf(plan, true);
  const Slabs others = slabsOf(other, true);
  std::map<std::uint32_t, std::pair<std::size_t, std::size_t>> cells; // all, in both
  for (const auto& [key, spots] : slabs)
    for (const Spot& spot : spots) {
      auto& [all, shared] = cells[spot.room->id];
      ++all;
      shared += spotBeside(others, key, spot) ? 1 : 0;
    }
  for (const auto& room : plan.rooms) {
    const auto& [all, shared] = cells[room.id];
    if (all == 0 || static_cast<double>(shared) >= 0.5 * static_cast<double>(all))
      continue;
    ids.push_back(room.id);
    Change change;
    change.kind = kind;
    change.what = "room";
    (kind == ChangeKind::Appeared ? change.after : change.before)
        .push_back("room_" + std::to_string(room.id));
    change.size = room.area();
    changes.push_back(change);
  }
  return changes;
}

} // namespace

RoomChanges
roomChanges(const Floorplan& before, const Floorplan& after)
{
  RoomChanges rooms;
  rooms.changes = lostRooms(before, after, ChangeKind::Vanished, rooms.before);
  const auto come = lostRooms(after, before, ChangeKind::Appeared, rooms.after);
  rooms.changes.insert(rooms.changes.end(), come.begin(), come.end());
  return rooms;
}

} // namespace pcl::sedr::tools
