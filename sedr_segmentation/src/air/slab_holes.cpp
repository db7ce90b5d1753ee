// SPDX-License-Identifier: BSD-3-Clause
#include "slab_holes.h"

#include "air_labelling.h"

#include <cstddef>
#include <cstdint>

namespace pcl::sedr {

namespace {

/** @brief A slab between two gaps of a column with headroom. */
struct Slab {
  std::int32_t ceiling = 0; ///< of the lower, AirGap::high
  std::int32_t floor = 0;   ///< of the upper, AirGap::low
};

/** @brief Gaps that reach through slabs, outwards from these. */
class SlabHoles {
public:
  explicit SlabHoles(const AirGaps& air)
      : air_(air)
      , slab_(air.size())
      , place_(air.size(), AirGaps::none)
  {
    for (std::uint32_t g = 0; g < air.size(); ++g)
      for (int d = 0; d < 4 && place_[g] == AirGaps::none; ++d)
        if (findSlabBeside(g, d, slab_[g]))
          add(g);
    for (std::size_t k = 0; k < places_.size(); ++k)
      for (int d = 0; d < 4; ++d)
        forEachBeside(places_[k], d, [&](std::uint32_t o) {
          if (place_[o] == AirGaps::none) {
            slab_[o] = slab_[places_[k]];
            add(o);
          }
        });
  }

  std::vector<AirGap> closed()
  {
    std::vector<AirGap> gaps;
    const std::vector<std::uint8_t> is_hole = holes();
    for (std::uint32_t g = 0; g < air_.size(); ++g) {
      gaps.push_back(air_[g]);
      if (place_[g] == AirGaps::none || is_hole[place_[g]] == 0)
        continue;
      gaps.back().high = slab_[g].ceiling;
      gaps.back().ceiling_seen = false;
      gaps.push_back(air_[g]);
      gaps.back().low = slab_[g].floor;
      gaps.back().floor_seen = false;
    }
    return gaps;
  }

private:
  void add(std::uint32_t g)
  {
    place_[g] = static_cast<std::uint32_t>(places_.size());
    places_.push_back(g);
  }

  /** @brief Whether a gap reaches through a slab, with headroom on both sides. */
  bool reachesThrough(std::uint32_t g, const Slab& slab) const
  {
    return air_.hasHeadroom(air_[g].low, slab.ceiling) &&
           air_.hasHeadroom(slab.floor, air_[g].high);
  }

  bool findSlabBeside(std::uint32_t g, int d, Slab& slab) const
  {
    const std::uint32_t column = air_.columns().neighbour(air_[g].column, d);
    if (column == VoxelColumns::none)
      return false;
    bool has_lower = false;
    for (std::size_t o = air_.first(column); o < air_.first(column + 1); ++o) {
      if (!air_.isTall(air_[o]))
        continue;
      slab.floor = air_[o].low;
      if (has_lower && reachesThrough(g, slab))
        return true;
      has_lower = true;
      slab.ceiling = air_[o].high;
    }
    return false;
  }

  /** @brief Visits the gaps that reach through the slab of a gap in direction d. */
  template <typename Visitor>
  void forEachBeside(std::uint32_t g, int d, Visitor visit) const
  {
    const std::uint32_t column = air_.columns().neighbour(air_[g].column, d);
    if (column == VoxelColumns::none)
      return;
    for (auto o = static_cast<std::uint32_t>(air_.first(column));
         o < air_.first(column + 1); ++o)
      if (reachesThrough(o, slab_[g]))
        visit(o);
  }

  /** @brief Of each place whether it is a hole in what was seen of the slab, which ends
   * it on all sides: at walls, too. */
  std::vector<std::uint8_t> holes() const
  {
    AirLabelling labelling(places_.size(), air_);
    for (std::size_t k = 0; k < places_.size(); ++k) {
      labelling.addUnseen(k);
      for (int d = 0; d < 4; ++d) {
        bool goes_on = false;
        forEachBeside(places_[k], d, [&](std::uint32_t o) {
          labelling.addOther(k, place_[o]);
          goes_on = true;
        });
        if (!goes_on)
          labelling.addKnown(k);
      }
    }
    return labelling.solve();
  }

  const AirGaps& air_;
  std::vector<Slab> slab_;            ///< of each gap that reaches through one
  std::vector<std::uint32_t> place_;  ///< of each gap that does, its number
  std::vector<std::uint32_t> places_; ///< those gaps
};

} // namespace

std::vector<AirGap>
withSlabsClosed(const AirGaps& air)
{
  return SlabHoles(air).closed();
}

} // namespace pcl::sedr
