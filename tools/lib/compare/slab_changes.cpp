// SPDX-License-Identifier: BSD-3-Clause
// Rooms, ceilings and floors are compared cell by cell.
#include "element_changes.h"

#include "sedr_filters/src/base/quantiles.h"
#include "sedr_filters/src/plan/plan_geometry.h"
#include "sedr_filters/src/plan/room_lookup.h"
#include <pcl/sedr_filters/impl/cell_grid.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace pcl::sedr::tools {

namespace {

constexpr double cell_size = 0.1; // metres

/** @brief A slab of a plan: room and detail, -1 for the room's main slab. */
using SlabId = std::pair<std::uint32_t, int>;

/** @brief A slab and what the other plan has over its cells. */
struct Slab : Element {
  bool is_main = true;
  std::size_t cells = 0;
  std::size_t known = 0;                       ///< cells in rooms of the other plan
  std::size_t changed = 0;                     ///< of those, cells at another height
  std::map<SlabId, std::vector<double>> rises; ///< of these, to the other plan, by slab

  /** @brief Returns whether most of what both plans know of it, and enough, is at
   * another height. */
  bool hasChanged(double minimum_area) const
  {
    return 2 * changed > known &&
           static_cast<double>(changed) * cell_size * cell_size >= minimum_area;
  }

