// SPDX-License-Identifier: BSD-3-Clause
#include "room_cells.h"

#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/quantiles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr float no_height = std::numeric_limits<float>::infinity();

double
medianHeight(const PointView& points, const std::vector<int>& indices, double otherwise)
{
  std::vector<double> z;
  z.reserve(indices.size());
  for (const int i : indices)
    if (points.isFinite(static_cast<std::size_t>(i)))
      z.push_back(static_cast<double>(points[static_cast<std::size_t>(i)].z()));
  return z.empty() ? otherwise : middleValue(std::move(z));
}

/** @brief Replaces each value by the first in an order of all within `reach` cells
 * along x, then y. */
template <typename Before>
void
spread(const CellMask& frame, int reach, Before before, std::vector<float>& values)
{
  const int width = frame.width();
  const int height = frame.height();
  const auto along = [&](int lines, int length, std::size_t line, std::size_t step) {
    std::vector<float> row(static_cast<std::size_t>(length));
    for (int l = 0; l < lines; ++l) {
      float* const first = values.data() + static_cast<std::size_t>(l) * line;
      for (int k = 0; k < length; ++k) {
        float best = first[static_cast<std::size_t>(k) * step];
        for (int j = std::max(0, k - reach); j <= std::min(length - 1, k + reach); ++j)
          if (const float z = first[static_cast<std::size_t>(j) * step];
              before(z, best))
            best = z;
        row[static_cast<std::size_t>(k)] = best;
      }
      for (int k = 0; k < length; ++k)
        first[static_cast<std::size_t>(k) * step] = row[static_cast<std::size_t>(k)];
    }
  };
  along(height, width, static_cast<std::size_t>(width), 1);
  along(width, height, 1, static_cast<std::size_t>(width));
}

/** @brief Calls `see(index of the cell, point)` for the points in the frame, moved by
 * `place`. */
template <typename See, typename Place>
void
forEachIn(const CellMask& frame,
          const CellGrid& grid,
          const PointView& points,
          const std::vector<int>& indices,
          See see,
          Place place)
{
  for (const int i : indices) {
    const Eigen::Vector3f p = place(points[static_cast<std::size_t>(i)]);
    if (!std::isfinite(p.z()) || !grid.holds(p.x(), p.y()))
      continue;
    const Cell cell = grid.at(p.x(), p.y());
    if (frame.isInside(cell))
      see(frame.indexOf(cell), p);
  }
}

Eigen::Vector3f
asScanned(const Eigen::Vector3f& p)
{
  return p;
}

/** @brief Lowest and highest point of the ceiling in each cell. */
struct CeilingEnds {
  std::vector<float> low;
  std::vector<float> high;
};

/** @brief Sets what is known of the ceiling. */
CeilingEnds
gatherCeiling(const PointView& points,
              const RoomPoints& room,
              const CellGrid& grid,
              const RoomCellsParameters& p,
              RoomCells& cells)
{
  constexpr double above_floor = 0.3; // metres: what is lower is no ceiling
  cells.ceiling = medianHeight(points, room.ceiling,
                               room.hidden.empty() ? 0 : room.hidden.front().z());
  cells.floor = medianHeight(points, room.floor, cells.ceiling - usual_height);
  std::vector<int> high;
  for (const int i : room.ceiling)
    if (points[static_cast<std::size_t>(i)].z() > cells.floor + above_floor)
      high.push_back(i);
  const CellSet seen = unite(CellSet(grid, points, high), cellsOf(grid, room.hidden));
  if (seen.empty())
    return {};
  const CellBox box =
      grown(boxOf(seen), static_cast<int>(std::lround(p.margin / grid.size())));
  cells.seen = CellMask(seen, box);
  cells.top.assign(cells.seen.values().size(), -no_height);
  cells.low.assign(cells.seen.values().size(), no_height);
  const auto add = [&](std::size_t at, const Eigen::Vector3f& q) {
    cells.top[at] = std::max(cells.top[at], q.z());
    cells.low[at] = std::min(cells.low[at], q.z());
  };
  forEachIn(cells.seen, grid, points, high, add, asScanned);
  CeilingEnds ends{cells.low, cells.top};
  for (const Eigen::Vector3f& q : room.hidden)
    add(cells.seen.indexOf(grid.at(q.x(), q.y())), q);
  const int reach = static_cast<int>(std::lround(p.local / grid.size()));
  cells.bottom.assign(cells.top.size(), -no_height);
  forEachIn(
      cells.seen, grid, points, room.floor,
      [&](std::size_t at, const Eigen::Vector3f& q) {
        cells.bottom[at] = std::max(cells.bottom[at], q.z());
      },
      asScanned);
  spread(cells.seen, reach, std::greater<>(), cells.bottom);
  for (float& z : cells.bottom)
    z = z == -no_height ? static_cast<float>(cells.floor) : z;
  spread(cells.seen, reach, std::greater<>(), cells.top);
  spread(cells.seen, 1, std::less<>(), cells.low);
  for (std::size_t i = 0; i < cells.top.size(); ++i)
    if (cells.low[i] == no_height)
      cells.top[i] = cells.low[i] = static_cast<float>(cells.ceiling);
  return ends;
}

