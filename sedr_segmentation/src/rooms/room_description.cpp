// SPDX-License-Identifier: BSD-3-Clause
#include "room_description.h"

#include <pcl/sedr_filters/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace pcl {
namespace sedr {

namespace {

/** @brief Heights in bins: where a level lies in a room. */
class HeightCounts {
public:
  void add(double height) { ++bins_[std::lround(height / bin)]; }

  /** @brief The lowest height around which at least `share` of all lie. */
  double lowestOf(double share) const
  {
    for (const auto& entry : bins_)
      if (static_cast<double>(around(entry.first)) >= share * total())
        return middleOf(entry.first);
    return highestCount();
  }

  /** @brief The height around which most lie. */
  double highestCount() const
  {
    long best = bins_.empty() ? 0 : bins_.begin()->first;
    for (const auto& entry : bins_)
      if (around(entry.first) > around(best))
        best = entry.first;
    return middleOf(best);
  }

private:
  static constexpr double bin = 0.05; // metres

  double total() const
  {
    double sum = 0;
    for (const auto& entry : bins_)
      sum += static_cast<double>(entry.second);
    return sum;
  }

  std::size_t count(long at) const
  {
    const auto found = bins_.find(at);
    return found == bins_.end() ? 0 : found->second;
  }

  std::size_t around(long at) const
  {
    return count(at - 1) + count(at) + count(at + 1);
  }

  /** @brief The mean height of a bin and those beside it. */
  double middleOf(long at) const
  {
    double sum = 0;
    for (long k = at - 1; k <= at + 1; ++k)
      sum += bin * static_cast<double>(k) * static_cast<double>(count(k));
    return sum / std::max<double>(1, static_cast<double>(around(at)));
  }

  std::map<long, std::size_t> bins_;
};

/** @brief Whether a wall stands beside a gap where its air ends in direction d: in one
 * of the three columns there, or beside them. */
bool
hasWallBeside(const AirGaps& air, std::size_t g, int d)
{
  constexpr int depth = 3;
  constexpr double least = 0.4; // of the upper two thirds: furniture hides the rest
  const VoxelColumns& columns = air.columns();
  const std::int32_t from = air[g].low + (air[g].high - air[g].low) / 3;
  const std::int32_t to = air[g].high;
  std::uint32_t column = air[g].column;
  for (int step = 0; step < depth; ++step) {
    column = columns.neighbour(column, d);
    if (column == VoxelColumns::none)
      return false;
    for (const std::uint32_t c : {column, columns.neighbour(column, (d + 1) % 4),
                                  columns.neighbour(column, (d + 3) % 4)})
      if (c != VoxelColumns::none && air.occupiedShare(c, from, to) >= least)
        return true;
  }
  return false;
}

} // namespace

std::vector<BuildingRoom>
describeRooms(const AirGaps& air, const PartedAir& parted)
{
  constexpr double share_of_floor = 0.1; // of a room's columns
  const VoxelColumns& columns = air.columns();
  std::vector<std::vector<std::uint32_t>> gaps(parted.rooms);
  for (std::uint32_t g = 0; g < air.size(); ++g)
    if (parted.room[g] != PartedAir::no_room)
      gaps[static_cast<std::size_t>(parted.room[g])].push_back(g);
  std::vector<BuildingRoom> rooms(parted.rooms);
  parallelBlocks(
      parted.rooms, 1, air.parameters().threads, [&](std::size_t r, std::size_t) {
        BuildingRoom& room = rooms[r];
        room.id = static_cast<std::uint32_t>(r + 1);
        HeightCounts lows;
        HeightCounts highs;
        std::size_t walled = 0;
        std::size_t ends = 0;
        for (const std::uint32_t g : gaps[r]) {
          const AirGap& gap = air[g];
          const double low = columns.heightOf(gap.low);
          const double high = columns.heightOf(gap.high);
          room.columns.push_back({columns.cellOf(gap.column), static_cast<float>(low),
                                  static_cast<float>(high), gap.floor_seen,
                                  gap.ceiling_seen});
          lows.add(low);
          highs.add(high);
          for (int d = 0; d < 4; ++d)
            if (air.link(g, d) == AirGaps::none) {
              ++ends;
              walled += hasWallBeside(air, g, d) ? 1 : 0;
            }
        }
        std::sort(room.columns.begin(), room.columns.end(),
                  [](const RoomColumn& a, const RoomColumn& b) {
                    return keyOf(a.cell) < keyOf(b.cell);
                  });
        room.floor = lows.lowestOf(share_of_floor);
        room.ceiling = highs.highestCount();
        room.area = static_cast<double>(gaps[r].size()) * columns.cellSize() *
                    columns.cellSize();
        room.enclosure =
            ends == 0 ? 1 : static_cast<double>(walled) / static_cast<double>(ends);
      });
  return rooms;
}

std::string
noRoomBecause(const BuildingRoom& room,
              double cell_size,
              const BuildingParameters& parameters)
{
  std::size_t tall = 0;
  for (const RoomColumn& column : room.columns)
    tall += column.ceiling - std::max<double>(column.floor, room.floor) >=
                        parameters.headroom ||
                    column.ceiling - room.floor >= parameters.headroom
                ? 1
                : 0;
  const double area = static_cast<double>(tall) * cell_size * cell_size;
  char text[120];
  if (area < parameters.minimum_area) {
    std::snprintf(text, sizeof text,
                  "less than %.1f square metres with a headroom of %.1f m",
                  parameters.minimum_area, parameters.headroom);
    return text;
  }
  if (room.enclosure < parameters.minimum_enclosure) {
    std::snprintf(
        text, sizeof text,
        "walls along %.0f %% of its outline only: seen through an opening, or "
        "outdoors",
        100 * room.enclosure);
    return text;
  }
  return "";
}

} // namespace sedr
} // namespace pcl
