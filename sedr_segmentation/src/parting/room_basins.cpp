// SPDX-License-Identifier: BSD-3-Clause
#include "room_basins.h"

#include "gap_distance.h"
#include "jamb_lines.h"
#include "room_labels.h"

#include "sedr_filters/src/grids/disjoint_sets.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr std::int32_t no_room = RoomLabels::no_room;

/** @brief Basins of the distance from the rim, from their middles outwards, which end
 * at jamb lines. */
std::vector<std::int32_t>
basinsOf(const AirGaps& air,
         const std::vector<float>& distance,
         const std::vector<std::uint8_t>& is_jamb_line,
         double same_basin)
{
  std::vector<std::uint32_t> order;
  for (std::uint32_t g = 0; g < air.size(); ++g)
    if (distance[g] > 0 && is_jamb_line[g] == 0)
      order.push_back(g);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return distance[a] > distance[b];
  });
  std::vector<std::int32_t> basin(air.size(), no_room);
  std::vector<float> peak; // falls: of several basins the first is the highest
  DisjointSets<> sets(order.size());
  for (const std::uint32_t g : order) {
    std::vector<std::uint32_t> met;
    std::uint32_t uphill =
        AirGaps::none; // towards its own middle, not into what is larger
    for (int d = 0; d < 4; ++d)
      for (const std::uint32_t o : {air.next(g, d), air.diagonal(g, d)})
        if (o != AirGaps::none && basin[o] != no_room) {
          met.push_back(sets.find(static_cast<std::uint32_t>(basin[o])));
          if (uphill == AirGaps::none || distance[o] > distance[uphill])
            uphill = o;
        }
    if (met.empty()) {
      basin[g] = static_cast<std::int32_t>(peak.size());
      peak.push_back(distance[g]);
      continue;
    }
    basin[g] = basin[uphill];
    const std::uint32_t highest = *std::min_element(met.begin(), met.end());
    for (const std::uint32_t other : met)
      if (distance[g] >= same_basin * peak[other])
        sets.join(highest, other);
  }
  for (std::int32_t& b : basin)
    if (b != no_room)
      b = static_cast<std::int32_t>(sets.find(static_cast<std::uint32_t>(b)));
  return basin;
}

/** @brief Takes labels outwards, step by step, to gaps that have none and are not to be
 * left out. */
void
growLabels(const AirGaps& air,
           const std::vector<std::uint8_t>& is_left_out,
           std::vector<std::int32_t>& label)
{
  std::vector<std::uint32_t> front;
  for (std::uint32_t g = 0; g < air.size(); ++g)
    if (label[g] != no_room)
      front.push_back(g);
  while (!front.empty()) {
    std::vector<std::uint32_t> next;
    for (const std::uint32_t g : front)
      for (int d = 0; d < 4; ++d) {
        const std::uint32_t o = air.next(g, d);
        if (o != AirGaps::none && label[o] == no_room && is_left_out[o] == 0) {
          label[o] = label[g];
          next.push_back(o);
        }
      }
    front = std::move(next);
  }
}

} // namespace

std::vector<std::int32_t>
roomBasins(const AirGaps& air,
           const std::vector<float>& dip,
           const PartingParameters& parameters)
{
  const std::vector<std::uint8_t> is_jamb_line =
      jambLines(air, distanceToRim(air), parameters);
  std::vector<std::int32_t> label =
      basinsOf(air, distanceToLintel(air, dip, parameters.lintel), is_jamb_line,
               parameters.same_basin);
  growLabels(air, is_jamb_line, label); // rooms meet in doorways
  growLabels(air, std::vector<std::uint8_t>(air.size(), 0), label);
  return label;
}

} // namespace pcl::sedr
