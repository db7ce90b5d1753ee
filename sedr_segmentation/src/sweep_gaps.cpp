// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sedr_segmentation/sweep_gaps.h>

#include <pcl/sedr_segmentation/box_clusters.h>
#include <pcl/sedr_segmentation/cell_count.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl {
namespace sedr {

namespace {

constexpr double widest_gap = 0.6;  ///< between two lines of a sweep, metres
constexpr double line_width = 0.15; ///< at most, metres
constexpr double least_line = 0.4;  ///< of the part of a line that is seen, metres

/** @brief How near the ceiling what stands or hangs in a gap is looked for, metres. */
constexpr double reach = 0.6;

/** @brief As far from it there is noise of the ceiling itself, metres. */
constexpr double noise = 0.08;

/** @brief Empty cells that follow one another in a row, a column or a diagonal. */
struct Gap {
  Cell first;
  Cell way; ///< to the next one
  int length = 0;

  Cell at(int k) const { return {first.x + k * way.x, first.y + k * way.y}; }
};

/** @brief Finds the gaps between a line and what is on either side of it. */
class GapFinder {
public:
  /** @param widest gap, and
   * @param line widest line, in cells */
  GapFinder(CellMask seen, int widest, int line)
      : seen_(std::move(seen))
      , widest_(widest)
      , line_(line)
  {}

  void find(std::vector<Gap>& gaps) const
  {
    for (const Cell way : {Cell{1, 0}, Cell{0, 1}, Cell{1, 1}, Cell{-1, 1}})
      scanAll(way, gaps);
  }

private:
  /** @brief Goes along all rows, columns or diagonals. */
  void scanAll(Cell way, std::vector<Gap>& gaps) const
  {
    const Cell low = seen_.box().low;
    const Cell high = seen_.box().high;
    const std::int32_t first = way.x < 0 ? high.x : low.x;
    if (way.x != 0)
      for (std::int32_t y = low.y; y <= high.y; ++y)
        scan({first, y}, way, gaps);
    if (way.y != 0)
      for (std::int32_t x = low.x; x <= high.x; ++x)
        if (way.x == 0 || x != first)
          scan({x, low.y}, way, gaps);
  }

