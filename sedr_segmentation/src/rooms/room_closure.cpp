// SPDX-License-Identifier: BSD-3-Clause
#include "room_closure.h"

#include "../parting/wall_beside.h"
#include "../sheets/minimum_cut.h"
#include "unseen_parts.h"
#include "wall_lines.h"

#include "sedr_filters/src/grids/cell_mask.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <unordered_map>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief What is in a cell at the heights of a room. */
enum class Content { Unseen, Wall, Other };

/** @brief A cell that may be of a room, with the heights that go on to it. */
struct Beside {
  Cell cell;
  std::int32_t low = 0;
  std::int32_t high = 0;
  Content content = Content::Unseen;
  std::size_t gap = 0; ///< of a part that rooms may take; none: number of gaps
  bool is_own = false; ///< it is of the room, behind a narrow way
  RoomColumn column;   ///< what it would be of the room
};

/** @brief Whether two stretches of a column overlap by half of the lower of them. */
bool
isSameAir(std::int32_t low, std::int32_t high, std::int32_t other, std::int32_t top)
{
  return 2 * (std::min(high, top) - std::max(low, other)) >=
         std::min(high - low, top - other);
}

/** @brief Which cells hold air of rooms, or what completes them. */
class TakenCells {
public:
  void take(Cell cell, std::int32_t low, std::int32_t high)
  {
    at_[keyOf(cell)].emplace_back(low, high);
  }

  bool isTaken(Cell cell, std::int32_t low, std::int32_t high) const
  {
    const auto found = at_.find(keyOf(cell));
    return found != at_.end() &&
           std::any_of(found->second.begin(), found->second.end(), [&](const auto& h) {
             return isSameAir(h.first, h.second, low, high);
           });
  }

private:
  std::unordered_map<CellKey, std::vector<std::pair<std::int32_t, std::int32_t>>> at_;
};

/** @brief Completes one room. */
class RoomClosure {
public:
  RoomClosure(const AirGaps& air,
              const PartedAir& parted,
              const std::vector<PartUse>& use,
              const PartingParameters& parameters,
              const TakenCells& taken,
              const BuildingRoom& room)
      : air_(air)
      , parted_(parted)
      , use_(use)
      , parameters_(parameters)
      , taken_(taken)
      , room_(room)
      , lines_(wallsAround(), air.columns().cellSize(), parameters.min_line)
  {
    for (const RoomColumn& c : room.columns)
      box_.extend(lines_.along(air.columns().grid().centre(c.cell)));
    seen_box_ = (box_.sizes().array() + air.columns().cellSize()).prod();
    const double depth = (wall_depth + 1) * air.columns().cellSize();
    box_.min().array() -= depth;
    box_.max().array() += depth;
  }

  /** @brief The cells that complete the room. */
  std::vector<Beside> added()
  {
    if (!findCore())
      return {};
    reach();
    const std::vector<std::uint8_t> is_inside = cheapest();
    std::vector<Beside> added;
    for (std::size_t k = 0; k < unseen_.size(); ++k)
      if (is_inside[k] != 0 && !unseen_[k].is_own)
        added.push_back(unseen_[k]);
    return withoutFringes(std::move(added));
  }

  /** @brief Area of the rectangle around what was seen, along the walls. */
  double seenBox() const { return seen_box_; }

  const WallLines& lines() const { return lines_; }

private:
  /** @brief What is known of a cell that is none of unseen_. */
  enum Known : std::size_t {
    absent = static_cast<std::size_t>(-1),
    own = static_cast<std::size_t>(-2),
    wall = static_cast<std::size_t>(-3)
  };

  /** @brief The places of walls within three cells of the room's outline. */
  std::vector<Eigen::Vector2d> wallsAround()
  {
    std::vector<Eigen::Vector2d> walls;
    for (const RoomColumn& c : room_.columns)
      known_[keyOf(c.cell)] = own;
    std::map<CellKey, bool> is_met;
    for (const RoomColumn& c : room_.columns)
      for (const Cell& by : plan_directions) {
        Cell at = c.cell;
        for (int step = 0; step < wall_depth; ++step) {
          at = moved(at, by);
          if (known_.count(keyOf(at)) > 0)
            break;
          if (!isWalledUp(air_, air_.columns().columnAt(at), lowOf(air_, c),
                          highOf(air_, c)))
            continue;
          if (!std::exchange(is_met[keyOf(at)], true))
            walls.push_back(air_.columns().grid().centre(at));
          break;
        }
      }
    return walls;
  }

