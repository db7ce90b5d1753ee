// SPDX-License-Identifier: BSD-3-Clause
#include "room_planes.h"

#include "../air/height_counts.h"

#include "sedr_filters/src/base/parallel.h"
#include "sedr_filters/src/base/plane_fit.h"
#include <pcl/sedr_filters/impl/structure_fields.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace pcl::sedr {

namespace {

HeightCounts
heightsOf(const PointView& points, const std::vector<int>& sheet)
{
  HeightCounts heights;
  for (const int i : sheet)
    if (points.isFinite(static_cast<std::size_t>(i)))
      heights.add(points[static_cast<std::size_t>(i)].z());
  return heights;
}

} // namespace

double
ceilingLevel(const PointView& points, const std::vector<int>& sheet)
{
  return heightsOf(points, sheet).highestCount();
}

double
floorLevel(const PointView& points, const std::vector<int>& sheet)
{
  return heightsOf(points, sheet).lowestOf(HeightCounts::share_of_floor);
}

PlanSlab
mainPlane(const PointView& points,
          const std::vector<int>& sheet,
          double height,
          const RoomPlaneParameters& parameters)
{
  const double band =
      2 * parameters.tolerance; // what is level, and what is tilted from it
  std::vector<int> level;
  std::copy_if(sheet.begin(), sheet.end(), std::back_inserter(level), [&](int i) {
    return std::abs(points[static_cast<std::size_t>(i)].z() - height) <= band;
  });
  return findLargerSlab(positionsOf(points, level.size() < 3 ? sheet : level),
                        parameters.tolerance, parameters.maximum_tilt, parameters.seed,
                        parameters.threads);
}

std::vector<int>
pointsOn(const PointView& points,
         const std::vector<int>& indices,
         const PlanSlab& plane,
         double tolerance)
{
  std::vector<int> on;
  std::copy_if(indices.begin(), indices.end(), std::back_inserter(on), [&](int i) {
    return std::abs(distanceAbove(plane, points[static_cast<std::size_t>(i)])) <=
           tolerance;
  });
  return on;
}

std::vector<Eigen::Vector2d>
partsOf(Cell cell, const CellGrid& coarse, const CellGrid& fine)
{
  const int parts =
      std::max(1, static_cast<int>(std::lround(coarse.size() / fine.size())));
  std::vector<Eigen::Vector2d> places;
  for (int part = 0; part < parts * parts; ++part)
    places.push_back(coarse.centre(cell) +
                     fine.size() * Eigen::Vector2d(part % parts - (parts - 1) / 2.0,
                                                   part / parts - (parts - 1) / 2.0));
  return places;
}

std::vector<Eigen::Vector3f>
hiddenCeiling(const std::vector<RoomColumn>& columns,
              const CellGrid& coarse,
              const CellGrid& grid,
              const CellSet& seen,
              const PlanSlab& plane)
{
  constexpr double same = 0.2; // metres between the main plane and the height inferred
  std::vector<Eigen::Vector3f> hidden;
  for (const RoomColumn& column : columns) {
    if (column.ceiling_seen)
      continue;
    for (const Eigen::Vector2d& place : partsOf(column.cell, coarse, grid)) {
      if (seen.contains(grid.at(place.x(), place.y())))
        continue;
      const double of_plane = plane.heightAt(place);
      const bool is_main = std::abs(of_plane - column.ceiling) < same;
      hidden.push_back(
          Eigen::Vector3d(place.x(), place.y(), is_main ? of_plane : column.ceiling)
              .cast<float>());
    }
  }
  return hidden;
}

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
    std::stable_sort(
        sheets_.begin(), sheets_.end(),
        [](const ColumnSheet& a, const ColumnSheet& b) { return a.column < b.column; });
    first_.assign(coarse_.size() + 1, 0);
    for (const ColumnSheet& sheet : sheets_)
      ++first_[sheet.column + 1];
    for (std::size_t c = 1; c < first_.size(); ++c)
      first_[c] += first_[c - 1];
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
