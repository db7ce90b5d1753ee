// SPDX-License-Identifier: BSD-3-Clause
#include "air_holes.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Whether a wall stands in a column between two heights. */
bool
isWalled(const AirGaps& air, std::uint32_t column, std::int32_t low, std::int32_t high)
{
  const AirParameters& parameters = air.parameters();
  const int skin = air.voxels(parameters.same_surface) / 2;
  return air.occupiedShare(column, low + skin, high - skin) > parameters.walled_share;
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

/** @brief Gaps that are added, found by column. */
class AddedGaps {
public:
  explicit AddedGaps(const VoxelColumns& columns)
      : last_(columns.size(), -1)
  {}

  /** @brief Position of one of a column that overlaps by half of the lower, or -1. */
  std::ptrdiff_t find(std::uint32_t column, std::int32_t low, std::int32_t high) const
  {
    for (std::int32_t at = last_[column]; at >= 0;
         at = before_[static_cast<std::size_t>(at)]) {
      const AirGap& gap = gaps_[static_cast<std::size_t>(at)];
      const std::int32_t common = std::min(gap.high, high) - std::max(gap.low, low);
      if (common > 0 && 2 * common >= std::min(gap.high - gap.low, high - low))
        return at;
    }
    return -1;
  }

  void add(const AirGap& gap)
  {
    before_.push_back(last_[gap.column]);
    last_[gap.column] = static_cast<std::int32_t>(gaps_.size());
    gaps_.push_back(gap);
  }

  std::vector<AirGap>& all() { return gaps_; }

private:
  std::vector<AirGap> gaps_;
  std::vector<std::int32_t> last_;   ///< of each column, -1 for none
  std::vector<std::int32_t> before_; ///< of each gap, in its column
};

bool
isTall(const AirGaps& air, const AirGap& gap)
{
  return gap.high - gap.low >= air.voxels(air.parameters().headroom);
}

/** @brief Whether no gap of a column goes on from another. */
bool
isMissing(const AirGaps& air, std::uint32_t column, const AirGap& beside)
{
  return column != VoxelColumns::none &&
         air.goingOnFrom(beside, column) == AirGaps::none;
}

/** @brief Grows air to where an end of it is hidden, and tells which of that is
 * enclosed. */
class EnclosedHoles {
public:
  explicit EnclosedHoles(const AirGaps& air)
      : air_(air)
      , holes_(air.columns())
      , blank_(air.columns())
  {
    std::vector<AirGap> front;
    for (std::size_t g = 0; g < air.size(); ++g)
      if (isTall(air, air[g]))
        front.push_back(air[g]);
    grow(std::move(front));
    addBlanks();
  }

  std::vector<AirGap> enclosed()
  {
    const std::vector<AirGap>& holes = holes_.all();
    region_.assign(holes.size(), -1);
    for (std::size_t start = 0; start < holes.size(); ++start)
      if (region_[start] < 0)
        collectRegion(start);
    std::vector<AirGap> enclosed;
    for (std::size_t k = 0; k < holes.size(); ++k) {
      const Rim& rim = rims_[static_cast<std::size_t>(region_[k])];
      const auto all = static_cast<double>(rim.known + rim.walled + rim.open);
      if (static_cast<double>(rim.known) >= air_.parameters().min_known * all &&
          static_cast<double>(rim.open) <= air_.parameters().max_open * all)
        enclosed.push_back(holes[k]);
    }
    return enclosed;
  }

private:
  /** @brief What is along the rim of a region of holes. */
  struct Rim {
    std::size_t known = 0;
    std::size_t walled = 0;
    std::size_t open = 0;
  };

  /** @brief Whether air may go on from a gap to a column in which none was seen. */
  bool mayGoOn(const AirGap& gap, std::uint32_t column) const
  {
    return isMissing(air_, column, gap) && holes_.find(column, gap.low, gap.high) < 0 &&
           !isWalled(air_, column, gap.low, gap.high);
  }

  /** @brief Grows air outwards, so that each hole takes its missing end from the air
   * nearest to it; where neither end was seen it stops. Behind what hangs from the
   * ceiling it goes on as high as before. */
  void grow(std::vector<AirGap> front)
  {
    while (!front.empty()) {
      std::vector<AirGap> next;
      for (const AirGap& gap : front)
        for (int d = 0; d < 4; ++d) {
          const std::uint32_t column = air_.columns().neighbour(gap.column, d);
          if (!mayGoOn(gap, column))
            continue;
          const AirGap seen =
              withSeenEnds(air_, {column, gap.low, gap.high, false, false});
          const AirGap hole = belowHanging(air_, seen);
          if (!isTall(air_, hole))
            continue;
          if (!hole.floor_seen && !hole.ceiling_seen) {
            blanks_.push_back(seen);
            continue;
          }
          holes_.add(hole);
          next.push_back(seen);
        }
      front = std::move(next);
    }
  }

  /** @brief Adds the blank patches that air surrounds and that are as small as what a
   * scanner does not see, below and above itself. */
  void addBlanks()
  {
    for (const AirGap& start : blanks_)
      for (const AirGap& gap : blankPatch(start))
        holes_.add(gap);
  }

  /** @brief The blank patch around a gap; none if it was met before, goes on too far or
   * air does not surround it. */
  std::vector<AirGap> blankPatch(const AirGap& start)
  {
    if (holes_.find(start.column, start.low, start.high) >= 0 ||
        blank_.find(start.column, start.low, start.high) >= 0)
      return {};
    const double cell = air_.columns().cellSize();
    const auto most =
        static_cast<std::size_t>(air_.parameters().largest_blank / (cell * cell));
    const std::size_t first = blank_.all().size();
    blank_.add(start);
    bool is_open = false;
    for (std::size_t k = first; k < blank_.all().size() && !is_open; ++k)
      is_open = blank_.all().size() - first > most || !growBlank(k, first);
    if (is_open)
      return {};
    return {blank_.all().begin() + static_cast<std::ptrdiff_t>(first),
            blank_.all().end()};
  }

  /** @brief Adds the blank neighbours of a blank gap to its patch.
   * @param first of the patch
   * @return false where something else than air is beside it, or a patch that went too
   * far */
  bool growBlank(std::size_t k, std::size_t first)
  {
    const AirGap gap = blank_.all()[k];
    for (int d = 0; d < 4; ++d) {
      const std::uint32_t column = air_.columns().neighbour(gap.column, d);
      if (column == VoxelColumns::none)
        return false;
      const std::ptrdiff_t met = blank_.find(column, gap.low, gap.high);
      if (met >= static_cast<std::ptrdiff_t>(first) ||
          holes_.find(column, gap.low, gap.high) >= 0 || !isMissing(air_, column, gap))
        continue;
      if (met >= 0 || isWalled(air_, column, gap.low, gap.high))
        return false;
      const AirGap next = withSeenEnds(air_, {column, gap.low, gap.high, false, false});
      if (next.floor_seen || next.ceiling_seen)
        return false;
      blank_.add(next);
    }
    return true;
  }

  void collectRegion(std::size_t start)
  {
    const auto number = static_cast<std::ptrdiff_t>(rims_.size());
    rims_.emplace_back();
    std::vector<std::size_t> pending{start};
    region_[start] = number;
    while (!pending.empty()) {
      const AirGap hole = holes_.all()[pending.back()];
      pending.pop_back();
      for (int d = 0; d < 4; ++d) {
        const std::uint32_t column = air_.columns().neighbour(hole.column, d);
        const std::ptrdiff_t other = column == VoxelColumns::none
                                         ? -1
                                         : holes_.find(column, hole.low, hole.high);
        if (other < 0)
          ++endAt(column, hole);
        else if (region_[static_cast<std::size_t>(other)] < 0) {
          region_[static_cast<std::size_t>(other)] = number;
          pending.push_back(static_cast<std::size_t>(other));
        }
      }
    }
  }

  /** @brief The count of the last rim for what a hole ends at in a column. */
  std::size_t& endAt(std::uint32_t column, const AirGap& hole)
  {
    Rim& rim = rims_.back();
    if (column == VoxelColumns::none)
      return rim.open;
    if (!isMissing(air_, column, hole))
      return rim.known;
    return isWalled(air_, column, hole.low, hole.high) ? rim.walled : rim.open;
  }

  const AirGaps& air_;
  AddedGaps holes_;
  AddedGaps blank_;            ///< gaps of blank patches, of those that go too far too
  std::vector<AirGap> blanks_; ///< at which growing has stopped
  std::vector<std::ptrdiff_t> region_; ///< of each hole
  std::vector<Rim> rims_;              ///< of each region
};

} // namespace

std::vector<AirGap>
enclosedHolesOf(const AirGaps& air)
{
  return EnclosedHoles(air).enclosed();
}

} // namespace pcl::sedr
