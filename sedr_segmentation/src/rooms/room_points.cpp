// SPDX-License-Identifier: BSD-3-Clause
#include "room_points.h"

#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/grids/disjoint_sets.h"
#include <pcl/sedr_filters/impl/structure_fields.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::sedr {

namespace {

/** @brief How far above and below where the air ends a surface's points may be, metres:
 * noise thickens it away from the air. */
constexpr double within_air = 0.1;
constexpr double behind = 0.15;

/** @brief A sheet of a room in a column. */
struct ColumnSheet {
  std::uint32_t column = 0;
  std::uint32_t room = 0;
  StructureLabel label = StructureLabel::Other;
  double z = 0;
};

/** @brief Whether a wall goes on below a ceiling, or above a floor, in a column. */
bool
goesOn(const VoxelColumns& columns,
       std::uint32_t column,
       double z,
       StructureLabel label)
{
  constexpr double far = 0.4;    // metres
  constexpr double walled = 0.6; // share of the voxels between
  const double sign = label == StructureLabel::Ceiling ? -1 : 1;
  const std::int32_t a = columns.voxelAt(z + sign * within_air);
  const std::int32_t b = columns.voxelAt(z + sign * far);
  const std::int32_t from = std::min(a, b);
  const std::int32_t to = std::max(a, b);
  return columns.countBetween(column, from, to) >= walled * (to - from);
}

/** @brief The sheets of all rooms, found by column. */
class RoomSheets {
public:
  RoomSheets(const Building& building, const VoxelColumns& coarse)
      : coarse_(coarse)
  {
    for (const BuildingRoom& room : building.rooms)
      for (const RoomColumn& column : room.columns) {
        const std::uint32_t c = coarse.columnAt(column.cell);
        if (c == VoxelColumns::none)
          continue; // nothing was seen there
        sheets_.push_back({c, room.id, StructureLabel::Ceiling, column.ceiling});
        sheets_.push_back({c, room.id, StructureLabel::Floor, column.floor});
      }
    sortSheets();
    continueCeilings();
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
    for (std::uint32_t k = first_[c]; k < first_[c + 1]; ++k) {
      const ColumnSheet& sheet = sheets_[k];
      const double into_air =
          sheet.label == StructureLabel::Ceiling ? sheet.z - z : z - sheet.z;
      if (into_air < within_air && into_air > -behind && std::abs(into_air) < nearest) {
        nearest = std::abs(into_air);
        found = {sheet.room, sheet.label};
      }
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
  void sortSheets()
  {
    std::stable_sort(
        sheets_.begin(), sheets_.end(),
        [](const ColumnSheet& a, const ColumnSheet& b) { return a.column < b.column; });
    first_.assign(coarse_.size() + 1, 0);
    for (const ColumnSheet& sheet : sheets_)
      ++first_[sheet.column + 1];
    for (std::size_t c = 1; c < first_.size(); ++c)
      first_[c] += first_[c - 1];
  }

  /** @brief Lets ceilings go on above furniture whose top was not seen: to columns of
   * no room in which a surface is as high, up to walls. */
  void continueCeilings()
  {
    constexpr double furniture_depth = 0.8; // metres
    const int steps =
        static_cast<int>(std::lround(furniture_depth / coarse_.cellSize()));
    std::vector<ColumnSheet> added;
    std::vector<int> depth; // of each, columns
    std::vector<std::uint8_t> is_added(coarse_.size(), 0);
    std::vector<ColumnSheet> front;
    for (const ColumnSheet& sheet : sheets_)
      if (sheet.label == StructureLabel::Ceiling)
        front.push_back(sheet);
    for (int step = 0; step < steps && !front.empty(); ++step) {
      std::vector<ColumnSheet> next;
      for (const ColumnSheet& sheet : front)
        for (int d = 0; d < 4; ++d) {
          const std::uint32_t c = coarse_.neighbour(sheet.column, d);
          if (c == VoxelColumns::none || hasSheet(c) || is_added[c] != 0 ||
              !goesOnTo(c, sheet.z))
            continue;
          is_added[c] = 1;
          next.push_back({c, sheet.room, StructureLabel::Ceiling, sheet.z});
        }
      added.insert(added.end(), next.begin(), next.end());
      depth.resize(added.size(), step + 1);
      front = std::move(next);
    }
    keepFurniture(depth, added);
    sheets_.insert(sheets_.end(), added.begin(), added.end());
    sortSheets();
  }

  /** @brief Whether a ceiling goes on to a column, above furniture. */
  bool goesOnTo(std::uint32_t c, double z) const
  {
    constexpr double tallest_gap = 1.8; // metres, between furniture and ceiling
    return hasPointsBetween(c, z - within_air, z + within_air) &&
           hasPointsBetween(c, z - tallest_gap, z - within_air) &&
           !goesOn(coarse_, c, z, StructureLabel::Ceiling);
  }

  /** @brief Keeps the sheets that hang together over as much as furniture takes up:
   * neither less deep, as recesses are, nor larger. */
  void keepFurniture(const std::vector<int>& depth,
                     std::vector<ColumnSheet>& added) const
  {
    constexpr double min_depth = 0.3;                     // metres
    constexpr double largest = 3;                         // square metres
    std::vector<std::uint32_t> number(coarse_.size(), 0); // from 1
    for (std::uint32_t k = 0; k < added.size(); ++k)
      number[added[k].column] = k + 1;
    DisjointSets<> sets(added.size());
    for (std::uint32_t k = 0; k < added.size(); ++k)
      for (int d = 0; d < 2; ++d) {
        const std::uint32_t c = coarse_.neighbour(added[k].column, d);
        if (c != VoxelColumns::none && number[c] != 0)
          sets.join(k, number[c] - 1);
      }
    std::vector<std::size_t> size(added.size(), 0);
    std::vector<int> deepest(added.size(), 0);
    for (std::uint32_t k = 0; k < added.size(); ++k) {
      ++size[sets.find(k)];
      deepest[sets.find(k)] = std::max(deepest[sets.find(k)], depth[k]);
    }
    std::vector<ColumnSheet> kept;
    for (std::uint32_t k = 0; k < added.size(); ++k)
      if (static_cast<double>(size[sets.find(k)]) * coarse_.cellSize() *
                  coarse_.cellSize() <=
              largest &&
          deepest[sets.find(k)] * coarse_.cellSize() > min_depth)
        kept.push_back(added[k]);
    added = std::move(kept);
  }

  bool hasPointsBetween(std::uint32_t c, double low, double high) const
  {
    return coarse_.countBetween(c, coarse_.voxelAt(low), coarse_.voxelAt(high) + 1) > 0;
  }

  bool hasSheet(std::uint32_t c) const { return first_[c] < first_[c + 1]; }

  const VoxelColumns& coarse_;
  std::vector<ColumnSheet> sheets_; ///< by column
  std::vector<std::uint32_t> first_;
};

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
  const RoomSheets sheets(building, coarse);
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
          sheets.sheetNear(coarse.columnAt(coarse.grid().at(p.x(), p.y())), p.z());
      if (found.room == 0 || goesOn(fine, column, p.z(), found.label))
        continue;
      building.room_of[i] = found.room;
      building.label_of[i] = static_cast<std::uint32_t>(found.label);
    }
  });
}

} // namespace pcl::sedr
