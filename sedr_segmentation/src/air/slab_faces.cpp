// SPDX-License-Identifier: BSD-3-Clause
#include "slab_faces.h"

#include "ceiling_dip.h"
#include "height_counts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pcl::sedr {

namespace {

/** @brief A region in which slabs have one face. */
struct OneFaced {
  std::vector<std::uint32_t> gaps;   ///< below them
  std::array<HeightCounts, 2> sides; ///< of their face: where the gap below ends, and
                                     ///< where that above begins
  std::vector<std::array<double, 2>> rim; ///< both faces of the slabs beside, the lower
                                          ///< first
};

class SlabFaces {
public:
  explicit SlabFaces(const AirGaps& air)
      : air_(air)
      , above_(air.size(), AirGaps::none)
      , is_met_(air.size(), 0)
      , ceiling_(closedCeiling(air, ribReach(air)))
  {
    std::uint32_t below = AirGaps::none;
    for (std::uint32_t g = 0; g < air.size(); ++g) {
      gaps_.push_back(air[g]);
      if (!air.isTall(air[g]))
        continue;
      if (below != AirGaps::none && air[below].column == air[g].column)
        above_[below] = g;
      below = g;
    }
  }

  std::vector<AirGap> completed()
  {
    for (std::uint32_t g = 0; g < air_.size(); ++g)
      if (hasOneFace(g) && is_met_[g] == 0)
        completeRegion(g);
    return gaps_;
  }

private:
  /** @brief Columns to the middle of the widest beam: it is less than four slabs wide.
   */
  static int ribReach(const AirGaps& air)
  {
    return static_cast<int>(
        std::lround(2 * air.parameters().thinnest_slab / air.columns().cellSize()));
  }

  /** @brief Height of the floor above the slab over a gap. */
  double floorAbove(std::uint32_t below) const
  {
    return air_.columns().heightOf(air_[above_[below]].low);
  }

  /** @brief Whether the slab over a gap is thinner than one with both faces: as
   * measured from the ceiling beside its ribs and beams. */
  bool hasOneFace(std::uint32_t below) const
  {
    return above_[below] != AirGaps::none &&
           floorAbove(below) - ceiling_[below] <
               air_.parameters().thinnest_slab - air_.columns().voxelHeight() / 2;
  }

  void completeRegion(std::uint32_t start)
  {
    constexpr double share_of_floor = 0.2; // of a rim; the rest may be furniture
    const OneFaced region = regionFrom(start);
    const std::array<double, 2> seen{region.sides[0].highestCount(),
                                     region.sides[1].highestCount()};
    std::array<std::size_t, 2> goes_on{0, 0}; // as the lower or the upper face
    std::array<HeightCounts, 2> others;       // of the slabs along which it does
    for (const std::array<double, 2>& faces : region.rim)
      for (std::size_t side = 0; side < 2; ++side)
        if (std::abs(faces[side] - seen[side]) < air_.parameters().thinnest_slab / 2) {
          ++goes_on[side];
          others[side].add(faces[1 - side]);
        }
    if (goes_on[0] + goes_on[1] == 0)
      return;
    const bool is_ceiling = goes_on[0] >= goes_on[1];
    const std::int32_t other = voxelOf(is_ceiling ? others[0].lowestOf(share_of_floor)
                                                  : others[1].highestCount());
    for (const std::uint32_t below : region.gaps)
      if (std::abs(ceiling_[below] - seen[0]) <=
          air_.parameters().same_surface) // else a tread of stairs
        moveApart(gaps_[below], gaps_[above_[below]], other, is_ceiling);
  }

  /** @brief Gives the gap above or that below a surface the other face of the slab.
   * @param is_ceiling whether the surface is the ceiling of the gap below */
  void
  moveApart(AirGap& lower, AirGap& upper, std::int32_t other, bool is_ceiling) const
  {
    const std::int32_t low = std::max(upper.low, other);
    const std::int32_t high = std::min(lower.high, other);
    if (is_ceiling && air_.hasHeadroom(low, upper.high)) {
      upper.low = low;
      upper.floor_seen = false;
    }
    if (!is_ceiling && air_.hasHeadroom(lower.low, high)) {
      lower.high = high;
      lower.ceiling_seen = false;
    }
  }

  /** @brief The places with one face that hang together. */
  OneFaced regionFrom(std::uint32_t start)
  {
    OneFaced region;
    region.gaps = {start};
    is_met_[start] = 1;
    for (std::size_t k = 0; k < region.gaps.size(); ++k) {
      region.sides[0].add(ceiling_[region.gaps[k]]);
      region.sides[1].add(floorAbove(region.gaps[k]));
      for (int d = 0; d < 4; ++d) {
        const std::uint32_t o = slabBeside(region.gaps[k], d);
        if (o == AirGaps::none)
          continue;
        if (!hasOneFace(o))
          region.rim.push_back({ceiling_[o], floorAbove(o)});
        else if (is_met_[o] == 0) {
          is_met_[o] = 1;
          region.gaps.push_back(o);
        }
      }
    }
    return region;
  }

  /** @brief The gap below the slab that goes on beside that above another gap. */
  std::uint32_t slabBeside(std::uint32_t below, int d) const
  {
    const std::uint32_t column = air_.columns().neighbour(air_[below].column, d);
    const std::uint32_t o = air_.goingOnFrom(air_[below], column);
    return o == AirGaps::none || above_[o] == AirGaps::none ? AirGaps::none : o;
  }

  std::int32_t voxelOf(double height) const
  {
    return air_.columns().voxelAt(height + air_.columns().voxelHeight() / 2);
  }

  const AirGaps& air_;
  std::vector<std::uint32_t> above_; ///< of a tall gap: the next in its column
  std::vector<std::uint8_t> is_met_;
  std::vector<float> ceiling_; ///< above a gap, beside ribs and beams
  std::vector<AirGap> gaps_;
};

} // namespace

std::vector<AirGap>
withBothFaces(const AirGaps& air)
{
  return SlabFaces(air).completed();
}

} // namespace pcl::sedr
