// SPDX-License-Identifier: BSD-3-Clause
#include "room_description.h"
#include "room_gaps.h"
#include "room_planes.h"

#include "../scan/scan_excerpt.h"
#include "../stairs/stair_flights.h"

#include "sedr_filters/src/base/number_text.h"
#include <pcl/sedr_filters/plan_measures.h>
#include <pcl/sedr_segmentation/impl/find_building.h>

#include <algorithm>
#include <cmath>
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

/** @brief Columns with surfaces where a sparse scan shows dots. */
VoxelColumns
withDotsJoined(VoxelColumns columns, unsigned threads)
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
isWalkable(const RoomOpening& opening, const PartingParameters& of_parting)
{
  constexpr double min_height = 1.5; // metres
  return opening.width >= of_parting.min_way &&
         opening.top - opening.bottom >= min_height;
}

/** @brief 1 for the largest part of the air and those that one walks into from another:
 * into others a scanner may have looked through glass. */
std::vector<std::uint8_t>
enteredParts(const PartedAir& parted, const PartingParameters& of_parting)
{
  std::vector<std::uint8_t> is_entered(parted.rooms, 0);
  if (!is_entered.empty())
    is_entered[0] = 1; // parts are by size
  for (const RoomOpening& opening : parted.openings)
    if (isWalkable(opening, of_parting))
      is_entered[opening.a] = is_entered[opening.b] = 1;
  return is_entered;
}

/** @brief What each part of the air is.
 * @param behind 1 for points that were seen only through panes */
std::vector<Verdict>
judge(const AirGaps& air,
      const PartedAir& parted,
      const std::vector<BuildingRoom>& parts,
      const PointView& points,
      const std::vector<std::uint8_t>& behind,
      const BuildingParameters& parameters,
      const PartingParameters& of_parting)
{
  const CellGrid& grid = air.columns().grid();
  std::vector<double> floors;
  for (const BuildingRoom& part : parts)
    floors.push_back(part.floor);
  const std::vector<std::uint8_t> is_image = mirrorImages(air, parted, points, floors);
  const std::vector<std::uint8_t> is_view =
      viewsThroughPanes(air, parted, points, behind);
  const std::vector<std::uint8_t> is_entered = enteredParts(parted, of_parting);
  std::vector<Verdict> verdicts(parts.size());
  std::vector<double> levels; // floors of rooms that are large enough to make one
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (is_image[p] != 0)
      verdicts[p] = {"what a floor mirrors of the room above it", LeftOutKind::Mirror};
    else if (is_view[p] != 0)
      verdicts[p] = {"seen only through panes of glass, or in mirrors",
                     LeftOutKind::Mirror};
    else
      verdicts[p] = noRoomBecause(parts[p], grid.size(), is_entered[p] != 0, parameters,
                                  of_parting);
    if (verdicts[p].isRoom() && parts[p].area >= of_parting.smallest_level)
      levels.push_back(parts[p].floor);
  }
  for (std::size_t p = 0; p < parts.size(); ++p)
    if (verdicts[p].isRoom() && !levels.empty() &&
        std::none_of(levels.begin(), levels.end(), [&](double level) {
          return std::abs(level - parts[p].floor) < parameters.storey_step / 2;
        }))
      verdicts[p] = {
          "a landing of stairs, or above furniture: on the floor of no storey",
          LeftOutKind::Landing};
  return verdicts;
}

/** @brief Keeps what is a room, numbered anew, and tells the rest with reasons.
 * @return number of each part of the air among the rooms, 0 for those left out */