  void scan(Cell start, Cell way, std::vector<Gap>& gaps) const
  {
    int before = 0; // cells of the ceiling before the gap, none yet
    int gap = 0;
    int run = 0;
    const auto close = [&](Cell end) { // the first cell behind `run`
      const int back = run + gap;
      if (before > 0 && gap > 0 && gap <= widest_ && std::min(before, run) <= line_)
        gaps.push_back({{end.x - back * way.x, end.y - back * way.y}, way, gap});
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

  const CellMask seen_;
  const int widest_;
  const int line_;
};

/** @brief The gaps between parts of the ceiling that are as long as what is seen of a
 * line: specks at its height are none. */
std::vector<Gap>
gapsBetweenLines(const CellSet& ceiling, double cell_size)
{
  std::vector<CellBox> boxes;
  std::vector<CellKey> keys;
  for (const CellSet& region : connectedRegions(ceiling)) {
    const CellBox box = boxOf(region);
    const int length = std::max(box.high.x - box.low.x, box.high.y - box.low.y) + 1;
    if (length * cell_size < least_line)
      continue;
    boxes.push_back(box);
    keys.insert(keys.end(), region.keys().begin(), region.keys().end());
  }
  const CellSet lines(std::move(keys));
  std::vector<Gap> gaps;
  const int widest = cellsFor(widest_gap, cell_size);
  for (const CellBox& box : clusterBoxes(boxes, widest))
    if (maskProblem(box).empty())
      GapFinder(CellMask(lines, box), widest, cellsFor(line_width, cell_size))
          .find(gaps);
  return gaps;
}

CellSet
cellsOf(const std::vector<Gap>& gaps)
{
  std::vector<CellKey> keys;
  for (const Gap& gap : gaps)
    for (int k = 0; k < gap.length; ++k)
      keys.push_back(keyOf(gap.at(k)));
  return CellSet(std::move(keys));
}

/** @brief The lowest and the highest place of a slab above some cells, metres. */
std::pair<double, double>
heightsAbove(const CellBox& box, const PlanSlab& slab, const CellGrid& grid)
{
  std::pair<double, double> heights{std::numeric_limits<double>::infinity(),
                                    -std::numeric_limits<double>::infinity()};
  for (const std::int32_t x : {box.low.x, box.high.x})
    for (const std::int32_t y : {box.low.y, box.high.y}) {
      const double z = slab.heightAt(grid.centre({x, y}));
      heights = {std::min(heights.first, z), std::max(heights.second, z)};
    }
  return heights;
}

/** @brief The cells that hold anything just below or above the ceiling, and those
 * between such as are a gap apart: far away walls are seen as sparsely. */
CellMask
takenCells(const CellBox& box,
           const PlanSlab& ceiling,
           const CellGrid& grid,
           const PointView& points,
           const std::vector<int>& indices)
{
  CellMask taken(box);
  const auto [low, high] = heightsAbove(grown(box, 1), ceiling, grid);
  for (const int i : indices) {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    if (!(p.z() > low - reach && p.z() < high + reach) || !grid.holds(p.x(), p.y()))
      continue;
    const Cell cell = grid.at(p.x(), p.y());
    if (!taken.isInside(cell))
      continue;
    const double off = std::abs(p.z() - ceiling.heightAt(p.head<2>().cast<double>()));
    if (off > noise && off < reach)
      taken.set(cell, 1);
  }
  std::vector<Gap> gaps;
  GapFinder(taken, cellsFor(widest_gap, grid.size()), std::numeric_limits<int>::max())
      .find(gaps);
  for (const Gap& gap : gaps)
    for (int k = 0; k < gap.length; ++k)
      taken.set(gap.at(k), 1);
  return taken;
}

/** @brief The gaps but for those that are few beside each other: between two lines, or
 * rough edges. */
CellMask
withoutSmall(const CellMask& gaps, double cell_size)
{
  constexpr double least_area = 1; // square metres
  const CellMask joined = dilated(gaps, cellsFor(line_width, cell_size));
  const MaskRegions regions = labelRegions(joined, true);
  std::vector<std::size_t> counts(regions.sizes.size(), 0);
  for (std::size_t i = 0; i < gaps.values().size(); ++i)
    if (gaps.values()[i])
      ++counts[static_cast<std::size_t>(regions.label[i])];
  CellMask large(gaps.box());
  for (std::size_t i = 0; i < gaps.values().size(); ++i)
    if (gaps.values()[i])
      large.values()[i] =
          static_cast<double>(counts[static_cast<std::size_t>(regions.label[i])]) *
                      cell_size * cell_size >=
                  least_area
              ? 1
              : 0;
  return large;
}

} // namespace

CellSet
sweepGaps(const Level& ceiling,
          const CellSet& others,
          double cell_size,
          const PointView& points,
          const std::vector<int>& indices)
{
  const std::vector<Gap> gaps = gapsBetweenLines(ceiling.cells, cell_size);
  const CellSet cells = cellsOf(gaps);
  const CellBox box = grown(boxOf(cells), cellsFor(widest_gap, cell_size));
  if (gaps.empty() || !maskProblem(box).empty())
    return {};
  CellMask taken = takenCells(box, ceiling.slab, CellGrid(cell_size), points, indices);
  for (const CellKey key : others.keys())
    if (taken.isInside(cellOf(key)))
      taken.set(cellOf(key), 1);
  // A wall along which the scanner looks is sparse: its neighbours count.
  taken = dilated(taken, 1);
  std::vector<std::uint8_t> ways(cells.size(), 0);
  for (const Gap& gap : gaps) {
    bool is_free = true;
    for (int k = 0; k < gap.length && is_free; ++k)
      is_free = taken.at(gap.at(k)) == 0;
    for (int k = 0; k < gap.length && is_free; ++k)
      ++ways[cells.find(gap.at(k))];
  }
  // Past the corner of a column whose back was not seen there is a way in one
  // direction.
  CellMask found(box);
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (ways[i] >= 2)
      found.set(cells[i], 1);
  return withoutSmall(found, cell_size).toSet();
}

} // namespace sedr
} // namespace pcl
