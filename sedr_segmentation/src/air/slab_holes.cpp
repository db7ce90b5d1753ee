// SPDX-License-Identifier: BSD-3-Clause
#include "slab_holes.h"

#include <cstddef>
#include <cstdint>

namespace pcl::sedr {

namespace {

/** @brief A slab between two gaps of a column with headroom. */
struct Slab {
  std::int32_t ceiling = 0; ///< of the lower, AirGap::high
  std::int32_t floor = 0;   ///< of the upper, AirGap::low
};

class SlabHoles {
public:
  explicit SlabHoles(const AirGaps& air)
      : air_(air)
      , tall_(air.voxels(air.parameters().headroom))
      , slab_(air.size())
      , is_through_(air.size(), 0)
  {
    for (std::uint32_t g = 0; g < air.size(); ++g)
      for (int d = 0; d < 4; ++d)
        if (is_through_[g] == 0 && findSlabBeside(g, d))
          front_.push_back(g);
    for (std::size_t k = 0; k < front_.size(); ++k)
      goOnFrom(front_[k]);
  }

  std::vector<AirGap> closed()
  {
    std::vector<AirGap> gaps;
    const std::vector<std::uint8_t> is_hole = holes();
    for (std::uint32_t g = 0; g < air_.size(); ++g) {
      if (is_hole[g] == 0) {
        gaps.push_back(air_[g]);
        continue;
      }
      AirGap below = air_[g];
      AirGap above = air_[g];
      below.high = slab_[g].ceiling;
      above.low = slab_[g].floor;
      below.ceiling_seen = above.floor_seen = false;
      gaps.push_back(below);
      gaps.push_back(above);
    }
    return gaps;
  }

private:
  /** @brief Whether a gap reaches through a slab, with headroom on both sides. */
  bool reachesThrough(std::uint32_t g, const Slab& slab) const
  {
    return slab.ceiling - air_[g].low >= tall_ && air_[g].high - slab.floor >= tall_;
  }

  bool findSlabBeside(std::uint32_t g, int d)
  {
    const std::uint32_t column = air_.columns().neighbour(air_[g].column, d);
    if (column == VoxelColumns::none)
      return false;
    bool has_lower = false;
    Slab slab;
    for (std::size_t o = air_.first(column); o < air_.first(column + 1); ++o) {
      if (air_[o].high - air_[o].low < tall_)
        continue;
      slab.floor = air_[o].low;
      if (has_lower && reachesThrough(g, slab)) {
        slab_[g] = slab;
        is_through_[g] = 1;
        return true;
      }
      has_lower = true;
      slab.ceiling = air_[o].high;
    }
    return false;
  }

  template <typename Visitor>
  void forEachBeside(std::uint32_t g, Visitor visit) const
  {
    for (int d = 0; d < 4; ++d) {
      const std::uint32_t column = air_.columns().neighbour(air_[g].column, d);
      if (column == VoxelColumns::none)
        continue;
      for (std::size_t o = air_.first(column); o < air_.first(column + 1); ++o)
        if (reachesThrough(static_cast<std::uint32_t>(o), slab_[g]))
          visit(static_cast<std::uint32_t>(o));
    }
  }

  void goOnFrom(std::uint32_t g)
  {
    forEachBeside(g, [&](std::uint32_t o) {
      if (is_through_[o] != 0)
        return;
      slab_[o] = slab_[g];
      is_through_[o] = 1;
      front_.push_back(o);
    });
  }

  /** @brief The gaps of holes that are small enough: 1 for each. */
  std::vector<std::uint8_t> holes() const
  {
    const double cell = air_.columns().cellSize();
    const double largest = air_.parameters().largest_hole / (cell * cell);
    std::vector<std::uint8_t> is_met(air_.size(), 0);
    std::vector<std::uint8_t> is_hole(air_.size(), 0);
    for (const std::uint32_t start : front_) {
      if (is_met[start] != 0)
        continue;
      std::vector<std::uint32_t> hole{start};
      is_met[start] = 1;
      for (std::size_t k = 0; k < hole.size(); ++k)
        forEachBeside(hole[k], [&](std::uint32_t o) {
          if (is_through_[o] != 0 && is_met[o] == 0) {
            is_met[o] = 1;
            hole.push_back(o);
          }
        });
      if (static_cast<double>(hole.size()) <= largest)
        for (const std::uint32_t g : hole)
          is_hole[g] = 1;
    }
    return is_hole;
  }

  const AirGaps& air_;
  std::int32_t tall_;
  std::vector<Slab> slab_;               ///< of each gap that reaches through one
  std::vector<std::uint8_t> is_through_; ///< whether it does
  std::vector<std::uint32_t> front_;     ///< those, outwards from the slabs
};

} // namespace

std::vector<AirGap>
withSlabsClosed(const AirGaps& air)
{
  return SlabHoles(air).closed();
}

} // namespace pcl::sedr
