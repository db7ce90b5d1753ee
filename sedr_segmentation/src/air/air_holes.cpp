// SPDX-License-Identifier: BSD-3-Clause
#include "air_holes.h"

#include <algorithm>
#include <cstdlib>

namespace pcl {
namespace sedr {

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

/** @brief Whether no gap of a column overlaps another one by half. */
bool
isMissing(const AirGaps& air, std::uint32_t column, const AirGap& beside)
{
  return column != VoxelColumns::none &&
         air.overlapping(column, beside.low, beside.high) == AirGaps::none;
}

} // namespace

std::vector<AirGap>
enclosedHolesOf(const AirGaps& air)
{
  const VoxelColumns& columns = air.columns();
  AddedGaps added(air.columns());
  std::vector<AirGap> front;
  for (std::size_t g = 0; g < air.size(); ++g)
    if (isTall(air, air[g]))
      front.push_back(air[g]);
  // Outwards, so that each hole takes its missing end from the air nearest to it.
  while (!front.empty()) {
    std::vector<AirGap> next;
    for (const AirGap& gap : front)
      for (int d = 0; d < 4; ++d) {
        const std::uint32_t column = columns.neighbour(gap.column, d);
        if (!isMissing(air, column, gap) ||
            added.find(column, gap.low, gap.high) >= 0 ||
            isWalled(air, column, gap.low, gap.high))
          continue;
        const AirGap hole =
            withSeenEnds(air, {column, gap.low, gap.high, false, false});
        if ((!hole.floor_seen && !hole.ceiling_seen) || !isTall(air, hole))
          continue;
        added.add(hole);
        next.push_back(hole);
      }
    front = std::move(next);
  }
  // Regions of holes, and what is along the rim of each.
  std::vector<AirGap>& holes = added.all();
  std::vector<std::ptrdiff_t> region(holes.size(), -1);
  struct Rim {
    std::size_t known = 0;
    std::size_t walled = 0;
    std::size_t open = 0;
  };
  std::vector<Rim> rims;
  for (std::size_t start = 0; start < holes.size(); ++start) {
    if (region[start] >= 0)
      continue;
    const auto number = static_cast<std::ptrdiff_t>(rims.size());
    rims.emplace_back();
    std::vector<std::size_t> pending{start};
    region[start] = number;
    while (!pending.empty()) {
      const AirGap hole = holes[pending.back()];
      pending.pop_back();
      for (int d = 0; d < 4; ++d) {
        const std::uint32_t column = columns.neighbour(hole.column, d);
        Rim& rim = rims[static_cast<std::size_t>(number)];
        if (column == VoxelColumns::none) {
          ++rim.open;
          continue;
        }
        if (air.overlapping(column, hole.low, hole.high) != AirGaps::none) {
          ++rim.known;
          continue;
        }
        const std::ptrdiff_t other = added.find(column, hole.low, hole.high);
        if (other < 0) {
          ++(isWalled(air, column, hole.low, hole.high) ? rim.walled : rim.open);
        }
        else if (region[static_cast<std::size_t>(other)] < 0) {
          region[static_cast<std::size_t>(other)] = number;
          pending.push_back(static_cast<std::size_t>(other));
        }
      }
    }
  }
  std::vector<AirGap> enclosed;
  for (std::size_t k = 0; k < holes.size(); ++k) {
    const Rim& rim = rims[static_cast<std::size_t>(region[k])];
    const auto all = static_cast<double>(rim.known + rim.walled + rim.open);
    if (static_cast<double>(rim.known) >= air.parameters().min_known * all &&
        static_cast<double>(rim.open) <= air.parameters().max_open * all)
      enclosed.push_back(holes[k]);
  }
  return enclosed;
}

} // namespace sedr
} // namespace pcl
