// SPDX-License-Identifier: BSD-3-Clause
#include "storey_regions.h"

#include "part_ways.h"
#include "reveal_search.h"

#include "../labelling/minimum_cut.h"
#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace pcl::sedr {

namespace {

/** @brief The neighbours of a cell that share a border with it, one of each pair. */
constexpr std::array<Cell, 4> steps{{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};

constexpr int core_depth = 2; // cells: seen cells this far inside are fixed

/** @brief Lowers the factors of borders on a line. A surface that the room itself sees
 * is free; one that only others see is a line of a wall. */
void
markLine(const WallLine& line,
         std::size_t room,
         const CellGrid& grid,
         double cost,
         const CellMask& frame,
         std::array<std::vector<float>, 4>& factor)
{
  const double size = grid.size();
  for (std::size_t b = 0; b < 2 * line.places.size(); ++b) {
    const AlongLine what = line.places[b / 2];
    if (what == AlongLine::Nothing)
      continue;
    const bool is_own = what == AlongLine::Surface && line.owner[b / 2] == room;
    const auto value = static_cast<float>(is_own ? 0 : cost);
    const Eigen::Vector2d p = line.at((static_cast<double>(b) + 0.5) / 2);
    const Cell middle = grid.at(p.x(), p.y());
    if (!frame.isInside(middle))
      continue;
    for (int y = middle.y - 1; y <= middle.y + 1; ++y)
      for (int x = middle.x - 1; x <= middle.x + 1; ++x) {
        const Cell cell{x, y};
        if (!frame.isInside(cell))
          continue;
        const double d = line.normal.dot(grid.centre(cell)) - line.offset;
        for (std::size_t k = 0; k < steps.size(); ++k) {
          const double e =
              d + size * (line.normal.x() * steps[k].x + line.normal.y() * steps[k].y);
          float& known = factor[k][frame.indexOf(cell)];
          if ((d < 0) != (e < 0))
            known = std::min(known, value);
        }
      }
  }
}

/** @brief Lowers the factor of the borders of cells of a mask. */
void
markCells(const CellMask& mask, double cost, std::array<std::vector<float>, 4>& factor)
{
  const auto value = static_cast<float>(cost);
  for (std::size_t i = 0; i < mask.values().size(); ++i) {
    const Cell cell = mask.cellAt(i);
    for (std::size_t k = 0; k < steps.size(); ++k)
      if (mask.values()[i] || mask.at({cell.x + steps[k].x, cell.y + steps[k].y}))
        factor[k][i] = std::min(factor[k][i], value);
  }
}

/** @brief The cut of one room. */
class RegionCut {
public:
  RegionCut(const RoomCells& room,
            const Surroundings& around,
            const BehindLines& behind,
            const CellGrid& grid,
            const RegionEnergy& energy)
      : size_(grid.size())
      , frame_(room.seen)
      , seen_(subtract(room.seen, unite(around.opaque, room.riser)))
      , reveal_(intersect(behind.reveal, room.seen))
      , wall_(subtract(behind.wall, around.air))
      , energy_(energy)
  {
    const CellMask open =
        subtract(subtract(closed(room.seen, 1.5), reveal_), around.opaque);
    core_ = intersect(eroded(open, core_depth), room.seen);
    core_ = largestRegion(core_);
    do
      solve(around, behind.back);
    while (joinParts(around));
  }

  RoomRegion region() const
  {
    RoomRegion region;
    region.cells = markedRegions(chosen(), core_, false);
    fillSeenHoles(region.cells);
    // The ceiling beside walls is rarely seen, and points of it lie in their cells.
    const auto areaOff = [&](const CellMask& cells, const CellMask& walls, int rim) {
      const CellMask off = subtract(cells, walls);
      return static_cast<double>(dilated(eroded(off, rim), rim).count()) * size_ *
             size_;
    };
    region.lost = areaOff(subtract(seen_, region.cells), reveal_, 1);
    region.unseen = areaOff(subtract(region.cells, seen_), wall_, core_depth);
    return region;
  }

private:
  static constexpr std::int32_t none = -1;  ///< fixed: not of the room
  static constexpr std::int32_t room_ = -2; ///< fixed: of the room

  /** @brief Finds the cells of least energy. */
  void solve(const Surroundings& around, const CellMask& back)
  {
    number_.assign(frame_.values().size(), none);
    free_ = 0;
    for (std::size_t i = 0; i < number_.size(); ++i) {
      const Cell cell = frame_.cellAt(i);
      const bool is_rim = cell.x == frame_.box().low.x ||
                          cell.x == frame_.box().high.x ||
                          cell.y == frame_.box().low.y || cell.y == frame_.box().high.y;
      if (core_.values()[i])
        number_[i] = room_;
      else if (!around.others.values()[i] && !is_rim)
        number_[i] = free_++;
    }
    BinaryEnergy cut(static_cast<std::size_t>(free_));
    for (std::size_t i = 0; i < number_.size(); ++i)
      if (number_[i] >= 0)
        addCell(i, cut);
    for (std::size_t i = 0; i < number_.size(); ++i)
      for (std::size_t k = 0; k < steps.size(); ++k)
        addBorder(i, k, around, back, cut);
    answer_ = cut.minimise();
  }

  CellMask chosen() const
  {
    CellMask cells(frame_.box());
    for (std::size_t i = 0; i < number_.size(); ++i)
      cells.values()[i] =
          number_[i] == room_ ||
          (number_[i] >= 0 && answer_[static_cast<std::size_t>(number_[i])]);
    return cells;
  }

  /** @brief Fixes ways to parts that lie apart. Returns whether there is a new one. */
  bool joinParts(const Surroundings& around)
  {
    const CellMask free = inverted(unite(around.opaque, around.others));
    std::vector<float> worth(frame_.values().size());
    for (std::size_t i = 0; i < worth.size(); ++i)
      worth[i] = static_cast<float>(worthOf(i));
    const std::size_t before = core_.count();
    core_ = unite(core_, waysToParts(chosen(), core_, free, worth, size_));
    return core_.count() > before;
  }

  /** @brief Fills the holes in most of which the ceiling was seen: what stands below it
   * is no column. */
  void fillSeenHoles(CellMask& cells) const
  {
    const MaskRegions holes = labelRegions(enclosedCells(cells), false);
    std::vector<std::size_t> seen(holes.sizes.size(), 0);
    const auto holeOf = [&](std::size_t i) {
      return static_cast<std::size_t>(holes.label[i]);
    };
    for (std::size_t i = 0; i < holes.label.size(); ++i)
      if (holes.label[i] >= 0 && frame_.values()[i])
        ++seen[holeOf(i)];
    for (std::size_t i = 0; i < holes.label.size(); ++i)
      if (holes.label[i] >= 0 && 2 * seen[holeOf(i)] > holes.sizes[holeOf(i)])
        cells.values()[i] = 1;
  }

  /** @brief Returns what leaving a cell out costs more than taking it in. */
  double worthOf(std::size_t i) const
  {
    const bool is_air = seen_.values()[i] && !reveal_.values()[i];
    return size_ * size_ *
           (is_air              ? energy_.seen
            : seen_.values()[i] ? -energy_.reveal
            : wall_.values()[i] ? -energy_.wall
                                : -energy_.unseen);
  }

  void addCell(std::size_t i, BinaryEnergy& cut) const
  {
    const double worth = worthOf(i);
    cut.addTerm(static_cast<std::size_t>(number_[i]), std::max(0.0, worth),
                std::max(0.0, -worth));
  }

  /** @brief Adds the border of a cell with a neighbour, its length by Crofton's formula
   * for eight neighbours. */
  void addBorder(std::size_t i,
                 std::size_t k,
                 const Surroundings& around,
                 const CellMask& back,
                 BinaryEnergy& cut) const
  {
    const Cell cell = frame_.cellAt(i);
    const Cell next{cell.x + steps[k].x, cell.y + steps[k].y};
    if (!frame_.isInside(next))
      return;
    const std::size_t j = frame_.indexOf(next);
    const std::int32_t a = number_[i];
    const std::int32_t b = number_[j];
    if (a < 0 && b < 0)
      return;
    double factor = around.factor[k][i];
    if (back.values()[i] || back.values()[j])
      factor = std::max(factor, energy_.glass);
    const double cost = factor * size_ * M_PI / 8 / std::hypot(steps[k].x, steps[k].y);
    if (!(cost > 0))
      return;
    if (a >= 0 && b >= 0)
      cut.addPair(static_cast<std::size_t>(a), static_cast<std::size_t>(b), 0, cost,
                  cost, 0);
    else {
      const std::int32_t fixed = a >= 0 ? b : a;
      const auto free = static_cast<std::size_t>(a >= 0 ? a : b);
      cut.addTerm(free, fixed == room_ ? cost : 0, fixed == room_ ? 0 : cost);
    }
  }

  double size_;
  const CellMask& frame_;
  CellMask seen_;
  CellMask reveal_;
  CellMask wall_;
  CellMask core_;
  const RegionEnergy& energy_;
  std::vector<std::int32_t> number_; ///< of free cells, else fixed
  std::int32_t free_ = 0;
  std::vector<std::uint8_t> answer_;
};

/** @brief Returns the seen air of a room that hangs together. */
CellMask
coreOf(const RoomCells& room, const CellMask& opaque)
{
  const CellMask open = subtract(closed(room.seen, 1.5), opaque);
  const CellMask core = largestRegion(eroded(open, core_depth));
  CellMask near = core;
  for (int k = 0; k < 2 * core_depth; ++k)
    near = intersect(dilated(near, 1), open);
  return intersect(near, room.seen);
}

} // namespace

void
addCells(const CellMask& mask, CellMask& sum)
{
  const CellBox shared = overlapOf(sum.box(), mask.box());
  for (int y = shared.low.y; y <= shared.high.y; ++y)
    for (int x = shared.low.x; x <= shared.high.x; ++x)
      if (mask.at({x, y}))
        sum.set({x, y}, 1);
}

std::vector<RoomRegion>
roomRegions(const std::vector<RoomCells>& rooms,
            const std::vector<Storey>& storeys,
            const CellGrid& grid,
            const RegionEnergy& energy,
            unsigned threads)
{
  const std::size_t n = rooms.size();
  std::vector<std::size_t> storey_of(n, 0);
  std::vector<std::uint8_t> is_used(n, 0);
  for (std::size_t s = 0; s < storeys.size(); ++s)
    for (const std::size_t r : storeys[s].rooms) {
      storey_of[r] = s;
      is_used[r] = 1;
    }
  std::vector<std::vector<std::size_t>> beside(n); // share heights and places
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b)
      if (is_used[a] && is_used[b] &&
          (a == b || (overlapOf(rooms[a].seen.box(), rooms[b].seen.box()).count() > 0 &&
                      rooms[b].besideRoom(rooms[a], rooms[b].seen).count() > 0)))
        beside[a].push_back(b);
  // Cells of room q where it is beside room r.
  const auto at = [&](std::size_t r, std::size_t q, const CellMask& cells) {
    return q == r ? cells : rooms[q].besideRoom(rooms[r], cells);
  };
  std::vector<Surroundings> around(n);
  std::vector<CellMask> cores(n);
  parallelBlocks(n, 1, threads, [&](std::size_t r, std::size_t) {
    if (!is_used[r])
      return;
    around[r].opaque = CellMask(rooms[r].seen.box());
    for (const std::size_t q : beside[r])
      addCells(at(r, q, subtract(rooms[q].solid, rooms[q].glass)), around[r].opaque);
    cores[r] = coreOf(rooms[r], around[r].opaque);
  });
  std::vector<RoomRegion> regions(n);
  const auto cut = [&](std::size_t r) {
    Surroundings& own = around[r];
    const CellBox& box = rooms[r].seen.box();
    own.air = own.others = CellMask(box);
    CellMask glassy(box);
    for (const std::size_t q : beside[r]) {
      addCells(at(r, q, rooms[q].seen), own.air);
      addCells(at(r, q, rooms[q].glass), glassy);
      if (q != r)
        addCells(at(r, q, cores[q]), own.others);
    }
    own.others = subtract(own.others, rooms[r].seen);
    for (auto& factor : own.factor)
      factor.assign(own.opaque.values().size(), 1);
    markCells(subtract(glassy, own.opaque), energy.glass, own.factor);
    markCells(closed(own.opaque, 1.5), energy.line, own.factor);
    markCells(closed(subtract(rooms[r].solid, rooms[r].glass), 1.5), 0, own.factor);
    RevealSearch behind(rooms[r], own, grid, energy);
    const Storey& storey = storeys[storey_of[r]];
    for (const WallLine& line : storey.lines) {
      markLine(line, r, grid, energy.line, own.opaque, own.factor);
      behind.lookBehind(line);
    }
    for (const WallLine& line : storey.lintels) {
      markLine(line, r, grid, energy.glass, own.opaque, own.factor);
      behind.lookBehind(line);
    }
    // A surface up to a lower ceiling is a column, or a leaf behind a line.
    const CellMask columns =
        subtract(rooms[r].pillar, dilated(behind.found().reveal, 2));
    own.opaque = unite(own.opaque, columns);
    markCells(closed(columns, 1.5), 0, own.factor);
    for (const std::size_t q : beside[r]) // what other rooms have already
      if (q < r && regions[q].cells.count() > 0)
        addCells(at(r, q, regions[q].cells), own.others);
    regions[r] = RegionCut(rooms[r], own, behind.found(), grid, energy).region();
    regions[r].beyond = subtract(unite(behind.found().reveal, behind.found().back),
                                 dilated(regions[r].cells, 1));
    own = {};
  };
  // A room waits for those before it that lie beside it.
  std::vector<std::size_t> turn(n, 0);
  std::size_t turns = 0;
  for (std::size_t r = 0; r < n; ++r) {
    for (const std::size_t q : beside[r])
      if (q < r)
        turn[r] = std::max(turn[r], turn[q] + 1);
    turns = std::max(turns, turn[r] + 1);
  }
  for (std::size_t t = 0; t < turns; ++t) {
    std::vector<std::size_t> now;
    for (std::size_t r = 0; r < n; ++r)
      if (is_used[r] && turn[r] == t)
        now.push_back(r);
    parallelBlocks(now.size(), 1, threads,
                   [&](std::size_t k, std::size_t) { cut(now[k]); });
  }
  return regions;
}

} // namespace pcl::sedr
