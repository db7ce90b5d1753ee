// SPDX-License-Identifier: BSD-3-Clause
#include "low_air.h"

#include "air_labelling.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace pcl::sedr {

namespace {

/** @brief Labels the gaps that are no air. Returns 1 for those that are.
 * @param goesOn whether air may go on from a gap to one beside it */
template <typename GoesOn>
std::vector<std::uint8_t>
airBeside(const AirGaps& gaps, const std::vector<std::uint8_t>& is_air, GoesOn goesOn)
{
  std::vector<std::size_t> place(gaps.size(), 0);
  std::vector<std::uint32_t> others;
  for (std::uint32_t g = 0; g < gaps.size(); ++g)
    if (is_air[g] == 0) {
      place[g] = others.size();
      others.push_back(g);
    }
  AirLabelling labelling(others.size(), gaps);
  for (const std::uint32_t g : others)
    for (int d = 0; d < 4; ++d) {
      const std::uint32_t o = gaps.link(g, d);
      if (o == AirGaps::none || !goesOn(g, o))
        labelling.addEnd(place[g]);
      else if (is_air[o] != 0)
        labelling.addKnown(place[g]);
      else
        labelling.addOther(place[g], place[o]);
    }
  const std::vector<std::uint8_t> is_added = labelling.solve();
  std::vector<std::uint8_t> added(gaps.size(), 0);
  for (std::size_t k = 0; k < others.size(); ++k)
    added[others[k]] = is_added[k];
  return added;
}

} // namespace

std::vector<std::uint8_t>
airOf(const AirGaps& gaps)
{
  const std::int32_t step = gaps.voxels(gaps.parameters().same_ceiling);
  std::vector<std::uint8_t> is_air;
  for (std::size_t g = 0; g < gaps.size(); ++g)
    is_air.push_back(gaps.isTall(gaps[g]) ? 1 : 0);
  const std::vector<std::uint8_t> low =
      airBeside(gaps, is_air, [&](std::uint32_t a, std::uint32_t b) {
        return std::abs(gaps[a].high - gaps[b].high) <= step;
      });
  for (std::size_t g = 0; g < gaps.size(); ++g)
    is_air[g] = is_air[g] != 0 || low[g] != 0 ? 1 : 0;
  return is_air;
}

std::vector<AirRecess>
recessesOf(const AirGaps& gaps, const std::vector<std::uint8_t>& is_air)
{
  // Nothing but what hangs from the ceiling of the one is above the lower one.
  const auto goesOn = [&](std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax(gaps[a].high, gaps[b].high);
    const std::uint32_t g = gaps[a].high == low ? a : b;
    return g + 1 == gaps.first(gaps[g].column + 1) || gaps[g + 1].low > high;
  };
  const std::vector<std::uint8_t> is_recess = airBeside(gaps, is_air, goesOn);
  std::vector<std::uint8_t> is_reached = is_air;
  std::vector<AirRecess> recesses;
  std::vector<std::uint32_t> found;
  const auto enter = [&](std::uint32_t g, std::uint32_t air) {
    for (int d = 0; d < 4; ++d)
      if (const std::uint32_t o = gaps.link(g, d); o != AirGaps::none &&
                                                   is_recess[o] != 0 &&
                                                   is_reached[o] == 0 && goesOn(g, o)) {
        is_reached[o] = 1;
        found.push_back(o);
        recesses.push_back({gaps[o], air});
      }
  };
  for (std::uint32_t g = 0; g < gaps.size(); ++g)
    if (is_air[g] != 0)
      enter(g, g);
  for (std::size_t k = 0; k < found.size(); ++k)
    enter(found[k], recesses[k].air);
  return recesses;
}

} // namespace pcl::sedr
