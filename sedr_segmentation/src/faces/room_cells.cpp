// SPDX-License-Identifier: BSD-3-Clause
#include "room_cells.h"

#include "sedr_filters/src/base/middle_value.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/grids/place_table.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr float no_height = std::numeric_limits<float>::infinity();

/** @brief Metres below the ceiling where the frame of a pane ends. */
constexpr double frame = 0.2;

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

/** @brief Calls `see(index of the cell, point)` for the points in the frame. */
template <typename See>
void
forEachIn(const CellMask& frame,
          const CellGrid& grid,
          const PointView& points,
          const std::vector<int>& indices,
          See see)
{
  for (const int i : indices) {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    if (!std::isfinite(p.z()) || !grid.holds(p.x(), p.y()))
      continue;
    const Cell cell = grid.at(p.x(), p.y());
    if (frame.isInside(cell))
      see(frame.indexOf(cell), p);
  }
}

/** @brief Sets what is known of the ceiling. */
void
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
    return;
  const CellBox box =
      grown(boxOf(seen), static_cast<int>(std::lround(p.margin / grid.size())));
  cells.seen = CellMask(seen, box);
  cells.top.assign(cells.seen.values().size(), -no_height);
  cells.low.assign(cells.seen.values().size(), no_height);
  const auto add = [&](std::size_t at, const Eigen::Vector3f& q) {
    cells.top[at] = std::max(cells.top[at], q.z());
    cells.low[at] = std::min(cells.low[at], q.z());
  };
  forEachIn(cells.seen, grid, points, high, add);
  for (const Eigen::Vector3f& q : room.hidden)
    add(cells.seen.indexOf(grid.at(q.x(), q.y())), q);
  const int reach = static_cast<int>(std::lround(p.local / grid.size()));
  spread(cells.seen, reach, std::greater<>(), cells.top);
  spread(cells.seen, 1, std::less<>(), cells.low);
  for (std::size_t i = 0; i < cells.top.size(); ++i)
    if (cells.low[i] == no_height)
      cells.top[i] = cells.low[i] = static_cast<float>(cells.ceiling);
}

/** @brief Returns the sums of a raster over squares of 2 reach + 1 cells. */
std::vector<float>
boxSums(const CellMask& frame, int reach, const std::vector<float>& values)
{
  const auto width = static_cast<std::size_t>(frame.width());
  const auto height = static_cast<std::size_t>(frame.height());
  std::vector<double> table((width + 1) * (height + 1), 0);
  for (std::size_t y = 0; y < height; ++y) {
    double row = 0;
    for (std::size_t x = 0; x < width; ++x) {
      row += values[y * width + x];
      table[(y + 1) * (width + 1) + x + 1] = table[y * (width + 1) + x + 1] + row;
    }
  }
  std::vector<float> sums(values.size());
  const auto r = static_cast<std::size_t>(reach);
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t left = x < r ? 0 : x - r;
      const std::size_t low = y < r ? 0 : y - r;
      const std::size_t right = std::min(width, x + r + 1);
      const std::size_t high = std::min(height, y + r + 1);
      sums[y * width + x] = static_cast<float>(
          table[high * (width + 1) + right] - table[low * (width + 1) + right] -
          table[high * (width + 1) + left] + table[low * (width + 1) + left]);
    }
  return sums;
}

