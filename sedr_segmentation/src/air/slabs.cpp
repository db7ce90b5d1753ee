// SPDX-License-Identifier: BSD-3-Clause
#include "air_gaps.h"

#include "air_measures.h"
#include "height_counts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Heights of the faces of a slab: where the gap below it ends, and that above
 * begins. */
using Slab = std::array<double, 2>;

class Slabs {
public:
  /** @param above_things whether slabs also lie above the air over a table, in which
   * one cannot stand: what is low and above tall air is the void in a slab */
  Slabs(const AirGaps& air, bool above_things)
      : air_(air)
      , above_(air.size(), AirGaps::none)
      , slab_(air.size())
      , is_met_(air.size(), 0)
  {
    std::uint32_t below = AirGaps::none;
    for (std::uint32_t g = 0; g < air.size(); ++g) {
      gaps_.push_back(air[g]);
      if (below != AirGaps::none && air[below].column != air[g].column)
        below = AirGaps::none;
      if (air.isTall(air[g])) {
        if (below != AirGaps::none) {
          above_[below] = g;
          slab_[below] = {air.columns().heightOf(air[below].high),
                          air.columns().heightOf(air[g].low)};
          places_.push_back(below);
        }
        below = g;
      }
      else if (above_things && 2 * air.height(g) >= air.parameters().headroom &&
               (below == AirGaps::none || !air.isTall(air[below])))
        below = g;
    }
  }

  /** @brief Closes the holes of at most AirParameters::largest_hole. */
  std::vector<AirGap> withHolesClosed()
  {
    const double cell = air_.columns().cellSize();
    findThrough();
    forEachRegion(true, [&](const auto& region, const auto& rim) {
      if (!rim.empty() && static_cast<double>(region.size()) * cell * cell <=
                              air_.parameters().largest_hole)
        for (const std::uint32_t g : region)
          moveApart(g, slab_[g], {true, true});
    });
    return std::move(gaps_);
  }

  /** @brief Takes the faces that were not seen from slabs of which both were. These are
   * measured from the ceiling beside beams, less than four slabs wide. */
  std::vector<AirGap> withBothFaces()
  {
    const std::vector<float> ceiling = closedCeiling(
        air_, static_cast<int>(std::lround(2 * air_.parameters().thinnest_slab /
                                           air_.columns().cellSize())));
    for (const std::uint32_t g : places_)
      slab_[g][0] = ceiling[g];
    for (const std::uint32_t g : places_)
      for (const std::size_t side : {0, 1})
        if (hasBothFaces(g))
          other_faces_[side][air_.voxels(slab_[g][side])].add(slab_[g][1 - side]);
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
   * one face, with the slabs that have both faces along its rim. */
  template <typename Visitor>
  void forEachRegion(bool is_through, Visitor visit)
  {
    for (const std::uint32_t g : places_)
      if (!hasBothFaces(g) && isThrough(g) == is_through && is_met_[g] == 0) {
        std::vector<Slab> rim;
        const std::vector<std::uint32_t> region = regionFrom(g, rim);
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
                 (isThrough(o) ? reachesThrough(o, slab_[region[k]])
                               : std::abs(slab_[o][0] - slab_[region[k]][0]) <=
                                     air_.parameters().same_ceiling)) {
          is_met_[o] = 1;
          region.push_back(o);
        }
      }
    return region;
  }

  /** @brief Heights of the other faces of all slabs of which one lies at a height. */
  HeightCounts otherFaces(std::size_t side, double height) const
  {
    HeightCounts others;
    const auto& at = other_faces_[side];
    const int middle = air_.voxels(height);
    const int reach = air_.voxels(air_.parameters().thinnest_slab / 2);
    for (auto of = at.lower_bound(middle - reach); of != at.upper_bound(middle + reach);
         ++of)
      others.add(of->second);
    return others;
  }

  void completeFace(const std::vector<std::uint32_t>& region,
                    const std::vector<Slab>& rim)
  {
    constexpr double deepest = 2; // metres behind slabs: area over length of rim
    std::array<HeightCounts, 2> heights;
    for (const std::uint32_t g : region)
      for (const std::size_t side : {0, 1})
        heights[side].add(slab_[g][side]);
    const Slab seen{heights[0].highestCount(), heights[1].highestCount()};
    const auto goesOn = [&](const Slab& slab, std::size_t side) {
      return std::abs(slab[side] - seen[side]) < air_.parameters().thinnest_slab / 2;
    };
    std::array<double, 2> goes_on{};
    for (const std::size_t side : {0, 1}) {
      for (const Slab& slab : rim)
        goes_on[side] += goesOn(slab, side) ? 1 : 0;
      if (rim.empty())
        goes_on[side] = otherFaces(side, seen[side]).total();
    }
    if (static_cast<double>(region.size()) * air_.columns().cellSize() >=
        deepest * (goes_on[0] + goes_on[1]))
      return;
    const bool is_ceiling = goes_on[0] >= goes_on[1];
    if (rim.empty() && !is_ceiling)
      return; // as thin as it looks: a gallery
    const std::size_t side = is_ceiling ? 0 : 1;
    const double other = otherFaces(side, seen[side]).highestCount();
    for (const std::uint32_t g : region)
      if (goesOn(slab_[g], 1)) // else a tread of stairs
        moveApart(g, {other, other}, {!is_ceiling, is_ceiling});
  }

  /** @brief Ends the air of one or both storeys at a face that was not seen. */
  void
  moveApart(std::uint32_t g, const Slab& slab, const std::array<bool, 2>& is_unseen)
  {
    AirGap lower = gaps_[g];
    AirGap upper = gaps_[above_[g]];
    lower.ceiling_seen = lower.ceiling_seen && !is_unseen[0];
    upper.floor_seen = upper.floor_seen && !is_unseen[1];
    if (const auto at = air_.voxels(slab[0]);
        is_unseen[0] && air_.hasHeadroom(lower.low, at))
      lower.high = std::min(lower.high, at);
    if (const auto at = air_.voxels(slab[1]);
        is_unseen[1] && air_.hasHeadroom(at, upper.high))
      upper.low = std::max(upper.low, at);
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
  /// Of lower and upper faces, by voxel: the heights of the other face.
  std::array<std::map<int, HeightCounts>, 2> other_faces_;
};

} // namespace

std::vector<AirGap>
withHolesClosed(const AirGaps& air)
{
  return Slabs(air, false).withHolesClosed();
}

std::vector<AirGap>
withBothFaces(const AirGaps& air)
{
  return Slabs(air, true).withBothFaces();
}

} // namespace pcl::sedr
