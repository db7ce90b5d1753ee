// SPDX-License-Identifier: BSD-3-Clause
#include "slab_faces.h"

#include "height_counts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pcl {
namespace sedr {

namespace {

constexpr std::uint32_t none = AirGaps::none;

/** @brief What is along the rim of a region in which slabs have one face. */
struct RegionRim {
  HeightCounts ceilings; ///< of the air below slabs of two faces
  HeightCounts floors;   ///< of the air above them
  HeightCounts surfaces; ///< within the region
};

class SlabFaces {
public:
  explicit SlabFaces(const AirGaps& air)
      : air_(air)
      , tall_(air.voxels(air.parameters().headroom))
      , above_(air.size(), none)
      , is_met_(air.size(), 0)
  {
    std::uint32_t below = none;
    for (std::uint32_t g = 0; g < air.size(); ++g) {
      gaps_.push_back(air[g]);
      if (air[g].high - air[g].low < tall_)
        continue;
      if (below != none && air[below].column == air[g].column)
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
  bool hasOneFace(std::uint32_t below) const
  {
    return above_[below] != none && air_[above_[below]].low - air_[below].high <
                                        air_.voxels(air_.parameters().thinnest_slab);
  }

  void completeRegion(std::uint32_t start)
  {
    RegionRim rim;
    const std::vector<std::uint32_t> region = regionFrom(start, rim);
    if (rim.floors.empty())
      return;
    constexpr double share_of_floor = 0.2; // of a rim; the rest may be furniture
    const double surface = rim.surfaces.highestCount();
    const double ceiling = rim.ceilings.highestCount();
    const double floor = rim.floors.lowestOf(share_of_floor);
    const bool is_ceiling = std::abs(surface - ceiling) < std::abs(surface - floor);
    const double seen = is_ceiling ? ceiling : floor;
    for (const std::uint32_t below : region) {
      AirGap& lower = gaps_[below];
      AirGap& upper = gaps_[above_[below]];
      if (std::abs(air_.columns().heightOf(lower.high) - seen) >
          air_.parameters().same_surface)
        continue; // of stairs
      const std::int32_t low = std::max(upper.low, voxelOf(floor));
      const std::int32_t high = std::min(lower.high, voxelOf(ceiling));
      if (is_ceiling && upper.high - low >= tall_) {
        upper.low = low;
        upper.floor_seen = false;
      }
      if (!is_ceiling && high - lower.low >= tall_) {
        lower.high = high;
        lower.ceiling_seen = false;
      }
    }
  }

  /** @brief The places with one face that hang together, and what is along their rim.
   */
  std::vector<std::uint32_t> regionFrom(std::uint32_t start, RegionRim& rim)
  {
    std::vector<std::uint32_t> region{start};
    is_met_[start] = 1;
    for (std::size_t k = 0; k < region.size(); ++k) {
      const AirGap& gap = air_[region[k]];
      rim.surfaces.add(air_.columns().heightOf(gap.high));
      for (int d = 0; d < 4; ++d) {
        const std::uint32_t o = slabBeside(region[k], d);
        if (o == none)
          continue;
        if (!hasOneFace(o)) {
          rim.ceilings.add(air_.columns().heightOf(air_[o].high));
          rim.floors.add(air_.columns().heightOf(air_[above_[o]].low));
        }
        else if (is_met_[o] == 0) {
          is_met_[o] = 1;
          region.push_back(o);
        }
      }
    }
    return region;
  }

  /** @brief The gap below the slab that goes on beside that above another gap. */
  std::uint32_t slabBeside(std::uint32_t below, int d) const
  {
    const std::uint32_t column = air_.columns().neighbour(air_[below].column, d);
    const std::uint32_t o = air_.overlapping(column, air_[below].low, air_[below].high);
    return o == none || above_[o] == none ? none : o;
  }

  std::int32_t voxelOf(double height) const
  {
    return air_.columns().voxelAt(height + air_.columns().voxelHeight() / 2);
  }

  const AirGaps& air_;
  std::int32_t tall_;                ///< voxels of headroom
  std::vector<std::uint32_t> above_; ///< of a tall gap: the next in its column
  std::vector<std::uint8_t> is_met_;
  std::vector<AirGap> gaps_;
};

} // namespace

std::vector<AirGap>
withBothFaces(const AirGaps& air)
{
  return SlabFaces(air).completed();
}

} // namespace sedr
} // namespace pcl
