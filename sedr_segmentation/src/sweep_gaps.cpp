// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/sweep_gaps.h>

#include <pcl/sedr_segmentation/box_clusters.h>
#include <pcl/sedr_segmentation/cell_count.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl {
namespace sedr {

namespace {

constexpr double widest_gap = 0.6; ///< between two lines of a sweep, metres
constexpr int line_width = 3;      ///< cells of a line across, at most
constexpr int least_region = 4;    ///< cells of a part of a line

/** @brief How near the ceiling what stands or hangs in a gap is looked for, metres. */
constexpr double reach = 0.6;

/** @brief As far from it there is noise of the ceiling itself, metres. */
constexpr double noise = 0.08;

class GapFinder {
public:
  GapFinder(const Level& ceiling,
            const CellBox& box,
            double cell_size,
            const PointView& points,
            const std::vector<int>& indices)
      : ceiling_(ceiling)
      , grid_(cell_size)
      , points_(points)
      , indices_(indices)
      , seen_(ceiling.cells, box)
      , ways_(box)
      , most_(cellsFor(widest_gap, cell_size))
  {}

  /** @brief The gaps that are such in two of the four directions: past the corner of a
   * column whose back was not seen there is a way in one of them. */
  CellMask find()
  {
    for (const Cell way : {Cell{1, 0}, Cell{0, 1}, Cell{1, 1}, Cell{-1, 1}})
      scanAll(way);
    CellMask gaps(seen_.box());
    for (std::size_t i = 0; i < gaps.values().size(); ++i)
      gaps.values()[i] = ways_.values()[i] >= 2 ? 1 : 0;
    return gaps;
  }

private:
  /** @brief Goes along all rows, columns or diagonals. */
  void scanAll(Cell way)
  {
    const Cell low = seen_.box().low;
    const Cell high = seen_.box().high;
    const std::int32_t first = way.x < 0 ? high.x : low.x;
    if (way.x != 0)
      for (std::int32_t y = low.y; y <= high.y; ++y)
        scan({first, y}, way);
    if (way.y != 0)
      for (std::int32_t x = low.x; x <= high.x; ++x)
        if (way.x == 0 || x != first)
          scan({x, low.y}, way);
  }

  /** @brief Goes along a row, a column or a diagonal and fills the gaps between a line
   * of the sweep and what is on either side of it. */
  void scan(Cell start, Cell way)
  {
    int before = 0; // cells of the ceiling before the gap, none yet
    int gap = 0;
    int run = 0;
    const auto close = [&](Cell end) { // the first cell behind `run`
      if (before > 0 && gap > 0 && gap <= most_ && std::min(before, run) <= line_width)
        fill(end, way, run, gap);
      before = run;
    };
    Cell cell = start;
    for (; seen_.isInside(cell); cell = {cell.x + way.x, cell.y + way.y}) {
      if (seen_.at(cell)) {
        ++run;
        continue;
      }
      if (run > 0) {
        close(cell);
        run = gap = 0;
      }
      ++gap;
    }
    if (run > 0)
      close(cell);
  }

  /** @brief Counts the way for the cells of a gap, unless something is in it.
   * @param end the first cell behind the `run` of the ceiling that follows the gap */
  void fill(Cell end, Cell way, int run, int gap)
  {
    const auto at = [&](int back) {
      return Cell{end.x - back * way.x, end.y - back * way.y};
    };
    for (int k = run + 1; k <= run + gap; ++k)
      if (isTaken(at(k)))
        return;
    for (int k = run + 1; k <= run + gap; ++k)
      ++ways_.values()[ways_.indexOf(at(k))];
  }

  /** @brief Whether anything was seen just below or above the ceiling in the cell or
   * one of its neighbours: a wall along which the scanner looks is as sparse. */
  bool isTaken(Cell cell)
  {
    if (taken_.values().empty())
      taken_ = takenCells();
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if (taken_.at({cell.x + dx, cell.y + dy}))
          return true;
    return false;
  }

  CellMask takenCells() const
  {
    CellMask taken(seen_.box());
    for (const int i : indices_) {
      const Eigen::Vector3f p = points_[static_cast<std::size_t>(i)];
      if (!std::isfinite(p.z()) || !grid_.holds(p.x(), p.y()))
        continue;
      const double off =
          std::abs(p.z() - ceiling_.slab.heightAt(p.head<2>().cast<double>()));
      const Cell cell = grid_.at(p.x(), p.y());
      if (off > noise && off < reach && taken.isInside(cell))
        taken.set(cell, 1);
    }
    return taken;
  }

  const Level& ceiling_;
  const CellGrid grid_;
  const PointView& points_;
  const std::vector<int>& indices_;
  const CellMask seen_;
  CellMask ways_; ///< in how many directions a cell is in a gap
  const int most_;
  CellMask taken_; ///< empty until it is asked for: few ceilings need it
};

} // namespace

CellSet
sweepGaps(const Level& ceiling,
          double cell_size,
          const PointView& points,
          const std::vector<int>& indices)
{
  std::vector<CellBox> boxes;
  for (const CellSet& region : connectedRegions(ceiling.cells))
    if (region.size() >= least_region)
      boxes.push_back(boxOf(region));
  std::vector<CellKey> gaps;
  for (const CellBox& box : clusterBoxes(boxes, cellsFor(widest_gap, cell_size)))
    if (maskProblem(box).empty()) {
      const CellSet found =
          GapFinder(ceiling, box, cell_size, points, indices).find().toSet();
      gaps.insert(gaps.end(), found.keys().begin(), found.keys().end());
    }
  return CellSet(std::move(gaps));
}

} // namespace sedr
} // namespace pcl
