// SPDX-License-Identifier: BSD-3-Clause
#include "reflections.h"
#include "room_description.h"
#include "room_points.h"
#include "storey_levels.h"

#include "../stairs/stairs.h"

#include <pcl/sedr_segmentation/building.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace pcl::sedr {

namespace {

constexpr double voxel_height = 0.05; // metres

/** @brief Columns half as wide as those that rooms are looked for in: `fine` ones, or
 * larger where the scan is too sparse to fill twice their size. */
VoxelColumns
halfOfThoseFilled(VoxelColumns columns, unsigned threads)
{
  constexpr int filled = 6;       // neighbours of a voxel, of 8 on a plane
  constexpr double largest = 0.4; // metres
  for (;;) {
    VoxelColumns halved = columns.halved(threads);
    if (2 * halved.cellSize() > largest || halved.usualCompany(threads) >= filled)
      return columns;
    columns = std::move(halved);
  }
}

/** @brief Columns without what floats in the air. What is of no surface goes before
 * holes are closed, else it would be closed to one. */
VoxelColumns
withoutStrays(VoxelColumns columns, bool is_dense, unsigned threads)
{
  constexpr double min_share = 0.5; // of the usual neighbours, for what is no stray
  constexpr int most = 4;           // neighbours: a surface's edge has five
  const int usual = columns.usualCompany(threads);
  columns.dropStrays(
      std::clamp(static_cast<int>(std::lround(min_share * usual)), 1, most), threads);
  if (is_dense)
    columns.keepSurfaces(most + 1, threads);
  return columns;
}

/** @brief The same with surfaces where a sparse scan shows dots. */
VoxelColumns
withHolesClosed(VoxelColumns columns, unsigned threads)
{
  constexpr double widest_gap = 0.2;  // metres, between the dots of a surface
  constexpr double widest_hole = 0.4; // in a surface
  const auto cells = [&](double metres) {
    return static_cast<int>(std::lround(metres / columns.cellSize()));
  };
  columns.closeDots(cells(widest_gap), threads);
  columns.closeHoles(cells(widest_hole), threads);
  return columns;
}

AirParameters
airParameters(const BuildingParameters& parameters)
{
  AirParameters air;
  air.headroom = parameters.headroom;
  air.threads = parameters.threads;
  return air;
}

/** @brief An opening that one walks through. */
bool
isWalkable(const RoomOpening& opening)
{
  constexpr double min_width = 0.5; // metres
  constexpr double min_height = 1.5;
  return opening.width >= min_width && opening.top - opening.bottom >= min_height;
}

/** @brief Which parts of the air one walks into from another, 2, and the largest: 1. */
std::vector<std::uint8_t>
reachedParts(const std::vector<BuildingRoom>& parts,
             const std::vector<RoomOpening>& openings)
{
  std::vector<std::uint8_t> is_reached(parts.size(), 0);
  if (!parts.empty())
    is_reached[0] = 1; // parts are by size
  for (const RoomOpening& opening : openings)
    if (isWalkable(opening))
      is_reached[opening.a] = is_reached[opening.b] = 2;
  return is_reached;
}

/** @brief Why a part of the air is no room; no reason for rooms. */
struct Verdict {
  std::string reason;
  LeftOutKind kind = LeftOutKind::Low;
};

std::vector<Verdict>
judge(const std::vector<BuildingRoom>& parts,
      const std::vector<std::uint8_t>& is_reached,
      const std::vector<std::uint8_t>& is_view,
      const BuildingParameters& parameters,
      double smallest_level,
      double cell_size)
{
  constexpr double surface = 0.1; // metres, of one that noise thickens
  const std::vector<std::uint8_t> is_image = mirrorImages(parts, surface);
  std::vector<Verdict> verdicts(parts.size());
  std::vector<double> floors; // of rooms that are large enough to make a level
  for (std::size_t p = 0; p < parts.size(); ++p) {
    Verdict& verdict = verdicts[p];
    if (is_image[p] != 0)
      verdict = {"what a floor mirrors of the room above it", LeftOutKind::Mirror};
    else if (is_view[p] != 0)
      verdict = {"seen only through panes of glass, or in mirrors",
                 LeftOutKind::Mirror};
    else
      verdict.reason = noRoomBecause(parts[p], cell_size, is_reached[p] != 0,
                                     is_reached[p] == 2, parameters, verdict.kind);
    if (verdict.reason.empty() && parts[p].area >= smallest_level)
      floors.push_back(parts[p].floor);
  }
  const auto isOnLevel = [&](const BuildingRoom& room) {
    return floors.empty() ||
           std::any_of(floors.begin(), floors.end(), [&](double floor) {
             return std::abs(floor - room.floor) < parameters.storey_step / 2;
           });
  };
  for (std::size_t p = 0; p < parts.size(); ++p)
    if (verdicts[p].reason.empty() && !isOnLevel(parts[p]))
      verdicts[p] = {
          "a landing of stairs, or above furniture: on the floor of no storey",
          LeftOutKind::Landing};
  return verdicts;
}

/** @brief Whether one walks into a part from a larger one that is a room, or of which
 * a part of one was seen: a view from there may be all that shows it. */
bool
isBesideRoom(std::uint32_t part,
             const std::vector<RoomOpening>& openings,
             const std::vector<Verdict>& verdicts)
{
  return std::any_of(openings.begin(), openings.end(), [&](const RoomOpening& o) {
    return std::max(o.a, o.b) == part && isWalkable(o) && // parts are by size
           verdicts[std::min(o.a, o.b)].reason.empty();
  });
}

/** @brief Area of the columns of a part that were seen, square metres. */
double
seenArea(const BuildingRoom& part, double cell_size)
{
  const auto seen =
      std::count_if(part.columns.begin(), part.columns.end(),
                    [](const RoomColumn& c) { return c.floor_seen || c.ceiling_seen; });
  return static_cast<double>(seen) * cell_size * cell_size;
}

/** @brief Area of the smallest rectangle around the columns of a part, square metres.
 */
double
rectangleAround(const BuildingRoom& part, const CellGrid& grid)
{
  constexpr int directions = 16; // of a quarter turn
  double smallest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < directions; ++k) {
    const Eigen::Rotation2Dd turn(M_PI / 2 * k / directions);
    Eigen::AlignedBox2d box;
    for (const RoomColumn& column : part.columns)
      box.extend(turn * grid.centre(column.cell));
    smallest = std::min(smallest, (box.sizes().array() + grid.size()).prod());
  }
  return smallest;
}