/** @brief Finds the surfaces that reach up to the ceiling. */
void
gatherWalls(const PointView& points,
            const RoomPoints& room,
            const CellGrid& grid,
            const RoomCellsParameters& p,
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
  std::vector<float> low(count, no_height); // of the ceiling's points in each cell
  std::vector<float> high(count, -no_height);
  forEachIn(cells.seen, grid, points, room.ceiling,
            [&](std::size_t at, const Eigen::Vector3f& q) {
              low[at] = std::min(low[at], q.z());
              high[at] = std::max(high[at], q.z());
            });
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
  const auto gather = [&](const std::vector<int>& indices, bool of_wall, bool below) {
    forEachIn(
        cells.seen, grid, points, indices,
        [&](std::size_t at, const Eigen::Vector3f& q) {
          const auto isBelow = [&](float ceiling) {
            return q.z() > lowest(ceiling) && q.z() < ceiling - p.rim;
          };
          if (below && (q.z() > cells.top[at] - p.rim || maySlope(at)))
            return;
          if (q.z() < cells.top[at] + p.rim)
            highest[at] = std::max(highest[at], q.z());
          if (const double above = q.z() - cells.floor; above > p.rim)
            bins_of_base[at] |= std::uint64_t{1}
                                << static_cast<int>(std::min(63.0, above / p.bin));
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
        });
  };
  gather(room.walls, true, false);
  gather(room.others, false, false);
  // Above what hides a wall up to near the ceiling, its points pass for the ceiling's.
  gather(room.ceiling, true, true);
  cells.solid = CellMask(cells.seen.box());
  cells.glass = cells.riser = cells.pillar = cells.base = cells.solid;
  spread(cells.seen, 1, std::greater<>(), highest);
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
    cells.riser.values()[i] = below_top >= needed && !goes_on;
    cells.pillar.values()[i] =
        below_top < needed && below_low >= needed && !endsBelow(i);
    const std::uint64_t above_sill = bins_of_base[i] & ~below_sill;
    const bool is_tall = __builtin_popcountll(above_sill) >= p.filled;
    cells.base.values()[i] =
        __builtin_popcountll(bins_of_base[i] & below_sill) >= p.filled_of_wall &&
        !(is_tall && highest[i] < cells.low[i] - p.below);
  }
  const CellMask near_solid = dilated(cells.solid, 1);
  const CellMask near_pillar = dilated(cells.pillar, 1);
  std::vector<std::size_t> number(count, 0);
  std::size_t solids = 0;
  for (std::size_t i = 0; i < count; ++i)
    if (cells.solid.values()[i])
      number[i] = solids++;
  cells.centres.assign(solids, Eigen::Vector2d::Zero());
  std::vector<double> counts(solids, 0);
  for (const Place& place : places) {
    if (endsBelow(place.cell))
      continue;
    if (place.is_top ? place.is_wall || near_solid.values()[place.cell]
                     : near_pillar.values()[place.cell] != 0)
      cells.wall_points.push_back(place.at);
    if (place.is_top && cells.solid.values()[place.cell]) {
      cells.centres[number[place.cell]] += place.at;
      ++counts[number[place.cell]];
    }
  }
  for (std::size_t k = 0; k < solids; ++k)
    cells.centres[k] /= counts[k];
}

/** @brief Hits of the scan in the cells of a room. */
struct CellHits {
  std::vector<float> wall;    ///< in the band below the ceiling
  std::vector<float> ceiling; ///< on the ceiling
};

