// SPDX-License-Identifier: BSD-3-Clause
#include "frontier_points.h"
#include "shared_faces.h"

#include "plan_fit.h"

#include "../borders/step_risers.h"
#include "../niches/niche_fit.h"
#include "../refit/plan_regularisation.h"
#include "../rooms/room_planes.h"
#include "../sheets/sheet_fit.h"
#include "room_territory.h"
#include "sedr_filters/src/base/exactness.h"
#include "sedr_filters/src/base/parallel_for.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <memory>
#include <utility>

namespace pcl::sedr {

namespace {

/** @brief Returns the room numbers, increasing, without 0. */
std::vector<std::uint32_t>
roomNumbers(const PlanEvidence& evidence)
{
  if (evidence.room.empty())
    return {1};
  std::vector<std::uint32_t> numbers;
  for (const int i : evidence.ceiling)
    if (evidence.room[static_cast<std::size_t>(i)] != 0)
      numbers.push_back(evidence.room[static_cast<std::size_t>(i)]);
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

/** @brief Returns `roomOf(index)` for each index, -1 for none, computed in parallel. */
template <typename RoomOf>
std::vector<std::int32_t>
roomsOf(const std::vector<int>& indices, unsigned threads, RoomOf roomOf)
{
  std::vector<std::int32_t> rooms(indices.size());
  parallelFor(indices.size(), points_a_block, threads,
              [&](std::size_t k) { rooms[k] = roomOf(indices[k]); });
  return rooms;
}

/** @brief Returns the indices of each room. */
std::vector<std::vector<int>>
sharesOf(const std::vector<int>& indices,
         const std::vector<std::int32_t>& room_of,
         std::size_t rooms)
{
  std::vector<std::vector<int>> shares(rooms);
  for (std::size_t k = 0; k < indices.size(); ++k)
    if (room_of[k] >= 0)
      shares[static_cast<std::size_t>(room_of[k])].push_back(indices[k]);
  return shares;
}

/** @brief Returns the height range of each room; empty if a room has no floor points.
 */
std::vector<RoomHeights>
heightsOfRooms(const PointView& points,
               const std::vector<std::vector<int>>& floors,
               const std::vector<std::vector<int>>& ceilings,
               const std::vector<std::vector<int>>& details)
{
  std::vector<RoomHeights> heights;
  for (std::size_t r = 0; r < floors.size(); ++r) {
    if (floors[r].empty())
      return {};
    std::vector<float> above;
    for (const auto* part : {&ceilings[r], &details[r]})
      for (const int i : *part)
        above.push_back(points[static_cast<std::size_t>(i)].z());
    heights.push_back(heightsFrom(floorLevel(points, floors[r]), std::move(above)));
  }
  return heights;
}

/** @brief Input and record of a room's fit. */
struct RoomWork {
  RoomEvidence evidence;
  RoomRecord record;
};

/** @brief Fits every room separately; returns the problem of each, empty on success. */
std::vector<std::string>
fitRooms(const PointView& points,
         const RoomFitParameters& parameters,
         std::vector<RoomWork>& work,
         std::vector<PlanRoom>& rooms)
{
  std::vector<std::string> problems(work.size());
  rooms.assign(work.size(), {});
  parallelBlocks(work.size(), 1, parameters.threads, [&](std::size_t r, std::size_t) {
    const RoomEvidence& evidence = work[r].evidence;
    if (evidence.ceiling.size() < 3 || evidence.floor.size() < 3)
      problems[r] = std::to_string(evidence.ceiling.size()) + " ceiling points and " +
                    std::to_string(evidence.floor.size()) +
                    " floor points are too few, 3 are needed of each";
    else
      rooms[r] = fitRoom(points, evidence, parameters, problems[r], &work[r].record);
  });
  return problems;
}

/** @brief Refits rooms along their neighbours' walls without the points of those walls.
 * A room keeps its old fit if the new one is no simpler.
 * @return whether any room changed */
bool
leaveToOthers(const PointView& points,
              const RoomFitParameters& parameters,
              std::vector<RoomWork>& work,
              Floorplan& plan)
{
  std::vector<PlanRoom> rooms = plan.rooms;
  std::vector<std::uint8_t> has_changed(rooms.size(), 0);
  std::vector<std::vector<PlanElement>> faces;
  std::vector<std::size_t> among_others;
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    faces.push_back(facesOfOthers(plan, r, parameters.loop.priors));
    if (!faces.back().empty())
      among_others.push_back(r);
  }
  // Idle threads share the work on a room.
  parallelBlocks(
      among_others.size(), 1, parameters.threads, [&](std::size_t k, std::size_t) {
        const std::size_t r = among_others[k];
        RoomWork again{work[r].evidence, {}};
        again.evidence.faces_of_others.insert(again.evidence.faces_of_others.end(),
                                              faces[r].begin(), faces[r].end());
        std::string problem;
        PlanRoom room = fitRoom(points, again.evidence, parameters, problem,
                                &again.record, rooms[r].boundary.elements.size());
        room.id = rooms[r].id;
        if (!problem.empty())
          return;
        rooms[r] = std::move(room);
        work[r] = std::move(again);
        has_changed[r] = 1;
      });
  plan.rooms = std::move(rooms);
  return std::count(has_changed.begin(), has_changed.end(), 1) > 0;
}

std::vector<Eigen::Vector3d>
placesOf(const PointView& points, const std::vector<int>& indices)
{
  std::vector<Eigen::Vector3d> places;
  places.reserve(indices.size());
  for (const int i : indices)
    if (points.isFinite(static_cast<std::size_t>(i)))
      places.emplace_back(points[static_cast<std::size_t>(i)].cast<double>());
  return places;
}

/** @brief Returns the points of a ceiling and its details that nothing of them hides
 * from below, without vertical faces, if much of them slopes; else none. */
std::vector<int>
slopingCeiling(const PointView& points,
               const CellGrid& grid,
               const std::vector<int>& ceiling,
               const std::vector<int>& details)
{
  // Metres: more than the steepest slope rises in a cell.
  const double step = 2 * grid.size();
  std::map<CellKey, float> lowest;
  std::vector<int> seen;
  const auto forAll = [&](auto use) {
    for (const auto* part : {&ceiling, &details})
      for (const int i : *part)
        if (const auto at = static_cast<std::size_t>(i); points.isFinite(at))
          use(i, keyOf(grid.at(points[at].x(), points[at].y())), points[at].z());
  };
  forAll([&](int, CellKey cell, float z) {
    const auto known = lowest.emplace(cell, z).first;
    known->second = std::min(known->second, z);
  });
  forAll([&](int i, CellKey cell, float z) {
    if (z < lowest[cell] + step)
      seen.push_back(i);
  });
  if (slopingArea(placesOf(points, seen)) < SheetParameters().min_area)
    seen.clear();
  return seen;
}

/** @brief Returns the preliminary ceiling of a room, a relief of its facets; null if
 * there are none or they explain too little of it. */
std::shared_ptr<const PlanSlab>
seenSheet(const std::vector<Eigen::Vector3d>& points,
          const Priors& priors,
          unsigned threads)
{
  SheetParameters parameters; // coarse: used only for the tops of walls
  parameters.cell_size = 0.15;
  parameters.max_cells = 6000;
  parameters.is_rough = true;
  parameters.threads = threads;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& p : points)
    box.extend(p.head<2>());
  if (box.isEmpty())
    return nullptr;
  const SheetGrid grid = sheetGrid(box, parameters);
  std::vector<std::uint8_t> domain(grid.count(), 0);
  for (const Eigen::Vector3d& p : points)
    domain[grid.at(p.head<2>())] = 1;
  const FacetSheet sheet = fitSheet(points, grid, domain, {}, parameters);
  if (!hasSlope(sheet) || sheet.explained < priors.share_clear)
    return nullptr;
  return std::make_shared<const PlanSlab>(reliefOf(sheet, grid.size / 2));
}

/** @brief Returns the boundary of a room with walls that tilt out of it at their heads
 * and all others at their feet: no ceiling reaches farther. */
PlanLoop
outermostBoundary(const PlanRoom& room, const WallTilts& tilts)
{
  WallTilts outwards;
  for (const WallTilt& tilt : tilts)
    if (tilt.room == room.id && tilt.tilt < 0)
      outwards.push_back(tilt);
  return outwards.empty() ? room.boundary
                          : boundaryAt(room, outwards, headOf(room, outwards));
}

} // namespace