/** @brief Keeps what is a room, numbered anew, and tells the rest with reasons.
 * @return number of each part of the air among the rooms, 0 for those left out */
std::vector<std::uint32_t>
keepRooms(const PartedAir& parted,
          const PartingParameters& of_parting,
          std::vector<BuildingRoom> parts,
          const std::vector<std::uint8_t>& is_reached,
          const std::vector<std::uint8_t>& is_view,
          const BuildingParameters& parameters,
          Building& building)
{
  constexpr double worth_telling = 0.25; // square metres
  std::vector<Verdict> verdicts =
      judge(parts, is_reached, is_view, parameters, of_parting.smallest_level,
            building.grid.size());
  for (std::uint32_t p = 0; p < parts.size(); ++p)
    if (verdicts[p].reason.empty() && parameters.minimum_enclosure > 0 &&
        isBesideRoom(p, parted.openings, verdicts))
      verdicts[p] = {seenInPart(parts[p], rectangleAround(parts[p], building.grid)),
                     LeftOutKind::Partial};
  std::vector<std::size_t> rooms;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const BuildingRoom& part = parts[p];
    const double seen = seenArea(part, building.grid.size());
    building.seen_area += seen;
    if (verdicts[p].reason.empty())
      rooms.push_back(p);
    else if (seen >= worth_telling)
      building.left_out.push_back(
          {verdicts[p].kind, verdicts[p].reason, seen, part.floor, part.ceiling,
           building.grid.centre(part.columns[part.columns.size() / 2].cell)});
  }
  std::stable_sort(rooms.begin(), rooms.end(), [&](std::size_t a, std::size_t b) {
    return parts[a].area > parts[b].area;
  });
  std::vector<std::uint32_t> number(parts.size(), 0);
  for (const std::size_t p : rooms) {
    parts[p].id = number[p] = static_cast<std::uint32_t>(building.rooms.size() + 1);
    building.rooms.push_back(std::move(parts[p]));
  }
  return number;
}