  /** @brief Finds the part of the room that no way narrower than a door leads to, and
   * the holes in it. What is seen through a door tells nothing of what is beside it,
   * and what is unseen within a room is a column or behind furniture.
   * @return false if there is none */
  bool findCore()
  {
    const double radius = parameters_.widest_door / 2 / air_.columns().cellSize();
    std::vector<CellKey> keys;
    for (const RoomColumn& c : room_.columns)
      keys.push_back(keyOf(c.cell));
    const CellSet cells(std::move(keys));
    const CellBox box = grown(boxOf(cells), static_cast<int>(radius) + 1);
    if (!maskProblem(box).empty())
      return false;
    const CellMask own_cells(cells, box);
    const CellMask core =
        intersect(dilated(largestRegion(eroded(own_cells, radius)), radius), own_cells);
    holes_ = enclosedCells(own_cells);
    for (const RoomColumn& c : room_.columns)
      if (!core.at(c.cell)) {
        known_[keyOf(c.cell)] = unseen_.size();
        unseen_.push_back({c.cell, lowOf(air_, c), highOf(air_, c), Content::Unseen,
                           air_.size(), true, c});
      }
    return core.count() > 0;
  }

  /** @brief Looks what is in a cell to which the air of a room may go on. */
  Beside lookAt(Cell cell, std::int32_t low, std::int32_t high) const
  {
    Beside b;
    b.cell = cell;
    b.low = low;
    b.high = high;
    b.gap = air_.size();
    const std::uint32_t column = air_.columns().columnAt(cell);
    bool floor_seen = false;
    bool ceiling_seen = false;
    if (column != VoxelColumns::none) {
      for (std::size_t g = air_.first(column); g < air_.first(column + 1); ++g) {
        if (parted_.room[g] == PartedAir::no_room ||
            !isSameAir(air_[g].low, air_[g].high, low, high))
          continue;
        if (use_[static_cast<std::size_t>(parted_.room[g])] != PartUse::Spare) {
          b.content = Content::Other;
          return b;
        }
        b.gap = g;
      }
      if (b.gap < air_.size()) {
        b.low = air_[b.gap].low;
        b.high = air_[b.gap].high;
        floor_seen = air_[b.gap].floor_seen;
        ceiling_seen = air_[b.gap].ceiling_seen;
      }
      else if (isWalledUp(air_, column, low, high)) {
        b.content = Content::Wall;
        return b;
      }
      else {
        floor_seen = findSurface(column, low - 1, b.low);
        b.low += floor_seen ? 1 : 0;
        ceiling_seen = findSurface(column, high, b.high);
      }
    }
    if (taken_.isTaken(cell, b.low, b.high)) {
      b.content = Content::Other;
      return b;
    }
    b.column = {cell,
                static_cast<float>(air_.columns().heightOf(b.low)),
                static_cast<float>(air_.columns().heightOf(b.high)),
                floor_seen,
                ceiling_seen,
                false};
    return b;
  }

  /** @brief The surface of a column nearest to a height, as far as the same one may be.
   * @param[in,out] found as it was, if there is none */
  bool findSurface(std::uint32_t column, std::int32_t at, std::int32_t& found) const
  {
    const int reach = air_.voxels(air_.parameters().same_surface);
    for (int away = 0; away <= reach; ++away)
      for (const int sign : {1, -1})
        if (air_.columns().isOccupied(column, at + sign * away)) {
          found = at + sign * away;
          return true;
        }
    return false;
  }

  /** @brief Finds the unseen cells to which the room's air may go on, within the box
   * around it; the nearest air gives each its heights. */
  void reach()
  {
    const auto visit = [&](Cell cell, std::int32_t low, std::int32_t high) {
      const auto [entry, is_new] = known_.emplace(keyOf(cell), absent);
      if (!is_new || holes_.at(cell))
        return;
      if (!box_.contains(lines_.along(air_.columns().grid().centre(cell))))
        return;
      const Beside b = lookAt(cell, low, high);
      if (b.content == Content::Wall)
        entry->second = wall;
      if (b.content != Content::Unseen)
        return;
      entry->second = unseen_.size();
      unseen_.push_back(b);
    };
    for (const RoomColumn& c : room_.columns)
      for (const Cell& by : plan_directions)
        visit(moved(c.cell, by), lowOf(air_, c), highOf(air_, c));
    for (std::size_t k = 0; k < unseen_.size(); ++k)
      for (const Cell& by : plan_directions)
        visit(moved(unseen_[k].cell, by), unseen_[k].low, unseen_[k].high);
  }

