// SPDX-License-Identifier: BSD-3-Clause
#include "ceiling_dip.h"

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

} // namespace pcl::sedr
