// SPDX-License-Identifier: BSD-3-Clause
#include "low_air.h"

#include "air_labelling.h"

#include <cstddef>
#include <cstdlib>

namespace pcl::sedr {

std::vector<std::uint8_t>
airOf(const AirGaps& gaps)
{
  const std::int32_t step = gaps.voxels(gaps.parameters().same_ceiling);
  std::vector<std::uint8_t> is_air(gaps.size(), 1);
  std::vector<std::size_t> place(gaps.size(), 0); // of a low gap
  std::vector<std::uint32_t> low;
  for (std::uint32_t g = 0; g < gaps.size(); ++g)
    if (!gaps.isTall(gaps[g])) {
      place[g] = low.size();
      low.push_back(g);
      is_air[g] = 0;
    }
  AirLabelling labelling(low.size(), gaps);
  for (const std::uint32_t g : low)
    for (int d = 0; d < 4; ++d) {
      const std::uint32_t o = gaps.link(g, d);
      if (o == AirGaps::none || std::abs(gaps[o].high - gaps[g].high) > step)
        labelling.addEnd(place[g]);
      else if (is_air[o] != 0)
        labelling.addKnown(place[g]);
      else
        labelling.addOther(place[g], place[o]);
    }
  const std::vector<std::uint8_t> is_added = labelling.solve();
  for (std::size_t k = 0; k < low.size(); ++k)
    is_air[low[k]] = is_added[k];
  return is_air;
}

} // namespace pcl::sedr