Floorplan
fitPlan(const PointView& points,
        const PlanEvidence& evidence,
        const RoomFitParameters& parameters,
        std::string& problem,
        std::vector<std::string>& warnings,
        std::vector<FittedBoundary>* boundaries,
        std::vector<RoomSheet>* sheets)
{
  Floorplan plan;
  const Priors& priors = parameters.loop.priors;
  problem.clear();
  warnings.clear();
  const CellGrid grid(parameters.cell_size);
  const std::vector<std::uint32_t> numbers = roomNumbers(evidence);
  const auto labelled = [&](int i) -> std::int32_t {
    const Eigen::Vector3f p = points[static_cast<std::size_t>(i)];
    if (!points.isFinite(static_cast<std::size_t>(i)) || !grid.holds(p.x(), p.y()))
      return -1;
    if (evidence.room.empty())
      return 0;
    const auto number = evidence.room[static_cast<std::size_t>(i)];
    const auto it = std::lower_bound(numbers.begin(), numbers.end(), number);
    return it != numbers.end() && *it == number
               ? static_cast<std::int32_t>(it - numbers.begin())
               : -1;
  };
  const auto shareBy = [&](const std::vector<int>& indices, const auto& roomOf) {
    return sharesOf(indices, roomsOf(indices, parameters.threads, roomOf),
                    numbers.size());
  };
  auto ceilings = shareBy(evidence.ceiling, labelled);
  auto details = shareBy(evidence.details, labelled);
  auto of_sheets = shareBy(evidence.sheets, labelled);
  for (std::size_t r = 0; r < numbers.size() && evidence.finds_sheets; ++r)
    of_sheets[r] = slopingCeiling(points, grid, ceilings[r], details[r]);
  std::vector<CellSet> scopes;
  for (std::size_t r = 0; r < numbers.size(); ++r)
    scopes.push_back(
        unite(CellSet(grid, points, ceilings[r]), CellSet(grid, points, details[r])));
  const std::vector<RoomHeights> heights =
      heightsOfRooms(points, shareBy(evidence.floor, labelled), ceilings, details);
  std::array<std::unique_ptr<const RoomTerritory>, 2> territories;
  parallelBlocks(territories.size(), 1, parameters.threads,
                 [&](std::size_t k, std::size_t) {
                   territories[k] = std::make_unique<RoomTerritory>(
                       grid, scopes, heights,
                       k == 0 ? wallReach(priors) : nicheReach({priors}), priors);
                 });
  const RoomTerritory& territory = *territories[0];
  const RoomTerritory& wide = *territories[1];
  problem = territory.problem().empty() ? wide.problem() : territory.problem();
  if (!problem.empty())
    return plan;
  const std::vector<std::int32_t> room_of =
      roomsOfPoints(points, territory, parameters.threads);
  const auto nearest = [&](int i) { return room_of[static_cast<std::size_t>(i)]; };
  auto floors = shareBy(evidence.floor, [&](int i) {
    const std::int32_t room = labelled(i);
    return room < 0 ? nearest(i) : room;
  });
  auto around = shareBy(evidence.all, nearest);
  auto behind = shareBy(evidence.all, [&](int i) {
    return nearest(i) < 0 ? wide.roomAt(points[static_cast<std::size_t>(i)]) : -1;
  });
  auto walls = evidence.walls.empty() ? around : shareBy(evidence.walls, nearest);

  std::vector<RoomWork> all_work;
  for (std::size_t r = 0; r < numbers.size(); ++r)
    all_work.push_back({{std::move(around[r]),
                         std::move(ceilings[r]),
                         std::move(details[r]),
                         std::move(floors[r]),
                         std::move(walls[r]),
                         {},
                         std::move(behind[r])},
                        {}});
  if (sheets)
    parallelBlocks(
        numbers.size(), 1, parameters.threads, [&](std::size_t r, std::size_t) {
          all_work[r].evidence.sheet =
              seenSheet(placesOf(points, of_sheets[r]), priors, parameters.threads);
        });
  std::vector<PlanRoom> rooms;
  const std::vector<std::string> problems =
      fitRooms(points, parameters, all_work, rooms);
  std::vector<RoomWork> work;
  for (std::size_t r = 0; r < numbers.size(); ++r) {
    rooms[r].id = numbers[r];
    if (!problems[r].empty()) {
      warnings.push_back("room " + std::to_string(numbers[r]) + ": " + problems[r]);
      continue;
    }
    plan.rooms.push_back(std::move(rooms[r]));
    if (all_work[r].evidence.sheet)
      sheets->push_back({numbers[r], placesOf(points, of_sheets[r])});
    work.push_back(std::move(all_work[r]));
  }
  // A changed room may reveal another shared wall.
  constexpr int max_rounds = 3;
  for (int round = 0; round < max_rounds; ++round)
    if (!leaveToOthers(points, parameters, work, plan))
      break;
  for (std::size_t r = 0; r < plan.rooms.size(); ++r) {
    if (work[r].record.lost_area >= parameters.minimum_detail_area) {
      char text[96];
      std::snprintf(text, sizeof text,
                    "room %u: %.2f m2 of its ceiling lie apart and are left out",
                    plan.rooms[r].id, work[r].record.lost_area);
      warnings.push_back(text);
    }
    for (auto& boundary : work[r].record.boundaries) {
      boundary.room = plan.rooms[r].id;
      if (boundaries)
        boundaries->push_back(std::move(boundary));
    }
  }
  RegularisationParameters regular;
  regular.priors = priors;
  regularisePlan(plan, regular);
  if (plan.rooms.empty())
    problem =
        warnings.empty() ? "no ceiling point belongs to a room" : warnings.front();
  return plan;
}

