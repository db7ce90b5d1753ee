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
  struct Reached {
    std::uint32_t gap;
    std::uint32_t air;
    int steps; ///< from the air, columns
  };
  std::vector<Reached> reached;
  std::vector<std::uint32_t> patch(gaps.size(), AirGaps::none); // of each recess
  std::vector<int> deepest;                                     // of each patch
  const auto forEachBeside = [&](std::uint32_t g, const auto& visit) {
    for (int d = 0; d < 4; ++d)
      if (const std::uint32_t o = gaps.link(g, d);
          o != AirGaps::none && is_recess[o] != 0 && goesOn(g, o))
        visit(o);
  };
  std::vector<std::uint8_t> is_reached = is_air;
  const auto enter = [&](std::uint32_t g, std::uint32_t air, int steps) {
    forEachBeside(g, [&](std::uint32_t o) {
      if (is_reached[o] == 0)
        reached.push_back({o, air, steps});
      is_reached[o] = 1;
    });
  };
  for (std::uint32_t g = 0; g < gaps.size(); ++g)
    if (is_air[g] != 0)
      enter(g, g, 1);
  for (std::size_t k = 0; k < reached.size(); ++k)
    enter(reached[k].gap, reached[k].air, reached[k].steps + 1);
  for (const Reached& first : reached) {
    if (patch[first.gap] != AirGaps::none)
      continue;
    std::vector<std::uint32_t> front{first.gap};
    patch[first.gap] = static_cast<std::uint32_t>(deepest.size());
    deepest.push_back(0);
    for (std::size_t k = 0; k < front.size(); ++k)
      forEachBeside(front[k], [&](std::uint32_t o) {
        if (patch[o] == AirGaps::none)
          front.push_back(o);
        patch[o] = patch[first.gap];
      });
  }
  for (const Reached& recess : reached)
    deepest[patch[recess.gap]] = std::max(deepest[patch[recess.gap]], recess.steps);
  std::vector<AirRecess> recesses;
  for (const Reached& recess : reached)
    if (deepest[patch[recess.gap]] * gaps.columns().cellSize() >
        gaps.parameters().deepest_reveal)
      recesses.push_back({gaps[recess.gap], recess.air});
  return recesses;
}

} // namespace pcl::sedr
