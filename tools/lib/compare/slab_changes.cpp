// SPDX-License-Identifier: BSD-3-Clause
#include "element_changes.h"

#include "plan_slabs.h"

#include "sedr_filters/src/base/middle_value.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace pcl::sedr::tools {

namespace {

constexpr double half = 0.5;

/** @brief A slab of a plan: a detail, or a room's main ceiling or floor. */
using SlabId = std::pair<std::uint32_t, int>;

/** @brief The part of the other plan over the cells of a slab. */
struct Overlap {
  const PlanRoom* room = nullptr;
  std::size_t cells = 0;
  Eigen::Vector3d sum =
      Eigen::Vector3d::Zero();          ///< mean of its cells' centres, at its height
  std::size_t known = 0;                ///< cells in rooms of the other plan
  std::size_t same = 0;                 ///< of those, cells at the same height
  std::map<SlabId, std::size_t> others; ///< cells over each slab of the other plan
  std::map<SlabId, std::vector<double>> rises; ///< heights of the other plan minus own

  Eigen::Vector3d middle() const { return sum / static_cast<double>(cells); }
};

std::map<SlabId, Overlap>
overlapsOf(const Slabs& slabs, const Slabs& others, double tolerance)
{
  const CellGrid grid(slab_cell);
  std::map<SlabId, Overlap> overlaps;
  for (const auto& [key, spots] : slabs)
    for (const Spot& spot : spots) {
      Overlap& overlap = overlaps[{spot.room->id, spot.detail}];
      overlap.room = spot.room;
      ++overlap.cells;
      const Eigen::Vector2d place = grid.centre(cellOf(key));
      overlap.sum += Eigen::Vector3d(place.x(), place.y(), spot.height);
      const Spot* other = spotBeside(others, key, spot);
      if (!other)
        continue;
      ++overlap.known;
      const double rise = other->height - spot.height;
      overlap.same += std::abs(rise) <= tolerance ? 1 : 0;
      const SlabId id{other->room->id, other->detail};
      ++overlap.others[id];
      overlap.rises[id].push_back(rise);
    }
  return overlaps;
}

/** @brief Returns "soffit", "recess", "step" or "pit"; "ceiling" or "floor" for main
 * slabs. */
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

/** @brief Returns the slab of the other plan that covers over half of this one. */
std::optional<SlabId>
successorOf(const Overlap& overlap)
{
  for (const auto& [id, cells] : overlap.others)
    if (static_cast<double>(cells) > half * static_cast<double>(overlap.known))
      return id;
  return std::nullopt;
}

/** @brief Compares the slabs of one side, floors or ceilings. */
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
    std::vector<SlabId> gone;
    for (const auto& [id, overlap] : before_) {
      if (!hasChanged(overlap))
        continue;
      const auto successor = successorOf(overlap);
      if (successor && (successor->second < 0) == (id.second < 0))
        changes.push_back(moved(id, overlap, *successor));
      else if (id.second >= 0)
        gone.push_back(id);
    }
    for (const auto& [id, overlap] : after_) {
      if (id.second < 0 || !hasChanged(overlap) || isSuccessor(overlap))
        continue;
      const auto old =
          std::find_if(gone.begin(), gone.end(),
                       [&, now = id](SlabId was) { return isShifted(was, now); });
      if (old == gone.end()) {
        changes.push_back(single(id, overlap, ChangeKind::Appeared));
        continue;
      }
      changes.push_back(shifted(*old, id));
      gone.erase(old);
    }
    for (const auto& id : gone)
      changes.push_back(single(id, before_.at(id), ChangeKind::Vanished));
    return changes;
  }

private:
  /** @brief Returns whether most of a slab's area known in both plans, and enough of
   * it, is at another height. */
  bool hasChanged(const Overlap& overlap) const
  {
    const double other = static_cast<double>(overlap.known - overlap.same);
    return other > half * static_cast<double>(overlap.known) &&
           other * slab_cell * slab_cell >= settings_.minimum_area;
  }

  /** @brief Returns whether a slab of the second plan was reported as the target of a
   * move. */
  static bool isSuccessor(const Overlap& overlap)
  {
    const auto predecessor = successorOf(overlap);
    return predecessor && predecessor->second >= 0;
  }

  /** @brief Returns whether a vanished detail may have moved to an appeared one: same
   * kind, similar size, same height, not too far away. */
  bool isShifted(SlabId was, SlabId now) const
  {
    constexpr double max_ratio = 1.3; // of areas
    const Overlap& a = before_.at(was);
    const Overlap& b = after_.at(now);
    const double ratio = static_cast<double>(a.cells) / static_cast<double>(b.cells);
    const Eigen::Vector3d shift = b.middle() - a.middle();
    return wordFor(*a.room, was.second, is_floor_) ==
               wordFor(*b.room, now.second, is_floor_) &&
           std::max(ratio, 1 / ratio) < max_ratio &&
           std::abs(shift.z()) <= settings_.tolerance &&
           shift.head<2>().norm() <= settings_.farthest;
  }

  Change shifted(SlabId was, SlabId now) const
  {
    Change change = single(was, before_.at(was), ChangeKind::Moved);
    change.after = {nameOf(now, is_floor_)};
    change.shift = after_.at(now).middle() - before_.at(was).middle();
    return change;
  }

  Change moved(SlabId id, const Overlap& overlap, SlabId successor) const
  {
    Change change = single(id, overlap, ChangeKind::Moved);
    change.after = {nameOf(successor, is_floor_)};
    change.shift.z() = middleValue(overlap.rises.at(successor));
    return change;
  }

  Change single(SlabId id, const Overlap& overlap, ChangeKind kind) const
  {
    Change change;
    change.kind = kind;
    change.what = wordFor(*overlap.room, id.second, is_floor_);
    (kind == ChangeKind::Appeared ? change.after : change.before)
        .push_back(nameOf(id, is_floor_));
    change.size = static_cast<double>(overlap.cells) * slab_cell * slab_cell;
    return change;
  }

  CompareSettings settings_;
  bool is_floor_;
  std::map<SlabId, Overlap> before_;
  std::map<SlabId, Overlap> after_;
};

} // namespace

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

} // namespace pcl::sedr::tools
