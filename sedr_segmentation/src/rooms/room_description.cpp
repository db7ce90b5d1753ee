// SPDX-License-Identifier: BSD-3-Clause
#include "room_description.h"

#include "../air/air_measures.h"
#include "../air/height_counts.h"

#include "sedr_filters/src/base/number_text.h"
#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/grids/cell_mask.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief The cells that the gaps of a room surround: of columns and furniture. */
CellMask
holesIn(const AirGaps& air, const std::vector<std::uint32_t>& gaps)
{
  std::vector<CellKey> keys;
  for (const std::uint32_t g : gaps)
    keys.push_back(keyOf(air.columns().cellOf(air[g].column)));
  const CellSet cells(std::move(keys));
  const CellBox box = grown(boxOf(cells), 1);
  return maskProblem(box).empty() ? enclosedCells(CellMask(cells, box)) : CellMask();
}

/** @brief The heights of a surface of a room where it was seen; where it was nowhere,
 * those that were inferred. */
HeightCounts
heightsOf(const BuildingRoom& room,
          float RoomColumn::*height,
          bool RoomColumn::*is_seen)
{
  HeightCounts seen;
  HeightCounts all;
  for (const RoomColumn& column : room.columns) {
    all.add(column.*height);
    if (column.*is_seen)
      seen.add(column.*height);
  }
  return seen.empty() ? all : seen;
}

} // namespace

std::vector<BuildingRoom>
describeRooms(const AirGaps& air, const PartedAir& parted)
{
  constexpr double sides_to_length = M_PI / 4; // of cells, over all directions
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
        const CellMask holes = holesIn(air, gaps[r]);
        std::size_t walled = 0;
        std::size_t ends = 0;
        std::size_t unseen = 0;
        for (const std::uint32_t g : gaps[r]) {
          const AirGap& gap = air[g];
          const double low = columns.heightOf(gap.low);
          const double high = columns.heightOf(gap.high);
          room.columns.push_back({columns.cellOf(gap.column), static_cast<float>(low),
                                  static_cast<float>(high), gap.floor_seen,
                                  gap.ceiling_seen});
          unseen += !gap.floor_seen && !gap.ceiling_seen ? 1 : 0;
          const Cell cell = columns.cellOf(gap.column);
          for (int d = 0; d < 4; ++d)
            if (const Cell by = plan_directions[static_cast<std::size_t>(d)];
                air.goingOnFrom(gap, columns.neighbour(gap.column, d)) ==
                    AirGaps::none &&
                !holes.at({cell.x + by.x, cell.y + by.y})) {
              ++ends;
              walled += isWallBeside(air, g, d) ? 1 : 0;
            }
        }
        std::sort(room.columns.begin(), room.columns.end(),
                  [](const RoomColumn& a, const RoomColumn& b) {
                    return keyOf(a.cell) < keyOf(b.cell);
                  });
        room.floor = heightsOf(room, &RoomColumn::floor, &RoomColumn::floor_seen)
                         .lowestOf(HeightCounts::share_of_floor);
        room.ceiling = heightsOf(room, &RoomColumn::ceiling, &RoomColumn::ceiling_seen)
                           .highestCount();
        room.area = static_cast<double>(gaps[r].size()) * columns.cellSize() *
                    columns.cellSize();
        room.enclosure =
            ends == 0 ? 1 : static_cast<double>(walled) / static_cast<double>(ends);
        room.inferred =
            static_cast<double>(unseen) * columns.cellSize() * columns.cellSize();
        room.unseen_outline =
            sides_to_length * static_cast<double>(ends - walled) * columns.cellSize();
      });
  return rooms;
}

Verdict
noRoomBecause(const BuildingRoom& room,
              double cell_size,
              bool is_entered,
              const BuildingParameters& parameters,
              const PartingParameters& of_parting)
{
  constexpr double min_tall = 0.3;   // of its columns; else it is a void
  constexpr double min_seen = 0.2;   // of its floor and of its ceiling
  constexpr double closed = 0.6;     // of its outline
  constexpr double not_glazed = 0.5; // likewise
  const auto shareOf = [&](const auto& is) {
    return static_cast<double>(
               std::count_if(room.columns.begin(), room.columns.end(), is)) /
           std::max(1.0, static_cast<double>(room.columns.size()));
  };
  const double tall = shareOf([&](const RoomColumn& column) {
    return column.ceiling - room.floor >= parameters.headroom;
  });
  const double area =
      tall * static_cast<double>(room.columns.size()) * cell_size * cell_size;
  if (area < parameters.minimum_area || tall < min_tall)
    return {formatText("less than %.1f square metres with a headroom of %.1f m",
                       parameters.minimum_area, parameters.headroom),
            LeftOutKind::Low};
  const double floor = shareOf([](const RoomColumn& c) { return c.floor_seen; });
  const double ceiling = shareOf([](const RoomColumn& c) { return c.ceiling_seen; });
  if (std::min(floor, ceiling) < min_seen)
    return {formatText("only %.0f %% of its %s was seen",
                       100 * std::min(floor, ceiling),
                       floor <= ceiling ? "floor" : "ceiling"),
            LeftOutKind::Open};
  // Of a place too small for a scanner only what an opening shows may be seen, and
  // into what one does not enter it may look through glass.
  const double least = area < of_parting.smallest_level ? closed
                       : !is_entered                    ? not_glazed
                                                        : 0;
  if (room.enclosure >= std::max(least, parameters.minimum_enclosure))
    return {};
  const bool is_part = area >= of_parting.smallest_level;
  return {formatText("walls along %.0f %% of its outline only: %s",
                     100 * room.enclosure,
                     is_part ? "a room seen in part, or a roof without walls"
                             : "seen through an opening, or outdoors"),
          is_part ? LeftOutKind::Partial : LeftOutKind::Open};
}