/** @brief The openings between rooms: doorways, and where one climbs, stairs. */
void
tellOpenings(const std::vector<RoomOpening>& openings,
             const std::vector<std::uint32_t>& number,
             Building& building)
{
  for (const RoomOpening& opening : openings) {
    const std::uint32_t a = number[opening.a];
    const std::uint32_t b = number[opening.b];
    if (a == 0 || b == 0 || !isWalkable(opening))
      continue;
    const BuildingRoom& first = building.rooms[a - 1];
    const BuildingRoom& second = building.rooms[b - 1];
    if (first.storey != second.storey) {
      const bool is_up = first.storey < second.storey;
      building.stairs.push_back({{is_up ? a : b, is_up ? b : a},
                                 opening.middle,
                                 std::min(first.floor, second.floor),
                                 std::max(first.floor, second.floor)});
      continue;
    }
    const Eigen::Vector2d half = opening.direction * (opening.width / 2);
    building.doorways.push_back({{std::min(a, b), std::max(a, b)},
                                 opening.middle - half,
                                 opening.middle + half,
                                 opening.bottom,
                                 opening.top});
  }
}

/** @brief Describes the rooms of a scan. */
Building
describe(const AirGaps& air,
         const PartedAir& parted,
         const VoxelColumns& fine,
         const PointView& points,
         const std::vector<int>& indices,
         const BuildingParameters& parameters,
         const PartingParameters& of_parting,
         std::string& problem,
         const std::vector<std::uint8_t>& behind)
{
  const VoxelColumns& columns = air.columns();
  Building building;
  building.grid = columns.grid();
  std::vector<BuildingRoom> parts = describeRooms(air, parted);
  const std::vector<std::uint8_t> is_view =
      viewsThroughPanes(parts, columns.grid(), points, behind);
  const std::vector<std::uint8_t> is_reached = reachedParts(parts, parted.openings);
  const std::vector<std::uint32_t> number = keepRooms(
      parted, of_parting, std::move(parts), is_reached, is_view, parameters, building);
  building.storeys = findStoreys(building.rooms, parameters.storey_step);
  tellOpenings(parted.openings, number, building);
  addFlights(points, indices, fine, building);
  std::stable_sort(building.left_out.begin(), building.left_out.end(),
                   [](const LeftOut& a, const LeftOut& b) { return a.area > b.area; });
  if (air.voidArea() > 0)
    building.left_out.push_back({LeftOutKind::Void,
                                 "voids lower than a room: within slabs, below "
                                 "furniture",
                                 air.voidArea(), 0, 0, Eigen::Vector2d::Zero()});
  if (building.rooms.empty()) {
    char text[240];
    std::snprintf(
        text, sizeof text,
        "no air of at least %.1f square metres with a headroom of %.1f m between "
        "a floor and a ceiling, and walls along %.0f %% of its outline, in %zu "
        "points",
        parameters.minimum_area, parameters.headroom,
        100 * parameters.minimum_enclosure,
        indices.empty() ? points.size() : indices.size());
    problem = text;
    if (!building.left_out.empty()) {
      const LeftOut& most = building.left_out.front();
      std::snprintf(text, sizeof text,
                    "; the largest part, %.2f m2 without its rim: %s", most.area,
                    most.reason.c_str());
      problem += text;
    }
    return building;
  }
  labelSheets(points, indices, fine, columns, parameters.threads, building);
  return building;
}

} // namespace

Building
findBuilding(const PointView& points,
             const std::vector<int>& indices,
             const BuildingParameters& parameters,
             std::string& problem,
             const std::vector<std::uint8_t>& behind)
{
  problem.clear();
  const VoxelColumns fine(points, indices, parameters.cell_size, voxel_height,
                          parameters.threads);
  const VoxelColumns half = halfOfThoseFilled(fine, parameters.threads);
  const bool is_dense = half.cellSize() == fine.cellSize();
  PartingParameters of_parting;
  of_parting.widest_door = parameters.widest_door;
  of_parting.widest_passage = parameters.widest_passage;
  of_parting.smallest_room = parameters.minimum_area;
  const VoxelColumns seen =
      withoutStrays(half.halved(parameters.threads), is_dense, parameters.threads);
  const VoxelColumns columns = withHolesClosed(seen, parameters.threads);
  const AirGaps air(columns, seen, airParameters(parameters), &half);
  return describe(air, partIntoRooms(air, of_parting), fine, points, indices,
                  parameters, of_parting, problem, behind);
}

} // namespace pcl::sedr
