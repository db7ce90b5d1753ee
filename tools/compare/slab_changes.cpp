// SPDX-License-Identifier: BSD-3-Clause
#include "compare/slab_changes.h"

#include <pcl/sedr_filters/cell_grid.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace pcl {
namespace sedr {
namespace tools {

namespace {

constexpr double cell = 0.1; // metres
constexpr double half = 0.5;

/** @brief A place of a plan: its room, and what is above or below. */
struct Spot {
  const PlanRoom* room = nullptr;
  int detail = -1;   ///< index in the room's list, -1 for the main slab
  double height = 0; ///< metres
};

/** @brief A plan seen from below (the ceilings) or above (the floors), cell by cell. */
using Slabs = std::map<CellKey, Spot>;

Slabs
slabsOf(const Floorplan& plan, bool is_floor)
{
  const CellGrid grid(cell);
  Slabs slabs;
  for (const auto& room : plan.rooms) {
    Eigen::AlignedBox2d box;
    for (const auto& corner : room.boundary.polygon(0.01))
      box.extend(corner);
    if (box.isEmpty())
      continue;
    const Cell low = grid.at(box.min().x(), box.min().y());
    const Cell high = grid.at(box.max().x(), box.max().y());
    for (std::int32_t y = low.y; y <= high.y; ++y)
      for (std::int32_t x = low.x; x <= high.x; ++x) {
        const Eigen::Vector2d place = grid.centre({x, y});
        if (!room.contains(place))
          continue;
        const int detail = is_floor ? room.floorDetailAt(place) : room.detailAt(place);
        const double height = is_floor ? room.floorAt(place) : room.ceilingAt(place);
        slabs[keyOf({x, y})] = {&room, detail, height};
      }
  }
  return slabs;
}

/** @brief A slab of a plan: a detail, or a room's main ceiling or floor. */
using SlabId = std::pair<std::uint32_t, int>;

/** @brief What the other plan has over the cells of a slab. */
struct Overlap {
  const PlanRoom* room = nullptr;
  std::size_t cells = 0;
  std::size_t known = 0;                ///< cells that are in rooms of the other plan
  std::size_t same = 0;                 ///< of them at the same height
  std::map<SlabId, std::size_t> others; ///< cells over each slab of the other plan
  std::map<SlabId, std::vector<double>> rises; ///< heights of the other less ours
};

std::map<SlabId, Overlap>
overlapsOf(const Slabs& slabs, const Slabs& others, double tolerance)
{
  std::map<SlabId, Overlap> overlaps;
  for (const auto& [key, spot] : slabs) {
    Overlap& overlap = overlaps[{spot.room->id, spot.detail}];
    overlap.room = spot.room;
    ++overlap.cells;
    const auto other = others.find(key);
    if (other == others.end())
      continue;
    ++overlap.known;
    const double rise = other->second.height - spot.height;
    overlap.same += std::abs(rise) <= tolerance ? 1 : 0;
    const SlabId id{other->second.room->id, other->second.detail};
    ++overlap.others[id];
    overlap.rises[id].push_back(rise);
  }
  return overlaps;
}

double
medianOf(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/** @brief "soffit", "recess", "step" or "pit"; "ceiling" or "floor" for main slabs. */
std::string
wordFor(const PlanRoom& room, int detail, bool is_floor)
{
  if (detail < 0)
    return is_floor ? "floor" : "ceiling";
  const PlanSlab& slab = is_floor ? room.floorSlab(detail) : room.ceilingSlab(detail);
  const PlanSlab& main = is_floor ? room.floor : room.ceiling;
  const auto& parts = is_floor ? room.floor_details : room.details;
  const auto& boundary = parts[static_cast<std::size_t>(detail)].boundary;
  const Eigen::Vector2d place =
      boundary.elements.empty() ? Eigen::Vector2d(0, 0) : boundary.elements[0].start;
  const bool is_higher = slab.heightAt(place) > main.heightAt(place);
  if (is_floor)
    return is_higher ? "step" : "pit";
  return is_higher ? "recess" : "soffit";
}

std::string
nameOf(SlabId id, bool is_floor)
{
  const std::string room = "room_" + std::to_string(id.first);
  if (id.second < 0)
    return room + (is_floor ? "_floor" : "_ceiling");
  return room + (is_floor ? "_floor_detail_" : "_detail_") +
         std::to_string(id.second + 1);
}

/** @brief The slab of the other plan that takes over half of this one's place. */
std::optional<SlabId>
successorOf(const Overlap& overlap)
{
  for (const auto& [id, cells] : overlap.others)
    if (static_cast<double>(cells) > half * static_cast<double>(overlap.known))
      return id;
  return std::nullopt;
}

/** @brief What has become of the slabs of one side, floors or ceilings. */
class SideComparison {
public:
  SideComparison(const Floorplan& before,
                 const Floorplan& after,
                 const CompareSettings& settings,
                 bool is_floor)
      : settings_(settings)
      , is_floor_(is_floor)
  {
    const Slabs first = slabsOf(before, is_floor);
    const Slabs second = slabsOf(after, is_floor);
    before_ = overlapsOf(first, second, settings.tolerance);
    after_ = overlapsOf(second, first, settings.tolerance);
  }

  std::vector<Change> changes() const
  {
    std::vector<Change> changes;
    for (const auto& [id, overlap] : before_) {
      if (!hasChanged(overlap))
        continue;
      const auto successor = successorOf(overlap);
      if (successor && (successor->second < 0) == (id.second < 0))
        changes.push_back(moved(id, overlap, *successor));
      else if (id.second >= 0)
        changes.push_back(single(id, overlap, ChangeKind::Vanished));
    }
    for (const auto& [id, overlap] : after_)
      if (id.second >= 0 && hasChanged(overlap) && !isSuccessor(overlap))
        changes.push_back(single(id, overlap, ChangeKind::Appeared));
    return changes;
  }

private:
  /** @brief Whether most of a slab's place, as far as it is known to both, is at
   * another height, and enough of it. */
  bool hasChanged(const Overlap& overlap) const
  {
    const double other = static_cast<double>(overlap.known - overlap.same);
    return other > half * static_cast<double>(overlap.known) &&
           other * cell * cell >= settings_.minimum_area;
  }

  /** @brief Whether a slab of the second plan was told as one that has moved there. */
  static bool isSuccessor(const Overlap& overlap)
  {
    const auto predecessor = successorOf(overlap);
    return predecessor && predecessor->second >= 0;
  }

  Change moved(SlabId id, const Overlap& overlap, SlabId successor) const
  {
    Change change = single(id, overlap, ChangeKind::Moved);
    change.after = {nameOf(successor, is_floor_)};
    change.shift.z() = medianOf(overlap.rises.at(successor));
    return change;
  }

  Change single(SlabId id, const Overlap& overlap, ChangeKind kind) const
  {
    Change change;
    change.kind = kind;
    change.what = wordFor(*overlap.room, id.second, is_floor_);
    (kind == ChangeKind::Appeared ? change.after : change.before)
        .push_back(nameOf(id, is_floor_));
    change.size = static_cast<double>(overlap.cells) * cell * cell;
    return change;
  }

  CompareSettings settings_;
  bool is_floor_;
  std::map<SlabId, Overlap> before_;
  std::map<SlabId, Overlap> after_;
};

/** @brief The rooms of a plan of which less than half is room in the other. */
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
  for (const auto& [key, spot] : slabs) {
    auto& [all, shared] = cells[spot.room->id];
    ++all;
    shared += others.count(key);
  }
  for (const auto& room : plan.rooms) {
    const auto& [all, shared] = cells[room.id];
    if (all == 0 || static_cast<double>(shared) >= half * static_cast<double>(all))
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

std::vector<Change>
slabChanges(const Floorplan& before,
            const Floorplan& after,
            const CompareSettings& settings)
{
  auto changes = SideComparison(before, after, settings, false).changes();
  const auto floors = SideComparison(before, after, settings, true).changes();
  changes.insert(changes.end(), floors.begin(), floors.end());
  return changes;
}

} // namespace tools
} // namespace sedr
} // namespace pcl
