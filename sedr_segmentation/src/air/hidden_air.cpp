// SPDX-License-Identifier: BSD-3-Clause
#include "hidden_air.h"

#include "air_labelling.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Whether a wall stands in a column between two heights. */
bool
isWalled(const AirGaps& air, std::uint32_t column, const AirGap& gap)
{
  const AirParameters& parameters = air.parameters();
  const int skin = air.voxels(parameters.same_surface) / 2;
  return air.occupiedShare(column, gap.low + skin, gap.high - skin) >
         parameters.walled_share;
}

/** @brief The voxel of a surface of a column nearest to `at`, no farther than the same
 * surface may be; looked for upwards (+1) or downwards (-1) first.
 * @return whether there is one */
bool
surfaceNear(const AirGaps& air,
            std::uint32_t column,
            std::int32_t at,
            std::int32_t& found)
{
  const int reach = air.voxels(air.parameters().same_surface);
  for (int away = 0; away <= reach; ++away)
    for (const int sign : {1, -1})
      if (air.columns().isOccupied(column, at + sign * away)) {
        found = at + sign * away;
        return true;
      }
  return false;
}

/** @brief A gap whose ends were taken from its neighbours, with those that were seen in
 * its own column. */
AirGap
withSeenEnds(const AirGaps& air, AirGap gap)
{
  std::int32_t at = 0;
  gap.floor_seen = surfaceNear(air, gap.column, gap.low - 1, at);
  if (gap.floor_seen)
    gap.low = at + 1;
  gap.ceiling_seen = surfaceNear(air, gap.column, gap.high, at);
  if (gap.ceiling_seen)
    gap.high = at;
  return gap;
}

/** @brief A gap with its high end below what hangs from the ceiling, thicker than a
 * surface: a wall of which furniture hides the foot, a beam or a pipe. */
AirGap
belowHanging(const AirGaps& air, AirGap gap)
{
  std::int32_t foot = gap.high;
  while (air.columns().isOccupied(gap.column, foot - 1))
    --foot;
  if (gap.high - foot > air.voxels(air.parameters().same_surface))
    gap.high = foot;
  return gap;
}

/** @brief Whether an end of a gap was seen. */
bool
isSeen(const AirGap& gap)
{
  return gap.floor_seen || gap.ceiling_seen;
}

/** @brief Grows air to where an end of it is hidden, and tells which of that is air. */
class HiddenAir {
public:
  explicit HiddenAir(const AirGaps& air)
      : air_(air)
      , last_(air.columns().size(), -1)
  {
    std::vector<Front> front;
    for (std::size_t g = 0; g < air.size(); ++g)
      if (air.isTall(air[g]))
        front.push_back({air[g], 0});
    grow(std::move(front));
  }

  std::vector<AirGap> air() const
  {
    AirLabelling labelling(places_.size(), air_);
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const AirGap& place = places_[k];
      if (!isSeen(place))
        labelling.addUnseen(k);
      for (int d = 0; d < 4; ++d) {
        const std::uint32_t column = air_.columns().neighbour(place.column, d);
        const std::ptrdiff_t other =
            column == VoxelColumns::none ? -1 : placeIn(column, place);
        if (other >= 0)
          labelling.addOther(k, static_cast<std::size_t>(other),
                             isSeen(place) ==
                                 isSeen(places_[static_cast<std::size_t>(other)]));
        else if (column == VoxelColumns::none)
          labelling.addOpen(k);
        else if (air_.goingOnFrom(place, column) != AirGaps::none)
          labelling.addKnown(k);
        else if (isSeen(place) && isWalled(air_, column, place))
          labelling.addEnd(k); // what was not seen beside a wall may be in it
        else
          labelling.addOpen(k);
      }
    }
    const std::vector<std::uint8_t> is_air = labelling.solve();
    std::vector<AirGap> found;
    for (std::size_t k = 0; k < places_.size(); ++k)
      if (is_air[k] != 0)
        found.push_back(places_[k]);
    return found;
  }

private:
  /** @brief Air that goes on, and over how many columns nothing of it was seen. */
  struct Front {
    AirGap gap;
    int unseen;
  };

  /** @brief The place in a column that overlaps a gap by half of the lower, or -1. */
  std::ptrdiff_t placeIn(std::uint32_t column, const AirGap& like) const
  {
    for (std::int32_t at = last_[column]; at >= 0;
         at = before_[static_cast<std::size_t>(at)]) {
      const AirGap& gap = places_[static_cast<std::size_t>(at)];
      const std::int32_t common =
          std::min(gap.high, like.high) - std::max(gap.low, like.low);
      if (common > 0 &&
          2 * common >= std::min(gap.high - gap.low, like.high - like.low))
        return at;
    }
    return -1;
  }

  /** @brief Whether air may go on from a gap to a column in which none was seen. */
  bool mayGoOn(const AirGap& gap, std::uint32_t column) const
  {
    return column != VoxelColumns::none &&
           air_.goingOnFrom(gap, column) == AirGaps::none && placeIn(column, gap) < 0 &&
           !isWalled(air_, column, gap);
  }

  /** @brief Grows air outwards, so that each place takes its missing end from the air
   * nearest to it, as far into what was not seen as may be closed. Behind what hangs
   * from the ceiling it goes on as high as before. */
  void grow(std::vector<Front> front)
  {
    constexpr double reach = 2.5; // radius of a round patch over its area over its edge
    const auto farthest = static_cast<int>(std::lround(
        reach * air_.parameters().largest_unseen / air_.columns().cellSize()));
    while (!front.empty()) {
      std::vector<Front> next;
      for (const auto& [gap, unseen] : front)
        for (int d = 0; d < 4; ++d) {
          const std::uint32_t column = air_.columns().neighbour(gap.column, d);
          if (!mayGoOn(gap, column))
            continue;
          const AirGap seen =
              withSeenEnds(air_, {column, gap.low, gap.high, false, false});
          const AirGap place = belowHanging(air_, seen);
          const int so_far = isSeen(place) ? 0 : unseen + 1;
          if (!air_.isTall(place) || so_far > farthest)
            continue;
          add(place);
          next.push_back({seen, so_far});
        }
      front = std::move(next);
    }
  }

  void add(const AirGap& place)
  {
    before_.push_back(last_[place.column]);
    last_[place.column] = static_cast<std::int32_t>(places_.size());
    places_.push_back(place);
  }

  const AirGaps& air_;
  std::vector<AirGap> places_;
  std::vector<std::int32_t> last_;   ///< of each column, -1 for none
  std::vector<std::int32_t> before_; ///< of each place, in its column
};

} // namespace

std::vector<AirGap>
hiddenAirOf(const AirGaps& air)
{
  return HiddenAir(air).air();
}

} // namespace pcl::sedr