std::vector<std::uint32_t>
keepRooms(std::vector<BuildingRoom> parts,
          const std::vector<Verdict>& verdicts,
          Building& building)
{
  constexpr double worth_telling = 0.25; // square metres
  std::vector<std::size_t> rooms;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const BuildingRoom& part = parts[p];
    const double seen = part.area - part.inferred;
    building.seen_area += seen;
    if (verdicts[p].isRoom())
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

/** @brief Lists the storeys, and gives each room its storey. */
void
listStoreys(double step, Building& building)
{
  std::vector<RoomLevel> levels;
  for (const BuildingRoom& room : building.rooms)
    levels.push_back({room.id, room.floor, room.ceiling, room.area});
  building.storeys = storeysOf(std::move(levels), step);
  for (const PlanStorey& storey : building.storeys)
    for (const std::uint32_t room : storey.rooms)
      building.rooms[room - 1].storey = storey.number;
}

/** @brief The openings between rooms: links, and where one climbs, stairs. */
void
tellOpenings(const std::vector<RoomOpening>& openings,
             const std::vector<std::uint32_t>& number,
             const PartingParameters& of_parting,
             Building& building)
{
  for (const RoomOpening& opening : openings) {
    const std::uint32_t a = number[opening.a];
    const std::uint32_t b = number[opening.b];
    if (a == 0 || b == 0 || !isWalkable(opening, of_parting))
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
    building.links.push_back({{std::min(a, b), std::max(a, b)},
                              opening.middle - half,
                              opening.middle + half,
                              opening.bottom,
                              opening.top});
  }
}

/** @brief Where the parting of rooms may be wrong. */
void
tellDoubts(const std::vector<PartingDoubt>& doubts,
           const std::vector<std::uint32_t>& number,
           double min_area,
           Building& building)
{
  constexpr double min_chance = 0.25;
  for (const PartingDoubt& doubt : doubts) {
    const auto [a, b] = std::minmax(number[doubt.a], number[doubt.b]);
    if (a != 0 && doubt.chance >= min_chance && doubt.area >= min_area)
      building.doubts.push_back({{a, b}, doubt.at, doubt.area, doubt.chance});
  }
}

/** @brief What was looked for where no room was found, and what was found instead. */
std::string
problemOf(const Building& building,
          const BuildingParameters& parameters,
          std::size_t points)
{
  std::string problem = formatText(
      "no air of at least %.1f square metres with a headroom of %.1f m between "
      "a floor and a ceiling, and walls along %.0f %% of its outline, in %zu "
      "points",
      parameters.minimum_area, parameters.headroom, 100 * parameters.minimum_enclosure,
      points);
  if (!building.left_out.empty()) {
    const LeftOut& most = building.left_out.front();
    problem += formatText("; the largest part, %.2f m2 without its rim: %s", most.area,
                          most.reason.c_str());
  }
  return problem;
}

/** @brief Describes the rooms of a scan. */
Building
describe(const AirGaps& air,
         const PartingParameters& of_parting,
         const VoxelColumns& fine,
         const PointView& points,
         const std::vector<int>& indices,
         const BuildingParameters& parameters,
         const std::vector<std::uint8_t>& behind)
{
  Building building;
  building.grid = air.columns().grid();
  const PartedAir parted = partIntoRooms(air, of_parting);
  std::vector<BuildingRoom> parts = describeRooms(air, parted);
  const std::vector<Verdict> verdicts =
      judge(air, parted, parts, points, behind, parameters, of_parting);
  const std::vector<std::uint32_t> number =
      keepRooms(std::move(parts), verdicts, building);
  listStoreys(parameters.storey_step, building);
  tellOpenings(parted.openings, number, of_parting, building);
  tellDoubts(parted.doubts, number, parameters.minimum_area, building);
  addFlights(points, indices, fine, building);
  std::stable_sort(building.left_out.begin(), building.left_out.end(),
                   [](const LeftOut& a, const LeftOut& b) { return a.area > b.area; });
  if (air.voidArea() > 0)
    building.left_out.push_back({LeftOutKind::Void,
                                 "voids lower than a room: within slabs, below "
                                 "furniture",
                                 air.voidArea(), 0, 0, Eigen::Vector2d::Zero()});
  if (building.rooms.empty())
    return building;
  labelSheets(points, indices, fine, air.columns(), parameters.threads, building);
  const CellGrid cells(parameters.cell_size);
  building.owner_of =
      RoomGaps(cells, gapsOf(building, points, cells), parameters.priors)
          .ownersOf(points, parameters.threads);
  return building;
}

/** @brief Turns a building back to the scan, but for the cells of its profiles. */
void
turnBack(const BuildingFrame& frame, Building& building)
{
  building.frame = frame;
  const double rise = frame.origin.z();
  const auto turn = [&](Eigen::Vector2d& at) {
    at = frame.toScan({at.x(), at.y(), 0}).head<2>();
  };
  for (BuildingRoom& room : building.rooms) {
    room.floor += rise;
    room.ceiling += rise;
    for (RoomColumn& column : room.columns) {
      column.floor = static_cast<float>(column.floor + rise);
      column.ceiling = static_cast<float>(column.ceiling + rise);
    }
  }
  Floorplan plan;
  plan.storeys = std::move(building.storeys);
  plan.stairs = std::move(building.stairs);
  plan = moved(std::move(plan), -frame.yaw(), frame.origin);
  building.storeys = std::move(plan.storeys);
  building.stairs = std::move(plan.stairs);
  for (RoomLink& link : building.links) {
    turn(link.start);
    turn(link.end);
    link.bottom += rise;
    link.top += rise;
  }
  for (RoomDoubt& doubt : building.doubts)
    turn(doubt.at);
  for (LeftOut& thing : building.left_out) {
    turn(thing.at);
    thing.floor += rise;
    thing.ceiling += rise;
  }
}

Building
findRooms(const PointView& points,
          const std::vector<int>& indices,
          const BuildingParameters& parameters,
          const std::vector<std::uint8_t>& behind)
{
  const VoxelColumns fine(points, indices, parameters.cell_size, voxel_height,
                          parameters.threads);
  const VoxelColumns half = halfOfThoseFilled(fine, parameters.threads);
  const PartingParameters of_parting;
  VoxelColumns seen = half.halved(parameters.threads);
  seen.keepSurfaces(parameters.threads); // before holes are closed to strays
  const VoxelColumns columns = withDotsJoined(seen, parameters.threads);
  const AirGaps air(columns, seen, airParameters(parameters), &half);
  return describe(air, of_parting, fine, points, indices, parameters, behind);
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
  Building building;
  if (parameters.own_frame) {
    const BuildingFrame frame =
        findBuildingFrame(points, indices, parameters.threads,
                          Eigen::Matrix3d::Identity(), parameters.cell_size);
    std::vector<Eigen::Vector3f> moved(points.size());
    movePoints(frame, points, parameters.threads, moved.data());
    building = findRooms({moved.data(), sizeof(Eigen::Vector3f), moved.size()}, indices,
                         parameters, behind);
    turnBack(frame, building);
  }
  else
    building = findRooms(points, indices, parameters, behind);
  if (building.rooms.empty())
    problem = problemOf(building, parameters,
                        indices.empty() ? points.size() : indices.size());
  return building;
}

} // namespace pcl::sedr