void
giveCeilings(const std::vector<RoomSheet>& sheets,
             const PointView* scan,
             const std::vector<int>& indices,
             unsigned threads,
             Floorplan& plan,
             const WallTilts& tilts)
{
  parallelBlocks(sheets.size(), 1, threads, [&](std::size_t k, std::size_t) {
    const auto room =
        std::find_if(plan.rooms.begin(), plan.rooms.end(),
                     [&](const PlanRoom& other) { return other.id == sheets[k].room; });
    if (room == plan.rooms.end())
      return;
    SheetParameters parameters;
    parameters.threads = threads;
    const PlanLoop outline = outermostBoundary(*room, tilts);
    const SheetGrid grid = gridWithin(outline, parameters);
    FacetSheet sheet = fitSheet(sheets[k].points, grid, cellsWithin(grid, outline),
                                wallDirections(outline), parameters);
    if (!hasSlope(sheet))
      return;
    std::vector<Eigen::Vector3d> risers;
    if (scan) {
      refitToScan(sheet, *scan, indices, parameters);
      risers = pointsOfRisers(sheet, *scan, indices);
    }
    const PlanLoop foot = std::exchange(room->boundary, outline);
    giveCeiling(sheet, sheets[k].points, risers, *room);
    room->boundary = foot;
  });
}

} // namespace pcl::sedr
