// SPDX-License-Identifier: BSD-3-Clause
#include "room_cells.h"

#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/grids/place_table.h"

#include <algorithm>
#include <cmath>

namespace pcl::sedr {

namespace {

/** @brief Metres below the ceiling where the frame of a pane ends. */
constexpr double frame = 0.2;

/** @brief Hits of the scan in the cells of a room. */
struct CellHits {
  std::vector<float> wall;    ///< in the band below the ceiling
  std::vector<float> ceiling; ///< on the ceiling
  CellMask any;               ///< at any height
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
  const CellMask surfaces = unite(room.solid, room.pillar);
  std::vector<float> open(hits.ceiling.size());
  std::vector<float> on_open(hits.ceiling.size());
  for (std::size_t i = 0; i < open.size(); ++i) {
    open[i] = room.seen.values()[i] && !surfaces.values()[i] ? 1.0f : 0.0f;
    on_open[i] = open[i] * hits.ceiling[i];
  }
  const std::vector<float> cells_before = boxSums(room.seen, 7, open);
  const std::vector<float> hits_before = boxSums(room.seen, 7, on_open);
  // A wall crosses a square of 5 cells in some 5 cells: hits a square metre of it.
  const double wall_area = 5 * size * (p.band - frame);
  const int reach = static_cast<int>(std::lround(p.pane_neighbours / size));
  std::vector<float> near;
  for (std::size_t i = 0; i < surfaces.values().size(); ++i) {
    if (!surfaces.values()[i])
      continue;
    const Cell cell = surfaces.cellAt(i);
    near.assign(1, of_wall[i]);
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx)
        if (const Cell c{cell.x + dx, cell.y + dy};
            (dx != 0 || dy != 0) && dx * dx + dy * dy <= reach * reach &&
            room.solid.at(c))
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
  // Behind the sides of a column that few rays meet it is dark, behind a pane it is
  // not.
  const CellMask dark =
      subtract(enclosedCells(unite(room.seen, surfaces)), dilated(hits.any, 1));
  room.glass = subtract(room.glass, dilated(dark, 3));
  room.pillar = subtract(room.pillar, room.glass);
}

} // namespace

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

void
findGlass(const PointView& scan,
          const std::vector<int>& indices,
          const WallSlopes& slopes,
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
    hits[r].any = rooms[r].glass;
    if (rooms[r].seen.count() > 0)
      rooms_near.addIn(
          {grid.centre(rooms[r].seen.box().low), grid.centre(rooms[r].seen.box().high)},
          static_cast<std::uint32_t>(r));
  }
  rooms_near.finish();
  std::vector<CellMask> near(rooms.size());
  parallelBlocks(rooms.size(), 1, threads, [&](std::size_t r, std::size_t) {
    if (rooms[r].seen.count() > 0)
      near[r] = dilated(unite(rooms[r].solid, rooms[r].pillar), 8);
  });
  const std::size_t count = indices.empty() ? scan.size() : indices.size();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = indices.empty() ? k : static_cast<std::size_t>(indices[k]);
    const Eigen::Vector3f q = scan[i];
    if (!q.allFinite() || !grid.holds(q.x(), q.y()))
      continue;
    const Eigen::Vector3d p = q.cast<double>();
    for (const std::uint32_t r : rooms_near.at(p.head<2>())) {
      const Eigen::Vector2d place = placeInPlan(p, slopes, grid, rooms[r]);
      const Cell cell = grid.at(place.x(), place.y());
      if (!near[r].at(cell))
        continue;
      const std::size_t at = near[r].indexOf(cell);
      hits[r].any.values()[at] = 1;
      const RoomCells& room = rooms[r];
      const double below = (room.pillar.values()[at] ? room.low : room.top)[at] - q.z();
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
