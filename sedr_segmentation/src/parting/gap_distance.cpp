// SPDX-License-Identifier: BSD-3-Clause
#include "gap_distance.h"

#include <cstddef>

namespace pcl::sedr {

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

} // namespace pcl::sedr
