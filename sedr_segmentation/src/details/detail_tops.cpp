// SPDX-License-Identifier: BSD-3-Clause
#include "detail_tops.h"
#include "height_drops.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Returns the cells between two ceiling parts at most eight cells apart: two of
 * a narrow beam, and three per side over which noise may spread its riser. The wall
 * above a window has ceiling on one side only. */
CellMask
betweenCeilings(const SliceScene& scene)
{
  const double half_of_beam = scene.parameters.priors.riser_cells + 1;
  return eroded(dilated(scene.ceiling, half_of_beam), half_of_beam);
}

/** @brief Returns the mean height of a profile's points from `low` upwards. */
double
meanAbove(const ColumnTable& columns, Cell cell, float low)
{
  double sum = 0;
  double count = 0;
  for (auto* entry = columns.begin(cell); entry != columns.end(cell); ++entry)
    if (entry->z >= low) {
      sum += entry->z;
      count += 1;
    }
  return sum / count;
}

/** @brief Returns the cells of steps between undersides, see cellsOfDrops(). They
 * include steps lower than the tolerance, and slopes, as from a cove to a window head.
 */
CellMask
stepsBetween(const Tops& tops, const Priors& priors)
{
  const CellSet cells = tops.undersides.toSet();
  std::vector<double> heights;
  for (std::size_t i = 0; i < cells.size(); ++i)
    heights.push_back(tops.mean[tops.undersides.indexOf(cells[i])]);
  const std::vector<std::uint8_t> edges = cellsOfDrops(cells, heights, priors);
  CellMask steps(tops.undersides.box());
  for (std::size_t i = 0; i < cells.size(); ++i)
    steps.set(cells[i], edges[i]);
  return steps;
}

/** @brief Labels the regions of a mask in which neighbours differ by less than the
 * tolerance in height; the first label is `first`.
 * @return the next label */
std::int32_t
labelHeights(const Tops& tops,
             const CellMask& mask,
             double tolerance,
             std::int32_t first,
             std::vector<std::int32_t>& label)
{
  std::int32_t next = first;
  for (std::size_t start = 0; start < mask.values().size(); ++start) {
    if (!mask.values()[start] || label[start] >= 0)
      continue;
    label[start] = next;
    std::vector<Cell> region{mask.cellAt(start)};
    for (std::size_t k = 0; k < region.size(); ++k) {
      const Cell cell = region[k];
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const Cell to{cell.x + dx, cell.y + dy};
          if (!mask.at(to) || label[mask.indexOf(to)] >= 0 ||
              std::abs(tops.height[mask.indexOf(to)] -
                       tops.height[mask.indexOf(cell)]) > tolerance)
            continue;
          label[mask.indexOf(to)] = next;
          region.push_back(to);
        }
    }
    ++next;
  }
  return next;
}

/** @brief Removes the labels of regions with fewer than `min_cells`. */
void
dropSmall(std::size_t min_cells, std::int32_t count, std::vector<std::int32_t>& label)
{
  std::vector<std::size_t> sizes(static_cast<std::size_t>(count), 0);
  for (const std::int32_t l : label)
    if (l >= 0)
      ++sizes[static_cast<std::size_t>(l)];
  for (std::int32_t& l : label)
    if (l >= 0 && sizes[static_cast<std::size_t>(l)] < min_cells)
      l = -1;
}

/** @brief Assigns undersides without a label (steps and small areas between them) to
 * the adjacent region nearest in height. */
void
labelSteps(const Tops& tops,
           double tolerance,
           int reach,
           std::vector<std::int32_t>& label)
{
  const CellMask& steps = tops.undersides;
  const std::vector<std::int32_t> beside = label;
  for (std::size_t i = 0; i < label.size(); ++i) {
    if (!steps.values()[i] || label[i] >= 0)
      continue;
    double least = tolerance;
    const Cell cell = steps.cellAt(i);
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx) {
        const Cell near{cell.x + dx, cell.y + dy};
        if (!tops.undersides.at(near) || beside[steps.indexOf(near)] < 0)
          continue;
        const double d = std::abs(tops.mean[steps.indexOf(near)] - tops.mean[i]);
        if (d < least) {
          least = d;
          label[i] = beside[steps.indexOf(near)];
        }
      }
  }
}

} // namespace

Tops
findTops(const SliceScene& scene)
{
  Tops tops{CellMask(scene.ceiling.box()), CellMask(scene.ceiling.box()), {}, {}};
  tops.height.assign(tops.undersides.values().size(), 0.f);
  tops.mean.assign(tops.height.size(), 0);
  scene.forEachCell([&](std::size_t i) {
    ColumnRun top;
    if (!hasOwnTop(scene, tops.undersides.cellAt(i), top))
      return;
    const bool is_short = top.high - top.low < 2 * scene.parameters.tolerance;
    (is_short ? tops.undersides : tops.risers).values()[i] = 1;
    tops.height[i] = top.low;
    tops.mean[i] = meanAbove(scene.columns, tops.undersides.cellAt(i), top.low);
  });
  tops.undersides =
      intersect(tops.undersides,
                unite(dilated(eroded(tops.undersides, 1), 2), betweenCeilings(scene)));
  return tops;
}

std::vector<CellMask>
regionsOfOneHeight(const SliceScene& scene, const Tops& tops)
{
  constexpr double min_parted = 0.15; // square metres
  const Priors& priors = scene.parameters.priors;
  const double cell = scene.parameters.cell_size;
  const double tolerance = scene.parameters.tolerance;
  const CellMask steps = stepsBetween(tops, priors);
  std::vector<std::int32_t> label(tops.height.size(), -1);
  std::int32_t count =
      labelHeights(tops, subtract(tops.undersides, steps), tolerance, 0, label);
  dropSmall(static_cast<std::size_t>(min_parted / (cell * cell)), count, label);
  labelSteps(tops, tolerance, static_cast<int>(priors.riser_cells), label);
  count = labelHeights(tops, tops.undersides, tolerance, count, label);
  std::vector<std::vector<CellKey>> keys(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < label.size(); ++i)
    if (label[i] >= 0)
      keys[static_cast<std::size_t>(label[i])].push_back(
          keyOf(tops.undersides.cellAt(i)));
  std::vector<CellMask> regions;
  for (auto& k : keys) {
    if (k.size() < scene.parameters.minimum_cells)
      continue;
    const CellSet cells(std::move(k));
    const auto margin = static_cast<int>(2 * priors.riser_cells);
    regions.push_back(CellMask(cells, grown(boxOf(cells), margin)));
  }
  return regions;
}

} // namespace pcl::sedr