/** @brief Finds the surfaces that reach up to the ceiling. */
void
gatherWalls(const PointView& points,
            const RoomPoints& room,
            const WallSlopes& slopes,
            const CellGrid& grid,
            const RoomCellsParameters& p,
            const CeilingEnds& ends,
            RoomCells& cells)
{
  const std::size_t count = cells.seen.values().size();
  const auto lowest = [&](float ceiling) {
    return std::max(ceiling - p.band, cells.floor + (ceiling - cells.floor) / 2);
  };
  const auto binBelow = [&](float ceiling, float z) {
    return 1u << std::min(7, static_cast<int>((ceiling - z) / p.bin));
  };
  std::vector<std::uint8_t> bins(count, 0);
  std::vector<std::uint8_t> bins_of_low(count, 0);
  std::vector<std::uint64_t> bins_of_base(count, 0);
  std::vector<float> highest(count, -no_height);
  std::vector<std::uint8_t> is_wall(count, 0);
  struct Place {
    std::size_t cell;
    Eigen::Vector2d at;
    bool is_wall;
    bool is_top; ///< below the highest ceiling beside it
  };
  std::vector<Place> places;
  std::vector<std::pair<std::size_t, Eigen::Vector2d>> low_places; // below a sill
  const std::vector<float>& low = ends.low;
  const std::vector<float>& high = ends.high;
  std::vector<float> below_top(count, 0);
  std::vector<float> is_own(count, 0);
  for (std::size_t at = 0; at < count; ++at)
    if (low[at] <= high[at]) {
      below_top[at] = cells.top[at] - high[at];
      is_own[at] = 1;
    }
  const int reach = static_cast<int>(std::lround(p.local / grid.size()));
  const std::vector<float> depths = boxSums(cells.seen, reach, below_top);
  const std::vector<float> near = boxSums(cells.seen, reach, is_own);
  const auto maySlope = [&](std::size_t at) {
    return depths[at] > near[at] * p.rim / 2 && high[at] - low[at] < 2 * p.bin;
  };
  // A low lintel goes down from where a level ceiling ends and a lower one begins: of
  // the ceiling around it a third is at its top, of one that slopes a row of cells.
  std::vector<float> is_at_top(count, 0);
  for (std::size_t at = 0; at < count; ++at)
    is_at_top[at] = is_own[at] > 0 && high[at] > cells.top[at] - p.rim / 3 ? 1 : 0;
  const std::vector<float> at_top = boxSums(cells.seen, reach, is_at_top);
  std::vector<Eigen::Vector3d> sums(count, Eigen::Vector3d::Zero()); // of surfaces
  std::vector<float> beside = high;
  spread(cells.seen, 1, std::greater<>(), beside);
  std::vector<double> depth; // of the ceiling about each cell
  for (std::size_t at = 0; at < count; ++at)
    if (is_own[at] > 0)
      depth.push_back(cells.top[at] - cells.low[at]);
  const double uneven = depth.empty() ? 0 : middleValue(std::move(depth));
  const auto isLowLintel = [&](std::size_t at, double z) {
    const double top = cells.top[at] - uneven;
    return beside[at] > top - p.rim / 3 && at_top[at] > near[at] / 3 &&
           cells.low[at] < top - std::max(p.below, grid.size()) &&
           z < top - p.rim / 3 &&
           z > std::max<double>(cells.low[at], top - 2 * p.bin) + p.rim / 3;
  };
  const auto atTop = [&](const Eigen::Vector3f& q) -> Eigen::Vector3f {
    const Eigen::Vector2f place =
        placeInPlan(q.cast<double>(), slopes, grid, cells).cast<float>();
    return {place.x(), place.y(), q.z()};
  };
  const auto gather = [&](const std::vector<int>& indices, bool of_wall, bool below,
                          auto place) {
    forEachIn(
        cells.seen, grid, points, indices,
        [&](std::size_t at, const Eigen::Vector3f& q) {
          if (isLowLintel(at, q.z()))
            sums[at] += q.head<2>().homogeneous().cast<double>();
          const auto isBelow = [&](float ceiling) {
            return q.z() > lowest(ceiling) && q.z() < ceiling - p.rim;
          };
          if (below && (q.z() > cells.top[at] - p.rim || maySlope(at)))
            return;
          if (q.z() < cells.top[at] + p.rim)
            highest[at] = std::max(highest[at], q.z());
          if (const double above = q.z() - cells.floor; above > p.rim) {
            bins_of_base[at] |= std::uint64_t{1}
                                << static_cast<int>(std::min(63.0, above / p.bin));
            if (above < p.sill)
              low_places.emplace_back(at, q.head<2>().cast<double>());
          }
          const bool is_below_low = isBelow(cells.low[at]);
          const bool is_below_top = isBelow(cells.top[at]);
          if (is_below_low)
            bins_of_low[at] |= binBelow(cells.low[at], q.z());
          if (is_below_top)
            bins[at] |= binBelow(cells.top[at], q.z());
          if (!is_below_low && !is_below_top)
            return;
          is_wall[at] = is_wall[at] || of_wall;
          places.push_back({at, q.head<2>().cast<double>(), of_wall, is_below_top});
        },
        place);
  };
  gather(room.walls, true, false, atTop);
  gather(room.others, false, false, atTop);
  // Above what hides a wall up to near the ceiling, its points pass for the ceiling's.
  gather(room.ceiling, true, true, asScanned);
  cells.solid = CellMask(cells.seen.box());
  cells.glass = cells.riser = cells.pillar = cells.base = cells.solid;
  spread(cells.seen, 1, std::greater<>(), highest);
  std::vector<std::uint8_t> is_low(count, 0);
  const CellMask below_ceiling = eroded(dilated(cells.seen, 1), 3);
  const std::uint64_t below_sill =
      (std::uint64_t{1} << static_cast<unsigned>(p.sill / p.bin)) - 1;
  const auto endsBelow = [&](std::size_t i) {
    return below_ceiling.values()[i] && highest[i] < cells.low[i] - p.below;
  };
  for (std::size_t i = 0; i < count; ++i) {
    const int needed = is_wall[i] ? p.filled_of_wall : p.filled;
    const int below_top = __builtin_popcount(bins[i]);
    const int below_low = __builtin_popcount(bins_of_low[i]);
    const bool goes_on = below_low > 1; // one may be a stray
    cells.solid.values()[i] = below_top >= needed && goes_on && !endsBelow(i);
    // A low lintel has no room for more than one bin.
    is_low[i] = cells.top[i] - cells.low[i] < p.filled_of_wall * p.bin;
    cells.riser.values()[i] =
        !goes_on && (below_top >= needed || (is_low[i] && sums[i].z() > 0));
    cells.pillar.values()[i] =
        below_top < needed && below_low >= needed && !endsBelow(i);
    const std::uint64_t above_sill = bins_of_base[i] & ~below_sill;
    const bool is_tall = __builtin_popcountll(above_sill) >= p.filled;
    cells.base.values()[i] =
        __builtin_popcountll(bins_of_base[i] & below_sill) >= p.filled_of_wall &&
        !(is_tall && highest[i] < cells.low[i] - p.below);
  }
  const CellMask near_base = dilated(cells.base, 1);
  const CellMask near_pillar = dilated(cells.pillar, 1);
  const auto isTall = [&](std::size_t i) {
    return cells.solid.values()[i] || (cells.riser.values()[i] && !is_low[i]);
  };
  CellMask tall(cells.seen.box());
  for (std::size_t i = 0; i < count; ++i)
    tall.values()[i] = isTall(i);
  const CellMask near_tall = dilated(tall, 1);
  const CellMask beside_tall = dilated(tall, 3); // of what is wall for certain
  for (std::size_t i = 0; i < count; ++i)
    if (!cells.riser.values()[i] || isTall(i))
      sums[i].setZero();
  const auto shareAt = [&](std::size_t i) {
    std::uint64_t filled = 0;
    const Cell cell = cells.seen.cellAt(i);
    for (std::int32_t dy = -1; dy <= 1; ++dy)
      for (std::int32_t dx = -1; dx <= 1; ++dx)
        if (const Cell beside{cell.x + dx, cell.y + dy}; cells.seen.isInside(beside))
          filled |= bins_of_base[cells.seen.indexOf(beside)];
    const double height =
        cells.top[i] - std::max<double>(cells.bottom[i], cells.floor) - 2 * p.rim;
    const double all = std::max(1.0, height / p.bin);
    const double above = filled >> 63U != 0 ? std::max(0.0, all - 64) : 0; // one bin
    return static_cast<float>(
        std::min(1.0, (__builtin_popcountll(filled) + above) / all));
  };
  for (const Place& place : places) {
    if (endsBelow(place.cell))
      continue;
    if ((!place.is_top   ? near_pillar
         : place.is_wall ? beside_tall
                         : near_tall)
            .values()[place.cell]) {
      cells.wall_points.push_back(place.at);
      cells.wall_shares.push_back(shareAt(place.cell));
    }
    if (place.is_top && isTall(place.cell))
      sums[place.cell] += place.at.homogeneous();
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!(sums[i].z() > 0)) {
      cells.riser.values()[i] = 0;
      continue;
    }
    if (cells.riser.values()[i])
      cells.part_points.emplace_back(sums[i].hnormalized());
    // As good as a wall above a parapet; elsewhere it may be noise of the ceiling.
    if (cells.riser.values()[i] && is_low[i] && near_base.values()[i]) {
      cells.wall_points.insert(cells.wall_points.end(), p.filled,
                               sums[i].hnormalized());
      cells.wall_shares.insert(cells.wall_shares.end(), p.filled, shareAt(i));
    }
  }
  for (const auto& [cell, at] : low_places)
    if (cells.base.values()[cell] && !cells.solid.values()[cell])
      cells.part_points.push_back(at);
}

