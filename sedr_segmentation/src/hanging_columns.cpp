// SPDX-License-Identifier: BSD-3-Clause
#include "hanging_columns.h"

#include "strip.h"

#include <pcl/sedr_segmentation/cell_count.h>

#include <algorithm>
#include <cstddef>

namespace pcl {
namespace sedr {

namespace {

/** @brief Where the lower edge of what hangs may be, metres above the floor. */
constexpr double least_edge = 1.1;
constexpr double most_edge = 1.8;

/** @brief Stretches of a column with gaps up to this are one, metres. */
constexpr double gap_in_run = 0.15;

} // namespace

std::optional<ColumnRun>
HangingColumns::frontAt(Cell cell) const
{
  const double floor = room_.floorAt(cell);
  for (const ColumnRun& run : columns_.runs(cell, gap_in_run)) {
    if (run.low > topAt(cell))
      break;
    if (run.high < floor - 0.1) // of a storey below
      continue;
    const double edge = run.low - floor;
    if (run.high - run.low < least_hanging_run) {
      if (edge > 0.1 && run.high - run.low > gap_in_run)
        return {};
      continue;
    }
    if (edge >= least_edge && edge <= most_edge)
      return run;
    return {};
  }
  return {};
}

std::optional<ColumnRun>
HangingColumns::backAt(Cell cell) const
{
  const double floor = room_.floorAt(cell);
  const double top = topAt(cell);
  for (const ColumnRun& run : columns_.runs(cell, gap_in_run)) {
    const double edge = run.high - floor;
    if (run.high - run.low < least_hanging_run || run.high < floor - 0.1)
      continue;
    if (edge < least_edge - least_hanging_run || edge > most_edge + gap_in_run ||
        columns_.share(cell, run.high + gap_in_run, top - 0.1, 6, 0) > 0.2)
      return {};
    return run;
  }
  return {};
}

double
HangingColumns::edgeAround(Cell cell) const
{
  double edge = topAt(cell);
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (const auto front = frontAt({cell.x + dx, cell.y + dy}))
        edge = std::min<double>(edge, front->low);
  return edge;
}

bool
HangingColumns::hasLevelEdges(const std::vector<Cell>& region) const
{
  constexpr double tolerance = 0.05;
  std::vector<double> edges;
  for (const Cell cell : region)
    edges.push_back(edgeAround(cell) - room_.floorAt(cell));
  std::sort(edges.begin(), edges.end());
  const auto least = static_cast<std::ptrdiff_t>(
      std::max(static_cast<std::size_t>(cellsFor(least_hanging_front, grid_.size())),
               region.size() / 5));
  const auto level = std::count_if(edges.begin(), edges.end(), [&](double edge) {
    const auto first = std::lower_bound(edges.begin(), edges.end(), edge - tolerance);
    return std::upper_bound(first, edges.end(), edge + tolerance) - first >= least;
  });
  return 10 * static_cast<std::size_t>(level) >= 9 * region.size();
}

bool
HangingColumns::isHead(const std::vector<Cell>& region) const
{
  CellBox box{region.front(), region.front()};
  for (const Cell cell : region)
    box = around(box, CellBox{cell, cell});
  CellMask cells(box);
  for (const Cell cell : region)
    cells.set(cell, 1);
  const Strip strip = stripOf(cells, grid_);
  if (strip.width > 4 * grid_.size())
    return false;
  return wallGoesOn(strip, grid_, [this](Cell cell) {
    const double floor = room_.floorAt(cell);
    return columns_.share(cell, floor + 0.2, floor + least_edge, 4, 1) >= 0.75;
  });
}

double
HangingColumns::topOf(const std::vector<Cell>& region) const
{
  constexpr double step = 0.01;
  constexpr double gap = 0.06;
  double lowest = topAt(region.front());
  double highest = lowest;
  for (const Cell cell : region)
    lowest = std::min<double>(lowest, frontAt(cell)->low);
  for (double z = lowest + least_hanging_run; z + gap < highest; z += step) {
    std::size_t held = 0;
    for (const Cell cell : region)
      held += columns_.hasWithin(cell, z, z + gap) ? 1 : 0;
    if (10 * held < region.size())
      return z;
  }
  return highest;
}

double
HangingColumns::nextAbove(Cell cell, double z) const
{
  double next = topAt(cell);
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx) {
      const Cell near{cell.x + dx, cell.y + dy};
      const auto* above =
          std::upper_bound(columns_.begin(near), columns_.end(near), z,
                           [](double low, const auto& e) { return low < e.z; });
      if (above != columns_.end(near))
        next = std::min<double>(next, above->z);
    }
  return next;
}

void
HangingColumns::continueUpwards(Cell cell, std::vector<Eigen::Vector3f>& points) const
{
  const std::optional<ColumnRun> run = backAt(cell);
  if (!run)
    return;
  const auto low = static_cast<float>(run->low + 0.05); // above a worktop
  const auto step = static_cast<float>(run->high - low + grid_.size());
  const auto top = static_cast<float>(nextAbove(cell, run->high + 0.35) - 0.02);
  for (const auto* e = columns_.begin(cell); e != columns_.end(cell); ++e) {
    if (e->z < low || e->z > run->high)
      continue;
    Eigen::Vector3f p = points_[static_cast<std::size_t>(e->index)];
    for (p.z() += step; p.z() < top; p.z() += step)
      points.push_back(p);
  }
}

} // namespace sedr
} // namespace pcl
