// SPDX-License-Identifier: BSD-3-Clause
#include "level_relief.h"
#include "relief_window.h"

#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/middle_value.h"
#include "sedr_filters/src/base/parallel_for.h"
#include "sedr_filters/src/base/plane_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl::sedr {

namespace {

/** @brief The relief around a cell, up to `reach` cells away. */
class Surroundings {
public:
  static constexpr int reach = 4;
  static constexpr std::size_t side = 2 * reach + 1;

  Surroundings(const CellSet& cells, const std::vector<double>& relief, std::size_t at)
  {
    values_.fill(unknown);
    const Cell middle = cells[at];
    forEachAround(cells, middle, reach, [&](std::size_t i) {
      values_[indexOf(cells[i].x - middle.x, cells[i].y - middle.y)] = relief[i];
    });
  }

  /** @brief Returns the height step across the cell; 0 if too few cells were seen or it
   * is lower than `lowest`. */
  double step(bool along_x, double lowest) const
  {
    constexpr std::size_t least = 8;
    return difference(along_x, reach, 2, least, lowest);
  }

  /** @brief Returns whether a step is abrupt. On a slope, the two cells on either side
   * of the centre differ by at most three fifths of the whole step. */
  bool isSharp(double step, bool along_x, const Priors& priors) const
  {
    const auto least = static_cast<std::size_t>(priors.min_evidence);
    return difference(along_x, 2, 1, least, 0) / step >= priors.share_most;
  }

private:
  static std::size_t indexOf(int dx, int dy)
  {
    return static_cast<std::size_t>(dy + reach) * side +
           static_cast<std::size_t>(dx + reach);
  }

  double at(int dx, int dy) const { return values_[indexOf(dx, dy)]; }

  /** @brief Returns the height behind the cell minus that before it. It is 0 if a side
   * has fewer than `least` seen cells, or below `lowest`, which rarely needs sorting.
   */
  double difference(bool along_x,
                    int length,
                    int half_width,
                    std::size_t least,
                    double lowest) const
  {
    ReliefWindow before;
    ReliefWindow behind;
    for (int along = 1; along <= length; ++along)
      for (int across = -half_width; across <= half_width; ++across) {
        before.add(along_x ? at(-along, across) : at(across, -along));
        behind.add(along_x ? at(along, across) : at(across, along));
      }
    if (before.size() < least || behind.size() < least)
      return 0;
    const auto [lowest_before, highest_before] = before.middleRange();
    const auto [lowest_behind, highest_behind] = behind.middleRange();
    if (std::max(highest_behind - lowest_before, highest_before - lowest_behind) <
        lowest)
      return 0;
    const double step = behind.middleMean() - before.middleMean();
    return std::abs(step) >= lowest ? step : 0;
  }

  std::array<double, side * side> values_{};
};

/** @brief Marks the cells around which a step may be: means of neighbouring squares of
 * 20 cm differ by at least half of `step`. This skips most of a slab, which is flat. */
std::vector<std::uint8_t>
unevenCells(const CellSet& cells, const std::vector<double>& relief, double step)
{
  const auto squareOf = [](Cell cell) {
    return Cell{cell.x >> 2, cell.y >> 2}; // rounds down
  };
  std::vector<CellKey> keys;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (!std::isnan(relief[i]))
      if (const CellKey key = keyOf(squareOf(cells[i]));
          keys.empty() || keys.back() != key)
        keys.push_back(key);
  const CellSet squares(std::move(keys));
  std::vector<double> sum(squares.size(), 0);
  std::vector<double> count(squares.size(), 0);
  std::vector<std::size_t> square_of(cells.size(), CellSet::npos);
  std::size_t last = 0; // the next cell in a row is mostly in the same square
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (std::isnan(relief[i]))
      continue;
    const Cell square = squareOf(cells[i]);
    last = squares[last] == square ? last : squares.find(square);
    square_of[i] = last;
    sum[last] += relief[i];
    count[last] += 1;
  }
  std::vector<std::uint8_t> is_uneven(squares.size(), 0);
  for (std::size_t s = 0; s < squares.size(); ++s) {
    double low = sum[s] / count[s];
    double high = low;
    for (const std::size_t near : blockAround(squares, s)) {
      low = std::min(low, sum[near] / count[near]);
      high = std::max(high, sum[near] / count[near]);
    }
    is_uneven[s] = 2 * (high - low) >= step ? 1 : 0;
  }
  std::vector<std::uint8_t> uneven(cells.size(), 0);
  for (std::size_t i = 0; i < cells.size(); ++i)
    uneven[i] = square_of[i] != CellSet::npos ? is_uneven[square_of[i]] : 0;
  return uneven;
}

