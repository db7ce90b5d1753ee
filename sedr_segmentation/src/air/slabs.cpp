// SPDX-License-Identifier: BSD-3-Clause
#include "slabs.h"

#include "ceiling_dip.h"
#include "height_counts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Heights of the faces of a slab: where the gap below it ends, and that above
 * begins. */
using Slab = std::array<double, 2>;

class Slabs {
public:
  explicit Slabs(const AirGaps& air)
      : air_(air)
      , above_(air.size(), AirGaps::none)
      , slab_(air.size())
      , is_met_(air.size(), 0)
  {
    std::uint32_t below = AirGaps::none;
    for (std::uint32_t g = 0; g < air.size(); ++g) {
      gaps_.push_back(air[g]);
      if (!air.isTall(air[g]))
        continue;
      if (below != AirGaps::none && air[below].column == air[g].column) {
        above_[below] = g;
        slab_[below] = {air.columns().heightOf(air[below].high),
                        air.columns().heightOf(air[g].low)};
        places_.push_back(below);
      }
      below = g;
    }
  }

  /** @brief Closes the holes of at most AirParameters::largest_hole. */
  std::vector<AirGap> withHolesClosed()
  {
    const double cell = air_.columns().cellSize();
    findThrough();
    forEachRegion(true, [&](const auto& region, const auto& /*rim*/) {
      if (static_cast<double>(region.size()) * cell * cell <=
          air_.parameters().largest_hole)
        for (const std::uint32_t g : region)
          moveApart(g, slab_[g], {true, true});
    });
    return std::move(gaps_);
  }

  /** @brief Takes the faces that were not seen from the rim along which the others go
   * on. Slabs are measured from the ceiling beside beams, less than four slabs wide. */
  std::vector<AirGap> withBothFaces()
  {
    const std::vector<float> ceiling = closedCeiling(
        air_, static_cast<int>(std::lround(2 * air_.parameters().thinnest_slab /
                                           air_.columns().cellSize())));
    for (const std::uint32_t g : places_)
      slab_[g][0] = ceiling[g];
    forEachRegion(
        false, [&](const auto& region, const auto& rim) { completeFace(region, rim); });
    return std::move(gaps_);
  }

private:
  /** @brief Finds the gaps that reach through slabs, outwards from these. */
  void findThrough()
  {
    for (std::size_t k = 0; k < places_.size(); ++k)
      for (int d = 0; d < 4; ++d) {
        const std::uint32_t g = places_[k];
        const std::uint32_t o = beside(g, d);
        if (o == AirGaps::none || isThrough(o) || !reachesThrough(o, slab_[g]))
          continue;
        above_[o] = o;
        slab_[o] = slab_[g];
        places_.push_back(o);
      }
  }

  /** @brief Whether a gap reaches through a slab, with headroom on both sides. */
  bool reachesThrough(std::uint32_t g, const Slab& slab) const
  {
    return air_.hasHeadroom(air_[g].low, air_.voxels(slab[0])) &&
           air_.hasHeadroom(air_.voxels(slab[1]), air_[g].high);
  }

  bool isThrough(std::uint32_t g) const { return above_[g] == g; }

  bool hasBothFaces(std::uint32_t g) const
  {
    return !isThrough(g) &&
           slab_[g][1] - slab_[g][0] >
               air_.parameters().thinnest_slab - air_.columns().voxelHeight() / 2;
  }

  /** @brief The gap in which the air below a slab goes on. */
  std::uint32_t beside(std::uint32_t g, int d) const
  {
    AirGap below = air_[g];
    if (isThrough(g))
      below.high = air_.voxels(slab_[g][0]);
    return air_.goingOnFrom(below, air_.columns().neighbour(below.column, d));
  }

  /** @brief Visits each region of which nothing of a slab was seen (`is_through`), or
   * one face, with the slabs that have both faces along its rim. A region too deep
   * behind these is no slab of which a face is hidden, but has none. */
  template <typename Visitor>
  void forEachRegion(bool is_through, Visitor visit)
  {
    constexpr double deepest = 2; // metres: area over length of rim
    for (const std::uint32_t g : places_)
      if (!hasBothFaces(g) && isThrough(g) == is_through && is_met_[g] == 0) {
        std::vector<Slab> rim;
        const std::vector<std::uint32_t> region = regionFrom(g, rim);
        if (static_cast<double>(region.size()) * air_.columns().cellSize() <
            deepest * static_cast<double>(rim.size()))
          visit(region, rim);
      }
  }