  /** @brief Of some cells the parts that are wide enough for someone to stand in; what
   * is narrower is the ragged edge of what was seen. */
  std::vector<Beside> withoutFringes(std::vector<Beside> added) const
  {
    const double radius = parameters_.min_way / air_.columns().cellSize();
    std::vector<CellKey> keys;
    for (const Beside& b : added)
      keys.push_back(keyOf(b.cell));
    const CellSet cells(std::move(keys));
    const CellBox box = grown(boxOf(cells), 1);
    if (added.empty() || !maskProblem(box).empty())
      return {};
    const CellMask all(cells, box);
    const CellMask wide = markedRegions(all, eroded(all, radius), false);
    added.erase(std::remove_if(added.begin(), added.end(),
                               [&](const Beside& b) { return !wide.at(b.cell); }),
                added.end());
    return added;
  }

  std::size_t knownAt(Cell cell) const
  {
    const auto found = known_.find(keyOf(cell));
    return found == known_.end() ? absent : found->second;
  }

  /** @brief Which unseen cells are inside, so that the least length of the outline was
   * not seen: the length of a cut of a grid by Crofton's formula, eight neighbours. */
  std::vector<std::uint8_t> cheapest() const
  {
    const double cell = air_.columns().cellSize();
    BinaryEnergy energy(unseen_.size());
    for (std::size_t k = 0; k < unseen_.size(); ++k) {
      if (!unseen_[k].is_own && !unseen_[k].column.ceiling_seen)
        energy.addTerm(k, 0, parameters_.area_cost * cell * cell);
      const Cell at = unseen_[k].cell;
      const auto side = lines_.before(air_.columns().grid().centre(at));
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          if (dx == 0 && dy == 0)
            continue;
          const Cell other = moved(at, {dx, dy});
          const std::size_t there = knownAt(other);
          const bool is_diagonal = dx != 0 && dy != 0;
          if (there == wall || (is_diagonal && knownAt(moved(at, {dx, 0})) == wall &&
                                knownAt(moved(at, {0, dy})) == wall))
            continue;
          const bool is_line =
              side != lines_.before(air_.columns().grid().centre(other));
          const double length = M_PI / 8 * cell * (is_diagonal ? M_SQRT1_2 : 1) *
                                (is_line ? parameters_.line_cost : 1);
          if (there == own)
            energy.addTerm(k, length, 0);
          else if (there == absent)
            energy.addTerm(k, 0, length);
          else if (there > k)
            energy.addPair(k, there, 0, length, length, 0);
        }
    }
    return energy.minimise();
  }

  const AirGaps& air_;
  const PartedAir& parted_;
  const std::vector<PartUse>& use_;
  const PartingParameters& parameters_;
  const TakenCells& taken_;
  const BuildingRoom& room_;
  std::unordered_map<CellKey, std::size_t> known_; ///< index in unseen_, or what it is
  std::vector<Beside> unseen_;
  CellMask holes_; ///< in what was seen of the room
  WallLines lines_;
  Eigen::AlignedBox2d box_;
  double seen_box_ = 0;
};

} // namespace

void
closeRooms(const AirGaps& air,
           const PartedAir& parted,
           const std::vector<PartUse>& use,
           const PartingParameters& parameters,
           std::vector<BuildingRoom>& parts,
           const RoomTest& isRoom)
{
  const double cell = air.columns().cellSize();
  TakenCells taken;
  std::vector<std::vector<CellKey>> gone(parts.size());
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (use[p] != PartUse::Room)
      continue;
    RoomClosure closure(air, parted, use, parameters, taken, parts[p]);
    const std::vector<Beside> added = closure.added();
    BuildingRoom room = parts[p];
    for (const Beside& b : added)
      room.columns.push_back(b.column);
    std::sort(room.columns.begin(), room.columns.end(),
              [](const RoomColumn& a, const RoomColumn& b) {
                return keyOf(a.cell) < keyOf(b.cell);
              });
    room.area = static_cast<double>(room.columns.size()) * cell * cell;
    measureUnseen(air, closure.lines().steps(), room);
    if (!isRoom(static_cast<std::uint32_t>(p), room, closure.seenBox()))
      continue;
    parts[p] = std::move(room);
    for (const Beside& b : added) {
      taken.take(b.cell, b.low, b.high);
      if (b.gap < air.size())
        gone[static_cast<std::size_t>(parted.room[b.gap])].push_back(keyOf(b.cell));
    }
  }
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (gone[p].empty())
      continue;
    const CellSet cells(std::move(gone[p]));
    auto& columns = parts[p].columns;
    columns.erase(
        std::remove_if(columns.begin(), columns.end(),
                       [&](const RoomColumn& c) { return cells.contains(c.cell); }),
        columns.end());
    parts[p].area = static_cast<double>(columns.size()) * cell * cell;
  }
}

} // namespace pcl::sedr
