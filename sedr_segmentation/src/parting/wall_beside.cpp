// SPDX-License-Identifier: BSD-3-Clause
#include "wall_beside.h"

namespace pcl::sedr {

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
