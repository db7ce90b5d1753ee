// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include <pcl/sedr_filters/parallel.h>
#include <pcl/sedr_filters/structure_fields.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl {
namespace sedr {

namespace {

/** @brief How far above and below where the air ends a surface's points may be, metres:
 * noise thickens it away from the air. */
constexpr double within_air = 0.1;
constexpr double behind = 0.15;

/** @brief The columns of all rooms, found by cell. */
class RoomColumns {
public:
  RoomColumns(const Building& building, const VoxelColumns& coarse)
      : coarse_(coarse)
      , first_(coarse.size() + 1, 0)
  {
    for (const BuildingRoom& room : building.rooms)
      for (const RoomColumn& column : room.columns)
        ++first_[coarse.columnAt(column.cell) + 1];
    for (std::size_t c = 1; c < first_.size(); ++c)
      first_[c] += first_[c - 1];
    columns_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (const BuildingRoom& room : building.rooms)
      for (const RoomColumn& column : room.columns)
        columns_[next[coarse.columnAt(column.cell)]++] = {&column, room.id};
  }

  struct Found {
    std::uint32_t room = 0;
    StructureLabel label = StructureLabel::Other;
  };

  /** @brief Which sheet of a column's rooms a height is on: the nearest, for a slab may
   * be as thin as its noise. */
  Found sheetAt(std::uint32_t c, double z) const
  {
    Found found;
    if (c == VoxelColumns::none)
      return found;
    double nearest = std::numeric_limits<double>::infinity();
    const auto offer = [&](double into_air, std::uint32_t room, StructureLabel label) {
      if (into_air < within_air && into_air > -behind && std::abs(into_air) < nearest) {
        nearest = std::abs(into_air);
        found = {room, label};
      }
    };
    for (std::uint32_t k = first_[c]; k < first_[c + 1]; ++k) {
      const Entry& entry = columns_[k];
      offer(entry.column->ceiling - z, entry.room, StructureLabel::Ceiling);
      offer(z - entry.column->floor, entry.room, StructureLabel::Floor);
    }
    return found;
  }

  /** @brief The same of a column or, where it has none, of one of the eight around. */
  Found sheetNear(std::uint32_t c, double z) const
  {
    Found found = sheetAt(c, z);
    for (int d = 0; d < 4 && found.room == 0 && c != VoxelColumns::none; ++d) {
      const std::uint32_t side = coarse_.neighbour(c, d);
      found = sheetAt(side, z);
      if (found.room == 0 && side != VoxelColumns::none)
        found = sheetAt(coarse_.neighbour(side, (d + 1) % 4), z);
    }
    return found;
  }

private:
  struct Entry {
    const RoomColumn* column = nullptr;
    std::uint32_t room = 0;
  };

  const VoxelColumns& coarse_;
  std::vector<std::uint32_t> first_;
  std::vector<Entry> columns_;
};

/** @brief Whether a wall goes on below a ceiling, or above a floor, in a column. */
bool
goesOn(const VoxelColumns& fine, std::uint32_t column, double z, StructureLabel label)
{
  constexpr double near = 0.1; // metres: the surface's own noise
  constexpr double far = 0.4;
  constexpr double walled = 0.6; // share of the voxels between
  const double sign = label == StructureLabel::Ceiling ? -1 : 1;
  const std::int32_t a = fine.voxelAt(z + sign * near);
  const std::int32_t b = fine.voxelAt(z + sign * far);
  const std::int32_t from = std::min(a, b);
  const std::int32_t to = std::max(a, b);
  return fine.countBetween(column, from, to) >= walled * (to - from);
}

} // namespace

void
labelSheets(const PointView& points,
            const std::vector<int>& indices,
            const VoxelColumns& fine,
            const VoxelColumns& coarse,
            unsigned threads,
            Building& building)
{
  constexpr std::size_t points_a_block = 32768;
  building.room_of.assign(points.size(), 0);
  building.label_of.assign(points.size(), 0);
  const RoomColumns columns(building, coarse);
  const std::size_t n = indices.empty() ? points.size() : indices.size();
  parallelBlocks(n, points_a_block, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t i = indices.empty() ? k : static_cast<std::size_t>(indices[k]);
      const Eigen::Vector3f p = points[i];
      if (!points.isFinite(i) || !fine.grid().holds(p.x(), p.y()))
        continue;
      const Cell cell = fine.grid().at(p.x(), p.y());
      const std::uint32_t column = fine.columnAt(cell);
      if (column == VoxelColumns::none)
        continue;
      const auto found =
          columns.sheetNear(coarse.columnAt(coarse.grid().at(p.x(), p.y())), p.z());
      if (found.room == 0 || goesOn(fine, column, p.z(), found.label))
        continue;
      building.room_of[i] = found.room;
      building.label_of[i] = static_cast<std::uint32_t>(found.label);
    }
  });
}

} // namespace sedr
} // namespace pcl
