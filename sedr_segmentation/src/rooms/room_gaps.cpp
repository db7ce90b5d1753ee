// SPDX-License-Identifier: BSD-3-Clause
#include "room_gaps.h"

#include "room_planes.h"

#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/labels.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/grids/cell_mask.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace pcl::sedr {

RoomGaps::RoomGaps(const CellGrid& grid,
                   const std::vector<RoomGap>& gaps,
                   const Priors& priors)
    : grid_(grid)
    , above_(priors.min_headroom / 2)
    , below_(priors.patch)
    , wall_steps_(cellsFor(wallReach(priors), grid.size(), 3))
{
  // As far as openings are looked through for the backs of niches.
  const double niches = priors.max_niche_depth + 2 * priors.run_gap + 0.1;
  for (const RoomGap& gap : gaps) {
    const float low = gap.low < gap.high ? gap.low : gap.lowest;
    if (low < gap.high)
      add(gap.cell, {low, gap.high, gap.lowest, gap.room, 0, -1});
  }
  spread(cellsFor(niches, grid.size(), wall_steps_));
}

std::size_t
RoomGaps::withinTile(Cell cell)
{
  return static_cast<std::size_t>((cell.y & (edge - 1)) * edge + (cell.x & (edge - 1)));
}

const RoomGaps::Tile*
RoomGaps::tileAt(Cell cell) const
{
  const auto tile = tiles_.find(keyOf({cell.x >> 5, cell.y >> 5}));
  return tile == tiles_.end() ? nullptr : &tile->second;
}

template <typename Visit>
void
RoomGaps::forEachSpan(Cell cell, Visit visit) const
{
  if (const Tile* const tile = tileAt(cell))
    for (std::int32_t s = (*tile)[withinTile(cell)]; s >= 0;
         s = spans_[static_cast<std::size_t>(s)].next)
      visit(spans_[static_cast<std::size_t>(s)]);
}

/** @brief Adds a span to a cell, unless half of the lower of it and another one there
 * is at the same heights. */
bool
RoomGaps::add(Cell cell, const Span& span)
{
  bool is_taken = false;
  forEachSpan(cell, [&](const Span& other) {
    const float shared =
        std::min(span.high, other.high) - std::max(span.low, other.low);
    is_taken =
        is_taken || shared > std::min(span.high - span.low, other.high - other.low) / 2;
  });
  if (is_taken)
    return false;
  const auto [tile, is_new] = tiles_.try_emplace(keyOf({cell.x >> 5, cell.y >> 5}));
  if (is_new)
    tile->second.fill(-1);
  std::int32_t& first = tile->second[withinTile(cell)];
  spans_.push_back(span);
  spans_.back().next = first;
  cells_.push_back(cell);
  first = static_cast<std::int32_t>(spans_.size() - 1);
  return true;
}

void
RoomGaps::spread(int steps)
{
  for (std::size_t begin = 0; steps > 0 && begin < spans_.size(); --steps) {
    const std::size_t end = spans_.size();
    for (std::size_t s = begin; s < end; ++s)
      for (const Cell by : {Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}}) {
        Span span = spans_[s];
        ++span.steps;
        add({cells_[s].x + by.x, cells_[s].y + by.y}, span);
      }
    begin = end;
  }
}

PointOwner
RoomGaps::ownerOf(const Eigen::Vector3f& p) const
{
  constexpr int near = 2; // cells: a thin partition
  if (!std::isfinite(p.z()) || !grid_.holds(p.x(), p.y()))
    return {};
  const Cell cell = grid_.at(p.x(), p.y());
  const Eigen::Vector2d at = p.head<2>().cast<double>();
  PointOwner owner;
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](const Span& span, double beside) {
    const double above = p.z() - span.high;
    const double below = span.low - p.z();
    if (above > above_ || span.lowest - p.z() > below_)
      return;
    const double away = std::max({0.0, above, below});
    const double square = beside * beside + away * away;
    if (square < least || (square == least && span.room < owner.room)) {
      least = square;
      owner = {span.room, static_cast<int>(span.steps) > wall_steps_};
    }
  };
  forEachSpan(cell, [&](const Span& span) {
    if (span.steps == 0)
      consider(span, 0);
  });
  if (least == 0)
    return owner;
  for (int y = cell.y - near; y <= cell.y + near; ++y)
    for (int x = cell.x - near; x <= cell.x + near; ++x)
      if (x != cell.x || y != cell.y)
        forEachSpan({x, y}, [&](const Span& span) {
          if (span.steps == 0)
            consider(span, (grid_.centre({x, y}) - at).norm());
        });
  if (owner.room == 0)
    forEachSpan(cell,
                [&](const Span& span) { consider(span, span.steps * grid_.size()); });
  return owner;
}

std::vector<PointOwner>
RoomGaps::ownersOf(const PointView& points, unsigned threads) const
{
  std::vector<PointOwner> owners(points.size());
  parallelFor(points.size(), points_a_block, threads,
              [&](std::size_t i) { owners[i] = ownerOf(points[i]); });
  return owners;
}

namespace {

/** @brief Returns the height of the floor of a room by its profiles. Beside a wall
 * there are none: as at that which is nearest. */
float
floorAt(const std::unordered_map<CellKey, float>& floors,
        const CellGrid& grid,
        const Eigen::Vector2d& at,
        double usual)
{
  const Cell middle = grid.at(at.x(), at.y());
  const auto here = floors.find(keyOf(middle));
  if (here != floors.end())
    return here->second;
  auto floor = static_cast<float>(usual);
  double nearest = std::numeric_limits<double>::infinity();
  for (int y = middle.y - 1; y <= middle.y + 1; ++y)
    for (int x = middle.x - 1; x <= middle.x + 1; ++x)
      if (const auto beside = floors.find(keyOf({x, y})); beside != floors.end())
        if (const double off = (grid.centre({x, y}) - at).norm(); off < nearest) {
          nearest = off;
          floor = beside->second;
        }
  return floor;
}

} // namespace

std::vector<RoomGap>
gapsOf(const Building& building, const PointView& points, const CellGrid& grid)
{
  std::vector<std::map<CellKey, float>> tops(building.rooms.size());
  for (std::size_t i = 0; i < building.room_of.size(); ++i)
    if (building.room_of[i] != 0 &&
        building.label_of[i] == valueOf(StructureLabel::Ceiling)) {
      const Eigen::Vector3f p = points[i];
      float& top = tops[building.room_of[i] - 1]
                       .try_emplace(keyOf(grid.at(p.x(), p.y())), p.z())
                       .first->second;
      top = std::max(top, p.z());
    }
  std::vector<RoomGap> gaps;
  for (std::size_t r = 0; r < building.rooms.size(); ++r) {
    const BuildingRoom& room = building.rooms[r];
    std::unordered_map<CellKey, float> floors;
    for (const RoomColumn& column : room.columns) {
      floors[keyOf(column.cell)] = column.floor;
      for (const Eigen::Vector2d& place : partsOf(column.cell, building.grid, grid))
        tops[r].try_emplace(keyOf(grid.at(place.x(), place.y())), column.ceiling);
    }
    for (const auto& [key, top] : tops[r]) {
      const Cell cell = cellOf(key);
      const float low = floorAt(floors, building.grid, grid.centre(cell), room.floor);
      gaps.push_back(
          {cell, room.id, low, top, std::min(low, static_cast<float>(room.floor))});
    }
  }
  return gaps;
}

} // namespace pcl::sedr
