// SPDX-License-Identifier: BSD-3-Clause
#include "stair_chains.h"
#include "stair_flights.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace pcl::sedr {

namespace {

/** @brief Adds flights to the nearest link between the floors that they join, or as a
 * new one. Where a flight ends in the dark, its link tells how far it leads.
 * @param rooms at its foot and its head; 0: it ends in the dark */
void
addStair(std::vector<PlanFlight>&& flights,
         const std::array<std::uint32_t, 2>& rooms,
         std::vector<PlanStair>& stairs)
{
  constexpr double near = 2; // metres in plan from a link's opening
  PlanStair stair{rooms, flights.back().middle(flights.back().steps() - 1),
                  flights.front().bottom, flights.back().top()};
  const auto distanceOf = [&](const PlanStair& link) {
    double away = std::numeric_limits<double>::infinity();
    for (const PlanFlight& flight : flights)
      for (std::size_t k = 0; k < flight.steps(); ++k)
        away = std::min(away, (flight.middle(k) - link.at).norm());
    return away;
  };
  const auto agrees = [&](const PlanStair& link, std::size_t end) {
    const double off = end == 0 ? link.bottom - stair.bottom : stair.top - link.top;
    return off < near / 4 && (stair.rooms[end] == 0 || off > -near / 4);
  };
  const auto isParallel = [&](const PlanStair& link) {
    return link.flights.empty() && agrees(link, 0) && agrees(link, 1);
  };
  auto nearest = stairs.end();
  for (auto link = stairs.begin(); link != stairs.end(); ++link)
    if (isParallel(*link) &&
        distanceOf(*link) < (nearest == stairs.end() ? near : distanceOf(*nearest)))
      nearest = link;
  if (nearest != stairs.end()) {
    stair.at = nearest->at;
    for (const std::size_t end : {0, 1})
      if (rooms[end] == 0)
        stair.rooms[end] = nearest->rooms[end];
    if (rooms[0] == 0)
      stair.bottom = nearest->bottom;
    if (rooms[1] == 0)
      stair.top = nearest->top;
    stairs.erase(nearest);
  }
  stair.flights = std::move(flights);
  stairs.push_back(std::move(stair));
}

/** @brief Drops the links without flights between rooms that flights join: there air
 * joins the floors, but nobody climbs. */
void
dropVoids(std::vector<PlanStair>& stairs)
{
  const std::vector<PlanStair> all = stairs;
  const auto isVoid = [&](const PlanStair& link) {
    return link.flights.empty() &&
           std::any_of(all.begin(), all.end(), [&](const PlanStair& stair) {
             return !stair.flights.empty() && stair.rooms == link.rooms;
           });
  };
  stairs.erase(std::remove_if(stairs.begin(), stairs.end(), isVoid), stairs.end());
}

/** @brief Returns the treads of the flights of a chain, which landings part. */
std::vector<std::vector<Tread>>
treadsOf(const std::vector<StairStep>& chain, const std::vector<LevelPatch>& patches)
{
  std::vector<std::vector<Tread>> flights(1);
  const auto add = [&](std::size_t patch, int steps) {
    std::vector<Tread>& treads = flights.back();
    if (!patches[patch].is_tread)
      flights.emplace_back();
    else
      treads.push_back(
          {treads.empty() ? 0 : treads.back().number + steps, &patches[patch]});
  };
  add(chain.front().from, 0);
  for (const StairStep& step : chain)
    add(step.to, step.steps);
  flights.erase(std::remove_if(flights.begin(), flights.end(),
                               [](const auto& treads) { return treads.size() < 2; }),
                flights.end());
  return flights;
}

/** @brief The direction of the walls around treads, radians modulo a quarter turn: that
 * across which the most columns with a surface of a metre lie in line. */
std::optional<double>
wallsAround(const std::vector<Tread>& treads, const VoxelColumns& fine)
{
  const double reach = stair_priors.around;
  Eigen::AlignedBox2d box;
  for (const Tread& tread : treads)
    box.extend(tread.patch->box);
  const Cell low = fine.grid().at(box.min().x() - reach, box.min().y() - reach);
  const Cell high = fine.grid().at(box.max().x() + reach, box.max().y() + reach);
  std::vector<Eigen::Vector2d> walls;
  for (Cell cell = low; cell.x <= high.x; ++cell.x)
    for (cell.y = low.y; cell.y <= high.y; ++cell.y)
      if (const std::uint32_t c = fine.columnAt(cell); c != VoxelColumns::none) {
        bool is_wall = false;
        fine.forEachRun(c, [&](std::int32_t begin, std::int32_t end) {
          is_wall = is_wall || (end - begin) * fine.voxelHeight() >= stair_priors.wall;
        });
        if (is_wall)
          walls.push_back(fine.grid().centre(cell) - box.center());
      }
  const double farthest = box.sizes().norm() / 2 + 2 * reach;
  double best = 0;
  std::optional<double> direction;
  for (double angle = 0; angle < M_PI / 2; angle += M_PI / 720) {
    double sharpness = 0;
    for (const double along : {angle, angle + M_PI / 2}) {
      const Eigen::Vector2d way(std::cos(along), std::sin(along));
      std::vector<double> lines(
          static_cast<std::size_t>(2 * farthest / fine.cellSize()) + 1);
      for (const Eigen::Vector2d& p : walls) {
        double& line =
            lines[static_cast<std::size_t>((way.dot(p) + farthest) / fine.cellSize())];
        sharpness += 2 * line++ + 1; // the sum of its squares
      }
    }
    if (sharpness > best) {
      best = sharpness;
      direction = angle;
    }
  }
  return direction;
}

} // namespace

void
addFlights(const PointView& points,
           const std::vector<int>& indices,
           const VoxelColumns& fine,
           Building& building)
{
  constexpr double widest_cell = 0.1; // metres
  if (fine.cellSize() > widest_cell)
    return;
  const RoomFloors floors(building, fine.voxelHeight());
  const std::vector<LevelPatch> patches = levelPatches(points, indices, fine, floors);
  StairChains chains(patches, floors);
  for (std::vector<StairStep> chain = chains.next(); !chain.empty();
       chain = chains.next()) {
    std::vector<PlanFlight> flights;
    double odds = chain.back().odds;
    for (const std::vector<Tread>& treads : treadsOf(chain, patches)) {
      const auto steps =
          straightSteps(treads, patches, chains.used(), wallsAround(treads, fine));
      if (steps || treads.size() > 2)
        flights.push_back(steps ? flightOf(*steps) : turningFlight(treads));
      if (steps)
        odds = std::max(odds, steps->nats - stair_priors.chain_cost);
      for (const Tread& tread : steps ? steps->treads : treads)
        chains.use(*tread.patch);
    }
    for (const StairStep& step : chain)
      for (const std::size_t patch : {step.from, step.to})
        chains.use(patches[patch]);
    if (flights.empty() || odds < stair_priors.min_odds)
      continue;
    const RoomFloors::Floor foot = leadToFloor(flights.front(), floors, true);
    const RoomFloors::Floor head = leadToFloor(flights.back(), floors, false);
    if (flights.size() == 1 && foot.room != 0 && head.room != 0) {
      flights[0].bottom = foot.z;
      flights[0].rise = (head.z - foot.z) / static_cast<double>(flights[0].steps());
    }
    addStair(std::move(flights), {foot.room, head.room}, building.stairs);
  }
  dropVoids(building.stairs);
}

} // namespace pcl::sedr
