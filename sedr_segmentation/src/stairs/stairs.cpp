// SPDX-License-Identifier: BSD-3-Clause

#include "level_patches.h"
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

/** @brief A step from one patch up to another, also over treads that nobody saw. */
struct StairStep {
  std::size_t from = 0;
  std::size_t to = 0;
  int steps = 1;
  double rise = 0;                                ///< of each, metres
  Eigen::Vector2d way = Eigen::Vector2d::UnitX(); ///< its direction in plan
  double going = 0;                               ///< of each, metres
  bool is_on_treads = false;                      ///< both ends are treads
  double odds = 0;            ///< of the best chain up to here, nats
  std::ptrdiff_t before = -1; ///< the step before it there
};

/** @brief Nats that a change of rise, going and direction costs. */
double
change(const StairStep& a, const StairStep& b)
{
  double squares = std::pow((b.rise - a.rise) / stair_priors.rise_sigma, 2);
  if (a.is_on_treads && b.is_on_treads) {
    const double turn =
        std::atan2(a.way.x() * b.way.y() - a.way.y() * b.way.x(), a.way.dot(b.way));
    squares += std::pow((b.going - a.going) / stair_priors.going_sigma, 2) +
               std::pow(turn / stair_priors.turn_sigma, 2) / std::max(a.steps, b.steps);
  }
  return squares / 2;
}

/** @brief Chains of patches, each a step above the one before. O(p^2) for p patches. */
class StairChains {
public:
  StairChains(const std::vector<LevelPatch>& patches, const RoomFloors& floors)
      : patches_(patches)
      , floors_(floors)
      , is_used_(patches.size(), 0)
  {
    for (std::size_t a = 0; a < patches.size(); ++a)
      for (std::size_t b = a + 1;
           b < patches.size() &&
           patches[b].z - patches[a].z <=
               (stair_priors.max_missing + 1) * stair_priors.max_rise;
           ++b)
        for (int steps = 1; steps <= stair_priors.max_missing + 1; ++steps)
          addSteps(a, b, steps);
    // Patches are by height: of the steps up to a place all before it are known.
    std::stable_sort(
        steps_.begin(), steps_.end(),
        [](const StairStep& a, const StairStep& b) { return a.to < b.to; });
  }

  /** @brief Returns the best chain of patches that no other has, by dynamic
   * programming from below, its odds with its last step; empty if none is more likely
   * than not. */
  std::vector<StairStep> next()
  {
    std::vector<std::vector<std::size_t>> arriving(patches_.size());
    double most = 0;
    std::ptrdiff_t last = -1;
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      StairStep& step = steps_[k];
      if (is_used_[step.from] != 0 || is_used_[step.to] != 0)
        continue;
      const double own =
          stair_priors.step_gain - stair_priors.missing * (step.steps - 1);
      step.odds = own - stair_priors.chain_cost + floorGain(step, true);
      step.before = -1;
      for (const std::size_t o : arriving[step.from])
        if (const double odds = own + steps_[o].odds - change(steps_[o], step);
            odds > step.odds) {
          step.odds = odds;
          step.before = static_cast<std::ptrdiff_t>(o);
        }
      arriving[step.to].push_back(k);
      if (const double odds = step.odds + floorGain(step, false); odds > most) {
        most = odds;
        last = static_cast<std::ptrdiff_t>(k);
      }
    }
    std::vector<StairStep> chain;
    for (; last >= 0; last = steps_[static_cast<std::size_t>(last)].before)
      chain.push_back(steps_[static_cast<std::size_t>(last)]);
    if (!chain.empty())
      chain.front().odds = most;
    std::reverse(chain.begin(), chain.end());
    return chain;
  }

  /** @brief Takes a tread, and what may be its underside, out of further chains. */
  void use(const LevelPatch& tread)
  {
    for (std::size_t p = 0; p < patches_.size(); ++p)
      if (const LevelPatch& patch = patches_[p];
          &patch == &tread ||
          (patch.is_tread && std::abs(patch.z - tread.z) < stair_priors.near &&
           (patch.middle - tread.middle).norm() < stair_priors.near))
        is_used_[p] = 1;
  }

  /** @brief Returns 1 for each patch that was taken out. */
  const std::vector<std::uint8_t>& used() const { return is_used_; }

private:
  void addSteps(std::size_t a, std::size_t b, int steps)
  {
    const LevelPatch& from = patches_[a];
    const LevelPatch& to = patches_[b];
    StairStep step{a, b, steps, (to.z - from.z) / steps};
    if (step.rise < stair_priors.min_rise || step.rise > stair_priors.max_rise ||
        from.box.exteriorDistance(to.box) > steps * stair_priors.max_going ||
        (steps > 1 && !(from.is_tread && to.is_tread)) ||
        floors_.part(from.middle, from.z, to.middle, to.z, steps))
      return;
    step.is_on_treads = from.is_tread && to.is_tread;
    step.way = (to.middle - from.middle).normalized();
    step.going = (to.middle - from.middle).norm() / steps;
    if (!step.is_on_treads ||
        (step.going >= stair_priors.min_going && step.going <= stair_priors.max_going))
      steps_.push_back(step);
  }

  double floorGain(const StairStep& step, bool is_foot) const
  {
    const LevelPatch& patch = patches_[is_foot ? step.from : step.to];
    const double sign = is_foot ? -1 : 1;
    for (const int away : {1, 2})
      if (!patch.is_tread ||
          floors_.near(patch.middle + sign * away * stair_priors.max_going * step.way,
                       patch.z + sign * away * step.rise)
                  .room != 0)
        return stair_priors.floor_gain;
    return 0;
  }

  const std::vector<LevelPatch>& patches_;
  const RoomFloors& floors_;
  std::vector<std::uint8_t> is_used_;
  std::vector<StairStep> steps_; ///< by where they lead to
};

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
      const auto steps = straightSteps(treads, patches, chains.used(), floors,
                                       wallsAround(treads, fine));
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
