// SPDX-License-Identifier: BSD-3-Clause
// Rooms, ceilings and floors are compared cell by cell.
#include "element_changes.h"

#include "sedr_filters/src/base/middle_value.h"
#include "sedr_filters/src/plan/plan_bounds.h"
#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/plan_measures.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace pcl::sedr::tools {

namespace {

constexpr double cell_size = 0.1; // metres
constexpr double half = 0.5;

/** @brief A place of a plan: its room, and the slab above or below. */
struct Spot {
  const PlanRoom* room = nullptr;
  int detail = -1;     ///< index in the room's list, -1 for the main slab
  double height = 0;   ///< metres
  RoomHeights heights; ///< of the room
};

/** @brief Floors or ceilings by cell, with a spot for each room above each other. */
using Spots = std::map<CellKey, std::vector<Spot>>;

void
addSpots(const PlanRoom& room, bool is_floor, Spots& all)
{
  const CellGrid grid(cell_size);
  const Eigen::AlignedBox2d box = boundsOf(room.boundary);
  if (box.isEmpty())
    return;
  const RoomHeights heights = heightsOf(room);
  const Cell low = grid.at(box.min().x(), box.min().y());
  const Cell high = grid.at(box.max().x(), box.max().y());
  for (std::int32_t y = low.y; y <= high.y; ++y)
    for (std::int32_t x = low.x; x <= high.x; ++x) {
      const Eigen::Vector2d place = grid.centre({x, y});
      if (!room.contains(place))
        continue;
      auto& spots = all[keyOf({x, y})];
      // Of rooms that overlap at their heights, the last one counts.
      spots.erase(std::remove_if(spots.begin(), spots.end(),
                                 [&](const Spot& spot) {
                                   return shareHeights(spot.heights, heights);
                                 }),
                  spots.end());
      spots.push_back(
          {&room, is_floor ? room.floorDetailAt(place) : room.detailAt(place),
           is_floor ? room.floorAt(place) : room.ceilingAt(place), heights});
    }
}

Spots
spotsOf(const Floorplan& plan, bool is_floor)
{
  Spots spots;
  for (const auto& room : plan.rooms)
    addSpots(room, is_floor, spots);
  return spots;
}

/** @brief Returns the spot in a cell with the largest overlap of room heights; null if
 * its rooms are all above or below. */
const Spot*
spotBeside(const Spots& spots, CellKey cell, const Spot& spot)
{
  const auto found = spots.find(cell);
  const Spot* best = nullptr;
  double most = 0;
  if (found != spots.end())
    for (const Spot& other : found->second) {
      const double common = std::min(other.heights.high, spot.heights.high) -
                            std::max(other.heights.low, spot.heights.low);
      if (shareHeights(other.heights, spot.heights) && common > most) {
        most = common;
        best = &other;
      }
    }
  return best;
}

/** @brief A slab of a plan: room and detail, -1 for the room's main slab. */
using SlabId = std::pair<std::uint32_t, int>;

/** @brief A slab and what the other plan has over its cells. */
struct Slab {
  SlabId id;
  std::string what; ///< "soffit", "recess", "step", "pit", "ceiling" or "floor"
  std::string name;
  PlanLoop outline;
  std::size_t cells = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(); ///< of its cells' centres
  std::size_t known = 0;                         ///< cells in rooms of the other plan
  std::size_t changed = 0;                       ///< of those, cells at another height
  std::map<SlabId, std::vector<double>> rises; ///< of these, to the other plan, by slab

  bool isMain() const { return id.second < 0; }
  double area() const { return static_cast<double>(cells) * cell_size * cell_size; }
  Eigen::Vector3d middle() const { return sum / static_cast<double>(cells); }

  /** @brief Returns whether most of what both plans know of it, and enough, is at
   * another height. */
  bool hasChanged(double minimum_area) const
  {
    const auto other = static_cast<double>(changed);
    return other > half * static_cast<double>(known) &&
           other * cell_size * cell_size >= minimum_area;
  }

