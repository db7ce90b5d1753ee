// SPDX-License-Identifier: BSD-3-Clause
#include "chain_run.h"

#include "sedr_filters/src/plan/plan_bounds.h"
#include "sedr_filters/src/plan/room_lookup.h"

#include <pcl/sedr_filters/cell_grid.h>
#include <pcl/sedr_filters/floorplan.h>
#include <pcl/sedr_filters/plan_warning.h>
#include <pcl/sedr_segmentation/building.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace pcl::sedr {
namespace {

constexpr double off = 0.1;         // metres from the model
constexpr double min_patch = 0.25;  // square metres
constexpr double told_share = 0.02; // of the area of a room

using HeightAt = std::function<double(const Eigen::Vector2d&)>;

/** @brief The range of the model's heights around a place, wide on a slope and at a
 * step. */
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

Range
rangeAt(const HeightAt& model, const Eigen::Vector2d& place, double size)
{
  Range range;
  for (const double x : {-1.0, 0.0, 1.0})
    for (const double y : {-1.0, 0.0, 1.0}) {
      const double height = model(place + size * Eigen::Vector2d(x, y));
      range.low = std::min(range.low, height);
      range.high = std::max(range.high, height);
    }
  return range;
}

/** @brief A surface of a room: what was seen of it, and its model. */
struct Surface {
  WarningKind kind;
  bool RoomColumn::*is_seen;
  float RoomColumn::*height;
  HeightAt model;
};

void
addUnexplained(const Surface& surface,
               const BuildingRoom& room,
               const CellGrid& grid,
               const PlanRoom& plan,
               std::vector<PlanWarning>& warnings)
{
  std::vector<CellKey> keys;
  std::vector<float> heights;
  for (const RoomColumn& column : room.columns) {
    const Eigen::Vector2d at = grid.centre(column.cell);
    const double z = column.*surface.height;
    const bool is_beside = plan.boundary.distance(at) < 2 * grid.size() ||
                           std::any_of(plan.columns.begin(), plan.columns.end(),
                                       [&](const PlanLoop& loop) {
                                         return loop.distance(at) < 2 * grid.size();
                                       });
    if (!(column.*surface.is_seen) || is_beside || !plan.contains(at))
      continue;
    const Range range = rangeAt(surface.model, at, grid.size());
    const bool may_be_furniture = surface.kind == WarningKind::FloorOff;
    if (z >= range.low - off && (may_be_furniture || z <= range.high + off))
      continue;
    keys.push_back(keyOf(column.cell)); // increasing, as the columns
    heights.push_back(static_cast<float>(z));
  }
  const CellSet cells(keys);
  const CellRegions patches = labelRegions(cells);
  const double cell = grid.size() * grid.size();
  const double floor = plan.floorAt(plan.boundary.elements.front().start);
  std::size_t count = 0;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const std::size_t patch = patches.label[k];
    const auto size = static_cast<double>(patches.sizes[patch]);
    if (size * cell < min_patch)
      continue;
    ++count;
    low = std::min<double>(low, heights[k] - floor);
    high = std::max<double>(high, heights[k] - floor);
    if (patch == 0) // the largest
      middle += grid.centre(cells[k]) / size;
  }
  const double area = static_cast<double>(count) * cell;
  if (count > 0 && area >= told_share * plan.area())
    warnings.push_back({surface.kind, {area, low, high}, plan.id, 0, {}, middle});
}

} // namespace

std::vector<PlanWarning>
unexplainedSurfaces(const Building& building, const Floorplan& plan)
{
  std::vector<PlanWarning> warnings;
  for (const PlanRoom& room : plan.rooms) {
    const auto found =
        std::find_if(building.rooms.begin(), building.rooms.end(),
                     [&](const BuildingRoom& r) { return r.id == room.id; });
    if (found == building.rooms.end() || room.boundary.elements.empty())
      continue;
    const RoomLookup model(room);
    for (const Surface& surface :
         {Surface{WarningKind::CeilingOff, &RoomColumn::ceiling_seen,
                  &RoomColumn::ceiling,
                  [&](const Eigen::Vector2d& p) { return model.ceilingAt(p); }},
          Surface{WarningKind::FloorOff, &RoomColumn::floor_seen, &RoomColumn::floor,
                  [&](const Eigen::Vector2d& p) { return model.floorAt(p); }}})
      addUnexplained(surface, *found, building.grid, room, warnings);
  }
  return warnings;
}

std::optional<PlanWarning>
upsideDownDoubt(const PointView& points, double voxel, const Floorplan& plan)
{
  constexpr double off_walls = 0.3;  // metres
  constexpr double off_slabs = 0.15; // metres
  constexpr double min_area = 2;     // square metres
  constexpr double doubtful = 0.75;  // share in the upper half
  std::vector<RoomLookup> rooms;
  std::vector<Eigen::AlignedBox2d> boxes;
  for (const PlanRoom& room : plan.rooms) {
    rooms.emplace_back(room);
    boxes.push_back(boundsOf(room.boundary));
  }
  std::array<std::size_t, 2> count{}; // in lower and upper halves
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points.isFinite(i))
      continue;
    const Eigen::Vector3d p = points[i].cast<double>();
    const Eigen::Vector2d place = p.head<2>();
    for (std::size_t r = 0; r < rooms.size(); ++r) {
      if (!boxes[r].contains(place))
        continue;
      const double low = rooms[r].floorAt(place);
      const double high = rooms[r].ceilingAt(place);
      if (p.z() < low + off_slabs || p.z() > high - off_slabs ||
          !rooms[r].contains(place) ||
          rooms[r].room().boundary.distance(place) < off_walls)
        continue;
      ++count[p.z() > (low + high) / 2 ? 1 : 0];
      break;
    }
  }
  const auto all = static_cast<double>(count[0] + count[1]);
  const double upper = all > 0 ? static_cast<double>(count[1]) / all : 0;
  if (all * voxel * voxel < min_area || upper < doubtful)
    return std::nullopt;
  return PlanWarning{WarningKind::UpsideDown, {100 * upper, all * voxel * voxel}};
}

} // namespace pcl::sedr
