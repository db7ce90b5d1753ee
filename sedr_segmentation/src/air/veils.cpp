// SPDX-License-Identifier: BSD-3-Clause
#include "veils.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace pcl::sedr {

namespace {

class Veils {
public:
  Veils(const AirGaps& air, const VoxelColumns& fine)
      : air_(air)
      , fine_(fine)
      , surface_(air.voxels(air.parameters().same_surface) / 2)
      , reach_(2 * air.parameters().veil_reach)
  {}

  /** @brief Whether what is between two gaps of a column is a veil. */
  bool isVeil(const AirGap& below, const AirGap& above) const
  {
    const std::int32_t tall = air_.voxels(air_.parameters().headroom);
    if (above.high - above.low < tall &&
        isThin(below.column, below.high, above.low, above.high))
      return true;
    return below.high - below.low < tall &&
           isThin(below.column, below.high, above.low, below.low - surface_);
  }

private:
  /** @brief Whether a layer has fewer points than the surface that begins at a height.
   */
  bool isThin(std::uint32_t column,
              std::int32_t low,
              std::int32_t high,
              std::int32_t behind) const
  {
    const int needed = countAround(column, behind);
    for (std::int32_t at = low; at < std::max(high - surface_, low) + 1; ++at)
      if (countAround(column, at) >= air_.parameters().veil * needed)
        return false;
    return true;
  }

  /** @brief The number of fine columns around one in which a surface at a height is. */
  int countAround(std::uint32_t column, std::int32_t at) const
  {
    const Eigen::Vector2d middle =
        air_.columns().grid().centre(air_.columns().cellOf(column));
    const Cell corner = fine_.grid().at(middle.x() + fine_.cellSize() / 2,
                                        middle.y() + fine_.cellSize() / 2);
    int count = 0;
    for (int x = -reach_ - 1; x <= reach_; ++x)
      for (int y = -reach_ - 1; y <= reach_; ++y) {
        const std::uint32_t c = fine_.columnAt({corner.x + x, corner.y + y});
        if (c != VoxelColumns::none && fine_.countBetween(c, at, at + surface_) > 0)
          ++count;
      }
    return count;
  }

  const AirGaps& air_;
  const VoxelColumns& fine_;
  std::int32_t surface_; ///< voxels: as thick as the points of a surface
  int reach_;            ///< fine columns
};

} // namespace

std::vector<AirGap>
withoutVeils(const AirGaps& air, const VoxelColumns& fine)
{
  const Veils veils(air, fine);
  std::vector<AirGap> gaps;
  for (std::size_t g = 0; g < air.size(); ++g)
    if (!gaps.empty() && gaps.back().column == air[g].column &&
        veils.isVeil(gaps.back(), air[g]))
      gaps.back().high = air[g].high;
    else
      gaps.push_back(air[g]);
  return gaps;
}

} // namespace pcl::sedr