/** @brief Role of a cell at a step. */
enum : std::uint8_t { none = 0, edge = 1, sharp_edge = 2 };

/** @brief Returns whether one in ten of the edge cells around a cell is sharp. A slope
 * has edge cells only, and noise makes few of them sharp. */
bool
isOfStep(const CellSet& cells,
         const std::vector<std::uint8_t>& kind,
         std::size_t at,
         int reach)
{
  constexpr int min_share = 10; // one in this many
  std::array<int, 3> count{};
  forEachAround(cells, cells[at], reach, [&](std::size_t i) { ++count[kind[i]]; });
  return min_share * count[sharp_edge] >= count[edge] + count[sharp_edge];
}

/** @brief Returns the kind of each cell: whether a drop crosses it, and a sharp one. */
std::vector<std::uint8_t>
edgeKinds(const CellSet& cells,
          const std::vector<double>& relief,
          unsigned threads,
          const Priors& priors)
{
  // The difference of two such means of twenty cells has 0.35 times the noise of a
  // cell.
  const double step = std::max(priors.slab_noise, 2 * noiseOfRelief(cells, relief));
  const std::vector<std::uint8_t> uneven = unevenCells(cells, relief, step);
  std::vector<std::uint8_t> kind(relief.size(), none);
  parallelFor(relief.size(), cells_a_block, threads, [&](std::size_t i) {
    if (!uneven[i])
      return;
    const Surroundings around(cells, relief, i);
    for (const bool along_x : {true, false}) {
      const double across = around.step(along_x, step);
      if (across != 0)
        kind[i] = std::max<std::uint8_t>(
            kind[i], around.isSharp(across, along_x, priors) ? sharp_edge : edge);
    }
  });
  return kind;
}

} // namespace

std::vector<double>
reliefOf(const LevelColumns& columns,
         const std::vector<Candidate>& candidates,
         const PlanSlab& slab,
         double reach)
{
  std::vector<double> sum(columns.cells().size(), 0);
  std::vector<double> count(columns.cells().size(), 0);
  for (const Candidate& c : stretchNear(columns, candidates, slab, reach)) {
    const double d = distanceAbove(slab, c.position());
    if (std::abs(d) > reach)
      continue;
    sum[c.cell] += d;
    count[c.cell] += 1;
  }
  for (std::size_t i = 0; i < sum.size(); ++i)
    sum[i] = count[i] > 0 ? sum[i] / count[i] : unknown;
  return sum;
}

double
noiseOfRelief(const CellSet& cells, const std::vector<double>& relief)
{
  std::vector<double> differences;
  for (std::size_t i = 1; i < relief.size(); ++i)
    if (!std::isnan(relief[i]) && !std::isnan(relief[i - 1]) &&
        cells[i].y == cells[i - 1].y && cells[i].x == cells[i - 1].x + 1)
      differences.push_back(std::abs(relief[i] - relief[i - 1]));
  return differences.empty()
             ? 0
             : 1.4826 * middleValue(std::move(differences)) / std::sqrt(2);
}

std::vector<double>
smoothRelief(const CellSet& cells,
             const std::vector<double>& relief,
             unsigned threads,
             double flat)
{
  std::vector<double> smooth(relief.size(), unknown);
  parallelFor(relief.size(), cells_a_block, threads, [&](std::size_t i) {
    if (std::isnan(relief[i]))
      return;
    ReliefWindow window;
    for (const std::size_t k : blockAround(cells, i))
      window.add(relief[k]);
    smooth[i] = window.isWithin(flat) ? 0 : window.median();
  });
  return smooth;
}

std::vector<std::uint8_t>
cellsOfDrops(const CellSet& cells,
             const std::vector<double>& relief,
             unsigned threads,
             const Priors& priors)
{
  std::vector<std::uint8_t> kind = edgeKinds(cells, relief, threads, priors);
  for (std::uint8_t& k : kind)
    k = k != none ? 1 : 0;
  return kind;
}

std::vector<std::uint8_t>
cellsOfSteps(const CellSet& cells,
             const std::vector<double>& relief,
             unsigned threads,
             const Priors& priors)
{
  const std::vector<std::uint8_t> kind = edgeKinds(cells, relief, threads, priors);
  const int reach = stepReach(priors);
  std::vector<std::uint8_t> edges(relief.size(), 0);
  parallelFor(relief.size(), cells_a_block, threads, [&](std::size_t i) {
    edges[i] = kind[i] != none && isOfStep(cells, kind, i, reach) ? 1 : 0;
  });
  return edges;
}

} // namespace pcl::sedr