  std::vector<std::uint32_t> regionFrom(std::uint32_t start, std::vector<Slab>& rim)
  {
    std::vector<std::uint32_t> region{start};
    is_met_[start] = 1;
    for (std::size_t k = 0; k < region.size(); ++k)
      for (int d = 0; d < 4; ++d) {
        const std::uint32_t o = beside(region[k], d);
        if (o == AirGaps::none || above_[o] == AirGaps::none)
          continue;
        if (hasBothFaces(o))
          rim.push_back(slab_[o]);
        else if (isThrough(o) == isThrough(start) && is_met_[o] == 0 &&
                 (!isThrough(o) || reachesThrough(o, slab_[region[k]]))) {
          is_met_[o] = 1;
          region.push_back(o);
        }
      }
    return region;
  }

  void completeFace(const std::vector<std::uint32_t>& region,
                    const std::vector<Slab>& rim)
  {
    constexpr double share_of_floor = 0.2; // of a rim; the rest may be furniture
    std::array<HeightCounts, 2> heights;
    for (const std::uint32_t g : region)
      for (std::size_t side = 0; side < 2; ++side)
        heights[side].add(slab_[g][side]);
    const Slab seen{heights[0].highestCount(), heights[1].highestCount()};
    std::array<std::size_t, 2> goes_on{0, 0};
    std::array<HeightCounts, 2> others;
    for (const Slab& slab : rim)
      for (std::size_t side = 0; side < 2; ++side)
        if (std::abs(slab[side] - seen[side]) < air_.parameters().thinnest_slab / 2) {
          ++goes_on[side];
          others[side].add(slab[1 - side]);
        }
    if (goes_on[0] + goes_on[1] == 0)
      return;
    const bool is_ceiling = goes_on[0] >= goes_on[1];
    const double other =
        is_ceiling ? others[0].lowestOf(share_of_floor) : others[1].highestCount();
    for (const std::uint32_t g : region)
      if (std::abs(slab_[g][0] - seen[0]) <=
          air_.parameters().same_surface) // else a tread of stairs
        moveApart(g, {other, other}, {!is_ceiling, is_ceiling});
  }

  /** @brief Ends the air of one or both storeys at a face that was not seen. */
  void
  moveApart(std::uint32_t g, const Slab& slab, const std::array<bool, 2>& is_unseen)
  {
    AirGap lower = gaps_[g];
    AirGap upper = gaps_[above_[g]];
    if (is_unseen[0])
      lower.high = std::min(lower.high, air_.voxels(slab[0]));
    if (is_unseen[1])
      upper.low = std::max(upper.low, air_.voxels(slab[1]));
    if (!air_.isTall(lower) || !air_.isTall(upper))
      return;
    lower.ceiling_seen = lower.ceiling_seen && !is_unseen[0];
    upper.floor_seen = upper.floor_seen && !is_unseen[1];
    gaps_[g] = lower;
    if (isThrough(g))
      gaps_.push_back(upper);
    else
      gaps_[above_[g]] = upper;
  }

  const AirGaps& air_;
  std::vector<std::uint32_t> above_; ///< of a tall gap: the next in its column; itself,
                                     ///< if it reaches through a slab
  std::vector<Slab> slab_;           ///< above such a gap, as far as it was seen
  std::vector<std::uint32_t> places_; ///< those gaps
  std::vector<std::uint8_t> is_met_;
  std::vector<AirGap> gaps_;
};

} // namespace

std::vector<AirGap>
withHolesClosed(const AirGaps& air)
{
  return Slabs(air).withHolesClosed();
}

std::vector<AirGap>
withBothFaces(const AirGaps& air)
{
  return Slabs(air).withBothFaces();
}

} // namespace pcl::sedr
