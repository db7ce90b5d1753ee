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

  /** @brief Whether what is between a gap and that below it may be a veil. */
  bool isVeil(std::size_t g) const
  {
    if (!isOneColumn(g, g - 1))
      return false;
    const AirGap& below = air_[g - 1];
    const AirGap& above = air_[g];
    if (isLow(g) && !isInSlab(g, g - 1, g + 1) &&
        isThin(below.column, below.high, above.low, above.high))
      return true;
    return isLow(g - 1) && !isInSlab(g - 1, g, g - 2) &&
           isThin(below.column, below.high, above.low, below.low - surface_);
  }

private:
  bool isOneColumn(std::size_t g, std::size_t other) const
  {
    return other < air_.size() && air_[g].column == air_[other].column;
  }

  bool isLow(std::size_t g) const { return !air_.isTall(air_[g]); }

  /** @brief Whether a low gap lies between the faces of a slab: there is the air of a
   * storey beyond the layer to test, and beyond a thin one on its other side. */
  bool isInSlab(std::size_t g, std::size_t tested, std::size_t other) const
  {
    if (!isOneColumn(g, other) || isLow(tested) || isLow(other))
      return false;
    const std::int32_t layer =
        other > g ? air_[other].low - air_[g].high : air_[g].low - air_[other].high;
    return layer < air_.voxels(air_.parameters().thinnest_slab);
  }

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

/** @brief Which gaps are one with the gap below them. */
class JoinedGaps {
public:
  JoinedGaps(const AirGaps& air, const VoxelColumns& fine)
      : air_(air)
      , thin_(air.size(), 0)
      , joined_(air.size(), 0)
  {
    const Veils veils(air, fine);
    for (std::size_t g = 1; g < air.size(); ++g)
      thin_[g] = veils.isVeil(g);
  }

  /** @brief Joins gaps from the rim of each veil, where there is air beside it. */
  std::vector<char> find()
  {
    std::vector<std::size_t> front;
    for (std::size_t g = 0; g < air_.size(); ++g)
      join(g, front);
    while (!front.empty()) {
      const std::uint32_t column = air_[front.back()].column;
      front.pop_back();
      for (int d = 0; d < 4; ++d) {
        const std::uint32_t beside = air_.columns().neighbour(column, d);
        if (beside != VoxelColumns::none)
          for (std::size_t g = air_.first(beside); g < air_.first(beside + 1); ++g)
            join(g, front);
      }
    }
    return joined_;
  }

private:
  void join(std::size_t g, std::vector<std::size_t>& front)
  {
    if (!thin_[g] || joined_[g] ||
        !isAirBeside(air_[g].column, air_[g - 1].high, air_[g].low))
      return;
    joined_[g] = 1;
    front.push_back(g);
  }

  /** @brief Whether a column beside one is air over a range of heights. */
  bool isAirBeside(std::uint32_t column, std::int32_t low, std::int32_t high) const
  {
    for (int d = 0; d < 4; ++d) {
      const std::uint32_t beside = air_.columns().neighbour(column, d);
      if (beside == VoxelColumns::none)
        continue;
      std::int32_t from = 0;
      for (std::size_t g = air_.first(beside); g < air_.first(beside + 1); ++g) {
        if (!joined_[g])
          from = air_[g].low;
        if (from <= low && air_[g].high >= high)
          return true;
      }
    }
    return false;
  }

  const AirGaps& air_;
  std::vector<char> thin_; ///< what is between a gap and that below has few points
  std::vector<char> joined_;
};

} // namespace

std::vector<AirGap>
withoutVeils(const AirGaps& air, const VoxelColumns& fine)
{
  const std::vector<char> joined = JoinedGaps(air, fine).find();
  std::vector<AirGap> gaps;
  for (std::size_t g = 0; g < air.size(); ++g)
    if (joined[g])
      gaps.back().high = air[g].high;
    else
      gaps.push_back(air[g]);
  return gaps;
}

} // namespace pcl::sedr
