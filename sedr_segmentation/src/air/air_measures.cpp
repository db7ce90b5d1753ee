// SPDX-License-Identifier: BSD-3-Clause
#include "air_measures.h"

#include "sedr_filters/src/base/parallel.h"

#include <cstddef>
#include <cstdint>
#include <functional>

namespace pcl::sedr {

namespace {

constexpr std::size_t ceilings_a_block = 16384;

/** @brief The extreme of each gap's value and its four neighbours', `reach` times. */
template <typename Better>
std::vector<float>
spread(const AirGaps& air, std::vector<float> values, int reach, Better better)
{
  std::vector<float> next(values.size());
  for (int round = 0; round < reach; ++round) {
    parallelBlocks(values.size(), ceilings_a_block, air.parameters().threads,
                   [&](std::size_t begin, std::size_t end) {
                     for (std::size_t g = begin; g < end; ++g) {
                       float best = values[g];
                       for (int d = 0; d < 4; ++d) {
                         const std::uint32_t o = air.link(g, d);
                         if (o != AirGaps::none && better(values[o], best))
                           best = values[o];
                       }
                       next[g] = best;
                     }
                   });
    values.swap(next);
  }
  return values;
}

constexpr std::greater<float> higher;
constexpr std::less<float> lower;

std::vector<float>
ceilingOf(const AirGaps& air)
{
  std::vector<float> high(air.size());
  for (std::size_t g = 0; g < air.size(); ++g)
    high[g] = static_cast<float>(air.columns().heightOf(air[g].high));
  return high;
}

std::vector<float>
closed(const AirGaps& air, const std::vector<float>& high, int reach)
{
  return spread(air, spread(air, high, reach, higher), reach, lower);
}

} // namespace

std::vector<float>
closedCeiling(const AirGaps& air, int reach)
{
  return closed(air, ceilingOf(air), reach);
}

std::vector<float>
dipOfCeiling(const AirGaps& air, int reach)
{
  // What is narrower than a lintel is long is a hole in the ceiling, or between ribs.
  const int narrow = reach / 2;
  const std::vector<float> high =
      spread(air, spread(air, ceilingOf(air), narrow, lower), narrow, higher);
  std::vector<float> dip = closed(air, high, reach);
  for (std::size_t g = 0; g < dip.size(); ++g)
    dip[g] -= high[g];
  return dip;
}

std::vector<float>
distanceToRim(const AirGaps& air, const std::vector<std::uint8_t>& inside)
{
  // In fifths of a cell: 5 to a side, 7 to a corner; a rim is half a cell away.
  constexpr int to_side = 5;
  constexpr int to_corner = 7;
  constexpr int to_rim = 3;
  constexpr std::uint32_t unreached = static_cast<std::uint32_t>(-1);
  const auto isInside = [&](std::uint32_t g) {
    return g != AirGaps::none && (inside.empty() || inside[g] != 0);
  };
  std::vector<std::uint32_t> steps(air.size(), unreached);
  std::vector<std::vector<std::uint32_t>> bucket(8);
  const auto reach = [&](std::uint32_t g, std::uint32_t at) {
    if (at < steps[g]) {
      steps[g] = at;
      bucket[at % 8].push_back(g);
    }
  };
  for (std::uint32_t g = 0; g < air.size(); ++g) {
    if (!isInside(g))
      continue;
    for (int d = 0; d < 4; ++d)
      if (!isInside(air.next(g, d))) {
        reach(g, to_rim);
        break;
      }
  }
  std::vector<std::uint32_t> now;
  for (std::uint32_t at = to_rim, idle = 0; idle < 8; ++at) {
    now.clear();
    now.swap(bucket[at % 8]);
    idle = now.empty() ? idle + 1 : 0;
    for (const std::uint32_t g : now) {
      if (steps[g] != at)
        continue;
      for (int d = 0; d < 4; ++d) {
        if (const std::uint32_t side = air.next(g, d); isInside(side))
          reach(side, at + to_side);
        if (const std::uint32_t corner = air.diagonal(g, d); isInside(corner))
          reach(corner, at + to_corner);
      }
    }
  }
  std::vector<float> distance(air.size(), 0);
  for (std::size_t g = 0; g < air.size(); ++g)
    if (steps[g] != unreached)
      distance[g] = static_cast<float>(steps[g]) / to_side;
  return distance;
}

std::vector<float>
distanceToLintel(const AirGaps& air, const std::vector<float>& dip, double lintel)
{
  std::vector<std::uint8_t> is_level(air.size());
  for (std::size_t g = 0; g < air.size(); ++g)
    is_level[g] = dip[g] < lintel ? 1 : 0;
  return distanceToRim(air, is_level);
}

bool
isWallAt(const AirGaps& air, std::uint32_t column, const AirGap& gap)
{
  constexpr double least = 0.3; // of the heights
  const auto isWall = [&](std::uint32_t c) {
    return c != VoxelColumns::none &&
           air.occupiedShare(c, gap.low + (gap.high - gap.low) / 3, gap.high) >= least;
  };
  if (column == VoxelColumns::none)
    return false;
  for (int d = 0; d < 4; ++d)
    if (isWall(air.columns().neighbour(column, d)))
      return true;
  return isWall(column);
}

bool
isWallBeside(const AirGaps& air, std::size_t g, int d)
{
  constexpr int depth = 3; // columns
  std::uint32_t column = air[g].column;
  for (int step = 0; step < depth && column != VoxelColumns::none; ++step) {
    column = air.columns().neighbour(column, d);
    if (isWallAt(air, column, air[g]))
      return true;
  }
  return false;
}

} // namespace pcl::sedr