bool
isShared(double low, double high, double other_low, double other_high)
{
  constexpr double shared = 0.5; // metres
  return std::min(high, other_high) - std::max(low, other_low) > shared;
}

} // namespace

CellSet
cellsOf(const CellGrid& grid, const std::vector<Eigen::Vector3f>& places)
{
  std::vector<CellKey> keys;
  for (const Eigen::Vector3f& p : places)
    keys.push_back(keyOf(grid.at(p.x(), p.y())));
  return CellSet(std::move(keys));
}

bool
RoomCells::sharesHeights(const RoomCells& other) const
{
  return isShared(floor, ceiling, other.floor, other.ceiling);
}

CellMask
RoomCells::besideRoom(const RoomCells& other, const CellMask& cells) const
{
  CellMask beside = cells;
  for (std::size_t i = 0; i < top.size(); ++i) {
    if (!cells.values()[i])
      continue;
    const Cell cell = seen.cellAt(i);
    const bool is_over = other.seen.at(cell) != 0;
    const std::size_t there = is_over ? other.seen.indexOf(cell) : 0;
    beside.values()[i] =
        isShared(bottom[i], low[i], is_over ? other.bottom[there] : other.floor,
                 is_over ? other.low[there] : other.ceiling);
  }
  return beside;
}

std::vector<RoomCells>
roomCells(const PointView& points,
          const std::vector<RoomPoints>& rooms,
          const WallSlopes& slopes,
          const CellGrid& grid,
          const RoomCellsParameters& parameters,
          unsigned threads)
{
  std::vector<RoomCells> cells(rooms.size());
  parallelBlocks(rooms.size(), 1, threads, [&](std::size_t r, std::size_t) {
    const CeilingEnds ends =
        gatherCeiling(points, rooms[r], grid, parameters, cells[r]);
    if (cells[r].seen.count() > 0)
      gatherWalls(points, rooms[r], slopes, grid, parameters, ends, cells[r]);
  });
  return cells;
}

} // namespace pcl::sedr