namespace {

/** @brief How much of each part of the air is of some kind. */
class Shares {
public:
  Shares(const PartedAir& parted)
      : some_(parted.rooms, 0)
      , all_(parted.rooms, 0)
  {}

  void add(std::int32_t part, bool is_some)
  {
    if (part == PartedAir::no_room)
      return;
    ++all_[static_cast<std::size_t>(part)];
    some_[static_cast<std::size_t>(part)] += is_some ? 1 : 0;
  }

  /** @brief Returns 1 for each part of which a share is more than `most`. */
  std::vector<std::uint8_t> above(double most) const
  {
    std::vector<std::uint8_t> is_above(all_.size());
    for (std::size_t p = 0; p < all_.size(); ++p)
      is_above[p] = static_cast<double>(some_[p]) > most * static_cast<double>(all_[p]);
    return is_above;
  }

private:
  std::vector<std::size_t> some_;
  std::vector<std::size_t> all_;
};

/** @brief Calls `visit(g, point, index)` for each gap of the column of each point. */
template <typename Visitor>
void
forEachGap(const AirGaps& air, const PointView& points, Visitor visit)
{
  const VoxelColumns& columns = air.columns();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f p = points[i];
    if (!p.allFinite() || !columns.grid().holds(p.x(), p.y()))
      continue;
    const std::uint32_t column = columns.columnAt(columns.grid().at(p.x(), p.y()));
    if (column == VoxelColumns::none)
      continue;
    for (std::size_t g = air.first(column); g < air.first(column + 1); ++g)
      visit(g, p, i);
  }
}

/** @brief Mean height of some points, NaN of none. */
struct MeanHeight {
  double sum = 0;
  double count = 0;

  void add(double height)
  {
    sum += height;
    ++count;
  }
  double mean() const { return sum / count; }
};

} // namespace

std::vector<std::uint8_t>
mirrorImages(const AirGaps& air,
             const PartedAir& parted,
             const PointView& points,
             const std::vector<double>& floors)
{
  constexpr double thinnest = 0.08; // metres, of slabs; a floor has no thickness
  constexpr double same_height = 0.1;
  constexpr double most = 0.8; // of its columns
  const VoxelColumns& columns = air.columns();
  std::vector<MeanHeight> lows(air.size());
  std::vector<MeanHeight> highs(air.size());
  std::vector<MeanHeight> main_floors(floors.size());
  forEachGap(air, points, [&](std::size_t g, const Eigen::Vector3f& p, std::size_t) {
    const std::int32_t voxel = columns.voxelAt(p.z());
    if (voxel == air[g].high)
      highs[g].add(p.z());
    if (voxel + 1 != air[g].low)
      return;
    lows[g].add(p.z());
    const std::int32_t part = parted.room[g];
    if (part != PartedAir::no_room &&
        std::abs(columns.heightOf(air[g].low) -
                 floors[static_cast<std::size_t>(part)]) <= columns.voxelHeight())
      main_floors[static_cast<std::size_t>(part)].add(p.z());
  });
  Shares shares(parted);
  for (std::size_t g = 0; g < air.size(); ++g) {
    const std::size_t above = g + 1;
    const auto isMirrored = [&] {
      const double plane = (highs[g].mean() + lows[above].mean()) / 2;
      const double floor =
          main_floors[static_cast<std::size_t>(parted.room[above])].mean();
      return std::abs(floor - plane) <= thinnest / 4 &&
             std::abs(air.height(above) - air.height(g)) <= same_height;
    };
    shares.add(parted.room[g],
               above < air.size() && air[above].column == air[g].column &&
                   parted.room[above] != PartedAir::no_room &&
                   parted.room[above] != parted.room[g] && isMirrored());
  }
  return shares.above(most);
}

std::vector<std::uint8_t>
viewsThroughPanes(const AirGaps& air,
                  const PartedAir& parted,
                  const PointView& points,
                  const std::vector<std::uint8_t>& behind)
{
  constexpr double beside = 0.1; // metres, of floor and ceiling
  constexpr double most = 0.9;   // of the points
  Shares shares(parted);
  const VoxelColumns& columns = air.columns();
  if (!behind.empty())
    forEachGap(
        air, points, [&](std::size_t g, const Eigen::Vector3f& p, std::size_t i) {
          if (i < behind.size() && p.z() > columns.heightOf(air[g].low) - beside &&
              p.z() < columns.heightOf(air[g].high) + beside)
            shares.add(parted.room[g], behind[i] != 0);
        });
  return shares.above(most);
}

} // namespace pcl::sedr