  /** @brief Returns the slab of the other plan that covers over half of the changed
   * cells, with the rises; the end if there is none. */
  auto successor() const
  {
    return std::find_if(rises.begin(), rises.end(), [&](const auto& other) {
      return static_cast<double>(other.second.size()) >
             half * static_cast<double>(changed);
    });
  }
};

/** @brief Sets word and name of a slab. */
void
describe(const PlanRoom& room, bool is_floor, Slab& slab)
{
  const int detail = slab.id.second;
  slab.what = is_floor ? "floor" : "ceiling";
  slab.name = "room_" + std::to_string(room.id) + "_" + slab.what;
  slab.outline = room.boundary;
  if (slab.isMain())
    return;
  const PlanSlab& own = is_floor ? room.floorSlab(detail) : room.ceilingSlab(detail);
  const PlanSlab& main = is_floor ? room.floor : room.ceiling;
  const auto& parts = is_floor ? room.floor_details : room.details;
  slab.outline = parts[static_cast<std::size_t>(detail)].boundary;
  const auto& elements = slab.outline.elements;
  const Eigen::Vector2d place =
      elements.empty() ? Eigen::Vector2d(0, 0) : elements[0].start;
  const bool is_higher = own.heightAt(place) > main.heightAt(place);
  slab.what = is_floor ? is_higher ? "step" : "pit" : is_higher ? "recess" : "soffit";
  slab.name = "room_" + std::to_string(room.id) +
              (is_floor ? "_floor_detail_" : "_detail_") + std::to_string(detail + 1);
}

std::map<SlabId, Slab>
slabsOf(const Spots& own, const Spots& others, bool is_floor, double tolerance)
{
  const CellGrid grid(cell_size);
  std::map<SlabId, Slab> slabs;
  for (const auto& [key, spots] : own)
    for (const Spot& spot : spots) {
      const SlabId id{spot.room->id, spot.detail};
      Slab& slab = slabs[id];
      if (slab.cells++ == 0) {
        slab.id = id;
        describe(*spot.room, is_floor, slab);
      }
      const Eigen::Vector2d place = grid.centre(cellOf(key));
      slab.sum += Eigen::Vector3d(place.x(), place.y(), spot.height);
      if (const Spot* other = spotBeside(others, key, spot)) {
        const double rise = other->height - spot.height;
        ++slab.known;
        if (std::abs(rise) > tolerance) {
          ++slab.changed;
          slab.rises[{other->room->id, other->detail}].push_back(rise);
        }
      }
    }
  return slabs;
}

Change
single(const Slab& slab, ChangeKind kind)
{
  Change change{kind, slab.what, {}, {}, slab.area()};
  change.names() = {slab.name};
  change.outlines = {slab.outline};
  return change;
}

/** @brief Compares floors, or ceilings. */
std::vector<Change>
sideChanges(const Floorplan& before,
            const Floorplan& after,
            const CompareSettings& settings,
            bool is_floor)
{
  const Spots first = spotsOf(before, is_floor);
  const Spots second = spotsOf(after, is_floor);
  const auto old_slabs = slabsOf(first, second, is_floor, settings.tolerance);
  const auto new_slabs = slabsOf(second, first, is_floor, settings.tolerance);
  std::vector<Change> changes;
  std::set<SlabId> moved; // in the plan after
  std::vector<Slab> gone;
  std::vector<Slab> come;
  for (const auto& [id, slab] : old_slabs) {
    if (!slab.hasChanged(settings.minimum_area))
      continue;
    const auto successor = slab.successor();
    if (successor != slab.rises.end() &&
        (successor->first.second < 0) == slab.isMain()) {
      changes.push_back(single(slab, ChangeKind::Moved));
      moved.insert(successor->first);
      changes.back().after = {new_slabs.at(successor->first).name};
      changes.back().outlines = {new_slabs.at(successor->first).outline};
      changes.back().shift.z() = middleValue(successor->second);
    }
    else if (!slab.isMain())
      gone.push_back(slab);
  }
  for (const auto& [id, slab] : new_slabs)
    if (!slab.isMain() && slab.hasChanged(settings.minimum_area) &&
        moved.count(id) == 0)
      come.push_back(slab);
  // A detail may have moved aside: same kind, similar size, same height.
  const auto distance = [&](const Slab& a, const Slab& b) {
    constexpr double max_ratio = 1.3; // of areas
    const double ratio = a.area() / b.area();
    const Eigen::Vector3d shift = b.middle() - a.middle();
    return a.what == b.what && std::max(ratio, 1 / ratio) < max_ratio &&
                   std::abs(shift.z()) <= settings.tolerance
               ? shift.head<2>().norm()
               : std::numeric_limits<double>::infinity();
  };
  for (const auto& [a, b] : takePairs(gone, come, settings.farthest, distance)) {
    changes.push_back(single(a, ChangeKind::Moved));
    changes.back().after = {b.name};
    changes.back().outlines = {b.outline};
    changes.back().shift = b.middle() - a.middle();
  }
  for (const Slab& slab : come)
    changes.push_back(single(slab, ChangeKind::Appeared));
  for (const Slab& slab : gone)
    changes.push_back(single(slab, ChangeKind::Vanished));
  return changes;
}

/** @brief Adds the rooms of a plan with less than half their area in rooms of the
 * other. */
void
addLostRooms(const Floorplan& plan,
             const Floorplan& other,
             ChangeKind kind,
             std::vector<std::uint32_t>& ids,
             std::vector<Change>& changes)
{
  const Spots others = spotsOf(other, true);
  std::map<std::uint32_t, std::pair<std::size_t, std::size_t>> cells; // all, in both
  for (const auto& [key, spots] : spotsOf(plan, true))
    for (const Spot& spot : spots) {
      ++cells[spot.room->id].first;
      cells[spot.room->id].second += spotBeside(others, key, spot) ? 1 : 0;
    }
  for (const auto& room : plan.rooms) {
    const auto [all, shared] = cells[room.id];
    if (all == 0 || static_cast<double>(shared) >= half * static_cast<double>(all))
      continue;
    ids.push_back(room.id);
    changes.push_back({kind, "room", {}, {}, room.area()});
    changes.back().names() = {"room_" + std::to_string(room.id)};
    changes.back().outlines = {room.boundary};
  }
}

} // namespace

RoomChanges
roomChanges(const Floorplan& before, const Floorplan& after)
{
  RoomChanges rooms;
  addLostRooms(before, after, ChangeKind::Vanished, rooms.before, rooms.changes);
  addLostRooms(after, before, ChangeKind::Appeared, rooms.after, rooms.changes);
  return rooms;
}

std::vector<Change>
slabChanges(const Floorplan& before,
            const Floorplan& after,
            const CompareSettings& settings)
{
  auto changes = sideChanges(before, after, settings, false);
  const auto floors = sideChanges(before, after, settings, true);
  changes.insert(changes.end(), floors.begin(), floors.end());
  return changes;
}

} // namespace pcl::sedr::tools