/** @brief Marks the glass of a room from the hits in its cells. */
void
markGlass(const CellHits& hits,
          const CellGrid& grid,
          const RoomCellsParameters& p,
          RoomCells& room)
{
  constexpr double usual = 0.8; // of the walls near: this quantile of their hits
  const double size = grid.size();
  const std::vector<float> of_wall = boxSums(room.seen, 2, hits.wall);
  std::vector<float> open(hits.ceiling.size());
  std::vector<float> on_open(hits.ceiling.size());
  for (std::size_t i = 0; i < open.size(); ++i) {
    open[i] = room.seen.values()[i] && !room.solid.values()[i] ? 1.0f : 0.0f;
    on_open[i] = open[i] * hits.ceiling[i];
  }
  const std::vector<float> cells_before = boxSums(room.seen, 7, open);
  const std::vector<float> hits_before = boxSums(room.seen, 7, on_open);
  // A wall crosses a square of 5 cells in some 5 cells: hits a square metre of it.
  const double wall_area = 5 * size * (p.band - frame);
  std::vector<std::size_t> solids;
  for (std::size_t i = 0; i < room.solid.values().size(); ++i)
    if (room.solid.values()[i])
      solids.push_back(i);
  const int reach = static_cast<int>(std::lround(p.pane_neighbours / size));
  std::vector<float> near;
  for (const std::size_t i : solids) {
    const Cell cell = room.solid.cellAt(i);
    near.clear();
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx)
        if (const Cell c{cell.x + dx, cell.y + dy};
            dx * dx + dy * dy <= reach * reach && room.solid.at(c))
          near.push_back(of_wall[room.solid.indexOf(c)]);
    const auto rank = near.begin() + static_cast<std::ptrdiff_t>(
                                         usual * static_cast<double>(near.size() - 1));
    std::nth_element(near.begin(), rank, near.end());
    const double density = of_wall[i] / wall_area;
    const double before =
        cells_before[i] > 0 ? hits_before[i] / (cells_before[i] * size * size) : 0;
    room.glass.values()[i] =
        density < p.few_hits * (*rank / wall_area) || density < p.few_hits * before;
  }
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
  constexpr double shared = 0.5; // metres
  return std::min(ceiling, other.ceiling) - std::max(floor, other.floor) > shared;
}

std::vector<RoomCells>
roomCells(const PointView& points,
          const std::vector<RoomPoints>& rooms,
          const CellGrid& grid,
          const RoomCellsParameters& parameters,
          unsigned threads)
{
  std::vector<RoomCells> cells(rooms.size());
  parallelBlocks(rooms.size(), 1, threads, [&](std::size_t r, std::size_t) {
    gatherCeiling(points, rooms[r], grid, parameters, cells[r]);
    if (cells[r].seen.count() > 0)
      gatherWalls(points, rooms[r], grid, parameters, cells[r]);
  });
  return cells;
}

void
findGlass(const PointView& scan,
          const std::vector<int>& indices,
          const CellGrid& grid,
          const RoomCellsParameters& parameters,
          unsigned threads,
          std::vector<RoomCells>& rooms)
{
  constexpr double on_ceiling = 0.15; // metres
  std::vector<CellHits> hits(rooms.size());
  PlaceTable rooms_near(2); // metres
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    hits[r].wall.assign(rooms[r].seen.values().size(), 0);
    hits[r].ceiling = hits[r].wall;
    if (rooms[r].seen.count() > 0)
      rooms_near.addIn(
          {grid.centre(rooms[r].seen.box().low), grid.centre(rooms[r].seen.box().high)},
          static_cast<std::uint32_t>(r));
  }
  rooms_near.finish();
  std::vector<CellMask> near(rooms.size());
  parallelBlocks(rooms.size(), 1, threads, [&](std::size_t r, std::size_t) {
    if (rooms[r].seen.count() > 0)
      near[r] = dilated(rooms[r].solid, 8);
  });
  const std::size_t count = indices.empty() ? scan.size() : indices.size();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = indices.empty() ? k : static_cast<std::size_t>(indices[k]);
    const Eigen::Vector3f q = scan[i];
    if (!q.allFinite() || !grid.holds(q.x(), q.y()))
      continue;
    const Cell cell = grid.at(q.x(), q.y());
    for (const std::uint32_t r : rooms_near.at(q.head<2>().cast<double>())) {
      if (!near[r].at(cell))
        continue;
      const std::size_t at = near[r].indexOf(cell);
      const double below = rooms[r].top[at] - q.z();
      if (below > frame && below < parameters.band)
        ++hits[r].wall[at];
      else if (std::abs(below) < on_ceiling)
        ++hits[r].ceiling[at];
    }
  }
  parallelBlocks(rooms.size(), 1, threads, [&](std::size_t r, std::size_t) {
    if (rooms[r].seen.count() > 0)
      markGlass(hits[r], grid, parameters, rooms[r]);
  });
}

} // namespace pcl::sedr
