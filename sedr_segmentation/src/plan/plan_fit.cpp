// SPDX-License-Identifier: BSD-3-Clause
#include "shared_faces.h"

#include "plan_fit.h"

#include "../borders/step_risers.h"
#include "../refit/plan_regularisation.h"
#include "../sheets/sheet_fit.h"
#include "room_shares.h"
#include "sedr_filters/src/base/parallel.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace pcl::sedr {

namespace {

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
  const std::vector<std::uint32_t> numbers = roomNumbers(evidence);
  RoomShares shares = shareOut(points, evidence, numbers, parameters, problem);
  if (!problem.empty())
    return plan;
  std::vector<RoomWork> all_work;
  for (RoomEvidence& own : shares.rooms)
    all_work.push_back({std::move(own), {}});
  if (sheets)
    parallelBlocks(
        numbers.size(), 1, parameters.threads, [&](std::size_t r, std::size_t) {
          all_work[r].evidence.sheet =
              seenSheet(placesOf(points, shares.sheets[r]), priors, parameters.threads);
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
      sheets->push_back({numbers[r], placesOf(points, shares.sheets[r])});
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