  /** @brief Returns the slab of the other plan that covers over half of the changed
   * cells, with the rises; the end if there is none. */
  auto successor() const
  {
    return std::find_if(rises.begin(), rises.end(), [&](const auto& other) {
      return 2 * other.second.size() > changed;
    });
  }
};

using Slabs = std::map<SlabId, Slab>;

/** @brief Returns a slab with its word, "soffit", "recess", "step", "pit", "ceiling" or
 * "floor", and its name. */
Slab
slabOf(const PlanRoom& room, int detail, bool is_floor)
{
  Slab slab;
  slab.is_main = detail < 0;
  slab.what = is_floor ? "floor" : "ceiling";
  slab.name = "room_" + std::to_string(room.id) + "_";
  slab.outline = room.boundary;
  if (slab.is_main) {
    slab.name += slab.what;
    return slab;
  }
  const PlanSlab& main = is_floor ? room.floor : room.ceiling;
  const PlanDetail& own =
      (is_floor ? room.floor_details : room.details)[static_cast<std::size_t>(detail)];
  slab.outline = own.boundary;
  const Eigen::Vector2d place = slab.outline.elements.empty()
                                    ? Eigen::Vector2d(0, 0)
                                    : slab.outline.elements[0].start;
  const bool is_higher = own.slab.heightAt(place) > main.heightAt(place);
  slab.what = is_floor ? is_higher ? "step" : "pit" : is_higher ? "recess" : "soffit";
  slab.name += (is_floor ? "floor_detail_" : "detail_") + std::to_string(detail + 1);
  return slab;
}

/** @brief Returns the rooms that share heights with a room, those that share most
 * first. */
std::vector<const RoomLookup*>
roomsBeside(const PlanRoom& room, const std::vector<RoomLookup>& others)
{
  const RoomHeights own = heightsOf(room);
  std::multimap<double, const RoomLookup*> found; // by the height not shared
  for (const RoomLookup& other : others) {
    const RoomHeights heights = heightsOf(other.room());
    if (shareHeights(own, heights))
      found.emplace(std::max(own.low, heights.low) - std::min(own.high, heights.high),
                    &other);
  }
  std::vector<const RoomLookup*> rooms;
  for (const auto& entry : found)
    rooms.push_back(entry.second);
  return rooms;
}

/** @brief Compares the floors, or ceilings, of a room with those of another plan. */
void
addSlabs(const RoomLookup& room,
         const std::vector<RoomLookup>& others,
         bool is_floor,
         double tolerance,
         Slabs& slabs)
{
  const CellGrid grid(cell_size);
  const auto beside = roomsBeside(room.room(), others);
  const auto spotIn = [&](const RoomLookup& in, const Eigen::Vector2d& place) {
    const int detail = is_floor ? in.floorDetailAt(place) : in.detailAt(place);
    return std::pair(SlabId(in.room().id, detail),
                     is_floor ? in.floorAt(place) : in.ceilingAt(place));
  };
  const Eigen::AlignedBox2d box = boundsOf(room.room().boundary);
  const Cell low = grid.at(box.min().x(), box.min().y());
  const Cell high = grid.at(box.max().x(), box.max().y());
  for (Cell cell = low; cell.y <= high.y; ++cell.y)
    for (cell.x = low.x; cell.x <= high.x; ++cell.x) {
      const Eigen::Vector2d place = grid.centre(cell);
      if (!room.contains(place))
        continue;
      const auto [id, height] = spotIn(room, place);
      if (slabs.count(id) == 0)
        slabs[id] = slabOf(room.room(), id.second, is_floor);
      Slab& slab = slabs[id];
      ++slab.cells;
      slab.size += cell_size * cell_size;
      slab.middle += (Eigen::Vector3d(place.x(), place.y(), height) - slab.middle) /
                     static_cast<double>(slab.cells);
      const auto other = std::find_if(beside.begin(), beside.end(), [&](const auto* o) {
        return o->contains(place);
      });
      if (other == beside.end())
        continue;
      ++slab.known;
      const auto [other_id, other_height] = spotIn(**other, place);
      if (std::abs(other_height - height) > tolerance) {
        ++slab.changed;
        slab.rises[other_id].push_back(other_height - height);
      }
    }
}

Slabs
slabsOf(const Floorplan& plan, const Floorplan& other, bool is_floor, double tolerance)
{
  const std::vector<RoomLookup> rooms(plan.rooms.begin(), plan.rooms.end());
  const std::vector<RoomLookup> others(other.rooms.begin(), other.rooms.end());
  Slabs slabs;
  for (const RoomLookup& room : rooms)
    if (!room.room().boundary.elements.empty())
      addSlabs(room, others, is_floor, tolerance, slabs);
  return slabs;
}

/** @brief Compares floors, or ceilings. */
void
addSlabChanges(const Slabs& before,
               const Slabs& after,
               const CompareSettings& settings,
               std::vector<Change>& changes)
{
  std::set<SlabId> moved; // in the plan after
  std::vector<Slab> gone;
  std::vector<Slab> come;
  for (const auto& [id, slab] : before) {
    if (!slab.hasChanged(settings.minimum_area))
      continue;
    const auto successor = slab.successor();
    if (successor != slab.rises.end() &&
        (successor->first.second < 0) == slab.is_main) {
      changes.push_back(moveOf(slab, after.at(successor->first)));
      changes.back().shift = {0, 0, middleValue(successor->second)};
      moved.insert(successor->first);
    }
    else if (!slab.is_main)
      gone.push_back(slab);
  }
  for (const auto& [id, slab] : after)
    if (!slab.is_main && slab.hasChanged(settings.minimum_area) && moved.count(id) == 0)
      come.push_back(slab);
  // A detail may have moved aside: same kind, similar size, same height.
  const auto distance = [&](const Slab& a, const Slab& b) {
    constexpr double max_ratio = 1.3; // of areas
    const Eigen::Vector3d shift = b.middle - a.middle;
    return a.what == b.what && a.size < max_ratio * b.size &&
                   b.size < max_ratio * a.size &&
                   std::abs(shift.z()) <= settings.tolerance
               ? shift.head<2>().norm()
               : never;
  };
  for (const auto& [a, b] : takePairs(gone, come, settings.farthest, distance))
    changes.push_back(moveOf(a, b));
  for (const Slab& slab : come)
    changes.push_back(changeOf(slab, ChangeKind::Appeared));
  for (const Slab& slab : gone)
    changes.push_back(changeOf(slab, ChangeKind::Vanished));
}

/** @brief Adds the rooms of a plan with less than half their area in rooms of the
 * other. */
void
addLostRooms(const Floorplan& plan,
             const Slabs& floors,
             ChangeKind kind,
             std::vector<Change>& changes)
{
  for (const auto& room : plan.rooms) {
    std::size_t cells = 0;
    std::size_t known = 0;
    for (const auto& [id, floor] : floors)
      if (id.first == room.id) {
        cells += floor.cells;
        known += floor.known;
      }
    if (2 * known < cells)
      changes.push_back(changeOf(
          {"room", "room_" + std::to_string(room.id), room.boundary, room.area()},
          kind));
  }
}

} // namespace

std::vector<Change>
slabChanges(const Floorplan& before,
            const Floorplan& after,
            const CompareSettings& settings,
            std::vector<Change>& rooms)
{
  std::vector<Change> changes;
  for (const bool is_floor : {false, true}) {
    const Slabs gone = slabsOf(before, after, is_floor, settings.tolerance);
    const Slabs come = slabsOf(after, before, is_floor, settings.tolerance);
    addSlabChanges(gone, come, settings, changes);
    if (is_floor) {
      addLostRooms(before, gone, ChangeKind::Vanished, rooms);
      addLostRooms(after, come, ChangeKind::Appeared, rooms);
    }
  }
  return changes;
}

} // namespace pcl::sedr::tools
